// Ambient occlusion of the ground by a body: strongest where it touches, zero beyond its reach. The result is
// multiplied onto the ground.
#version 330 core

in vec3 position;
in vec3 local;
flat in vec3 core;
flat in float bevel_radius;
flat in float reach;

out vec4 factor;

float transmittance(vec3 position);  // haze.frag

void main() {
    float gap = length(max(abs(local) - core, 0.0)) - bevel_radius;
    float closeness = clamp(1.0 - gap / reach, 0.0, 1.0);
    float darkening = 0.45 * closeness * closeness * transmittance(position);
    factor = vec4(vec3(1.0 - darkening), 1.0);
}
