// For the ground itself, and for panels.
#version 330 core

float ground_lost(vec3 position, vec3 normal) { return 0.0; }
