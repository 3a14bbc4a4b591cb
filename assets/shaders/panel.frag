// A translucent panel: its light and its opacity.
#version 330 core

in vec3 position;
in vec3 normal;
in vec3 colour;
in float opacity;
in float from_edge;  // m
in vec2 in_plane;    // m

uniform vec3 towards_sun;    // unit length
uniform float line_spacing;  // m

out vec4 pixel;

float lines(vec2 point, float width);                            // lines.frag
vec3 lit(vec3 albedo, float gloss, vec3 position, vec3 normal);  // light.frag
vec3 through_haze(vec3 light, vec3 position);                    // haze.frag

const float outline_width = 1.8;  // pixels
const float outline_opacity = 0.8;
const float line_opacity = 0.25;
const vec3 line_light = vec3(1.0);
const float back = 0.35;          // opacity of the back as a share of the front's

void main() {
    float outline = clamp(outline_width - from_edge / max(fwidth(from_edge), 1e-6), 0.0, 1.0);
    float line = lines(in_plane / line_spacing, 0.02);
    float side = gl_FrontFacing ? 1.0 : back;

    // Light shines through: both sides are as bright as the one that faces the sun.
    vec3 sunward = dot(normal, towards_sun) < 0.0 ? -normal : normal;
    vec3 light = lit(colour, 0.0, position, sunward);
    float drawn = max(outline_opacity * outline, line_opacity * line * side);
    float hiding = mix(side * opacity, 1.0, drawn);
    // The lines' share in the mixture with what they cover.
    light = mix(light, line_light, drawn / max(hiding, 1e-6));
    pixel = vec4(through_haze(light, position), hiding);
}
