// Haze hides the horizon and the end of the ground.
#version 330 core

uniform vec3 eye;             // world frame, m
uniform vec3 background;      // linear colour
uniform float haze_distance;  // m

// The part of the light that comes through from a point, 0..1.
float transmittance(vec3 position) {
    float depth = distance(eye, position) / haze_distance;
    return exp(-depth * depth);
}

vec3 through_haze(vec3 light, vec3 position) { return mix(background, light, transmittance(position)); }
