// The sun's light where nothing stands in its way.
#version 330 core

float sun_seen(vec3 position, vec3 normal) { return 1.0; }
