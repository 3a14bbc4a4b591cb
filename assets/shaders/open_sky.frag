// The light of sky and ground where nothing hides them.
#version 330 core

vec3 surroundings(vec3 sky_light, vec3 ground_light, vec3 albedo, vec3 position, vec3 normal) {
    return mix(ground_light, sky_light, 0.5 + 0.5 * normal.y);
}

vec3 along_surface(vec3 sky_light) { return sky_light; }
