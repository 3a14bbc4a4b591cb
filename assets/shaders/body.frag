#version 330 core

in vec3 position;
in vec3 normal;
in vec3 colour;

out vec4 pixel;

vec3 lit(vec3 albedo, float gloss, vec3 position, vec3 normal);  // light.frag
vec3 through_haze(vec3 light, vec3 position);                    // haze.frag

void main() {
    pixel = vec4(through_haze(lit(colour, 0.35, position, normalize(normal)), position), 1.0);
}
