// The ground: a plain colour with a line at each unit and a stronger one at every fifth.
#version 330 core

in vec3 position;
in vec3 normal;
in vec3 colour;

uniform float line_spacing;  // m

out vec4 pixel;

float lines(vec2 point, float width);                            // lines.frag
vec3 lit(vec3 albedo, float gloss, vec3 position, vec3 normal);  // light.frag
vec3 through_haze(vec3 light, vec3 position);                    // haze.frag

void main() {
    vec2 point = position.xz / line_spacing;
    float darkening = max(0.30 * lines(point, 0.025), 0.45 * lines(0.2 * point, 0.009));
    vec3 albedo = colour * (1.0 - darkening);
    pixel = vec4(through_haze(lit(albedo, 0.04, position, normal), position), 0.0);
}
