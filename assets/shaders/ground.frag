// The ground: a plain colour with lines at each unit and stronger ones at every fifth.
#version 330 core

in vec3 position;
in vec3 normal;
in vec3 colour;

uniform float line_spacing;  // m

out vec4 pixel;

vec3 lit(vec3 albedo, float gloss, vec3 position, vec3 normal);  // light.frag
vec3 through_haze(vec3 light, vec3 position);                    // haze.frag

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

void main() {
    vec2 point = position.xz / line_spacing;
    float darkening = max(0.30 * lines(point, 0.025), 0.45 * lines(0.2 * point, 0.009));
    vec3 albedo = colour * (1.0 - darkening);
    pixel = vec4(through_haze(lit(albedo, 0.04, position, normal), position), 1.0);
}
