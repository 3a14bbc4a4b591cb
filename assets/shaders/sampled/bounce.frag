// The light that the ground sends up, without what bodies hide of it, and darker where the ground is in their shadow.
#version 330 core

uniform sampler2DShadow bounce_map;  // seen from below, against towards_sky
uniform mat4 world_to_bounce;        // world to the map's texture coordinates and depth
uniform float sky_texel;             // side of a texel of this map and that of the sky, m
uniform vec3 towards_sky;            // unit length, upwards
uniform float ground_height;         // m
uniform sampler2DShadow shadow_map;  // of the sun
uniform mat4 world_to_shadow;

// Ground in a shadow has the sky's light only, and is about this bright beside ground in the sun.
const float in_shadow = 0.35;

float ground_lost(vec3 position, vec3 normal) {
    vec3 map = (world_to_bounce * vec4(position + 1.5 * sky_texel * normal, 1.0)).xyz;
    float seen = texture(bounce_map, vec3(map.xy, min(map.z, 1.0)));
    float along = max(position.y - ground_height, 0.0) / max(towards_sky.y, 1e-3);
    vec3 lit = (world_to_shadow * vec4(position - along * towards_sky, 1.0)).xyz;
    float sunny = texture(shadow_map, vec3(lit.xy, min(lit.z, 1.0)));
    return 1.0 - seen * mix(in_shadow, 1.0, sunny);
}
