// Antialiased lines at the integers of both coordinates, for the ground and the panels.
#version 330 core

// The length of [0, x] that is covered by lines of this width at the integers, taking each from its left end.
vec2 covered(vec2 x, float width) { return floor(x) * width + min(fract(x), width); }

// The part of the pixel that lines of this width (in units of their spacing) cover: exact along each axis,
// and only their mean where they are too close to be told apart.
float lines(vec2 point, float width) {
    vec2 footprint = max(fwidth(point), 1e-4);
    vec2 start = point + 0.5 * (width - footprint);
    vec2 coverage = (covered(start + footprint, width) - covered(start, width)) / footprint;
    coverage = mix(coverage, vec2(width), smoothstep(0.25, 0.75, footprint));
    return 1.0 - (1.0 - coverage.x) * (1.0 - coverage.y);
}
