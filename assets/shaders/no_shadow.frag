// The sun's light without a shadow map.
#version 330 core

float sun_seen(vec3 position, vec3 normal) { return 1.0; }
