// A smooth body with alternating light and dark octants, so that its rotation is visible.
#version 330 core

in vec3 position;
in vec3 normal;
in vec3 direction;
in vec3 colour;
flat in float drawn_radius;  // m

out vec4 pixel;

vec3 lit(vec3 albedo, float gloss, vec3 position, vec3 normal);  // light.frag
vec3 through_haze(vec3 light, vec3 position);                    // haze.frag

const float darkening = 0.30;  // of the dark octants

void main() {
    // -1 or 1 beside each plane between octants, in between on the pixel that it crosses.
    vec3 side = clamp(2.0 * direction / max(fwidth(direction), 1e-6), -1.0, 1.0);
    float dark = 0.5 - 0.5 * side.x * side.y * side.z;
    vec3 albedo = colour * (1.0 - darkening * dark);
    // Triangles lie a little inside the sphere; there they would be in its own shadow.
    vec3 outwards = normalize(normal);
    vec3 on_sphere = position + drawn_radius * (outwards - normal);
    pixel = vec4(through_haze(lit(albedo, 0.35, on_sphere, outwards), position), 1.0);
}
