// The sun's light with the shadows of bodies, for one of many renderings: each has another sun, and their mean is
// softer than any filter of a single map.
#version 330 core

uniform sampler2DShadow shadow_map;
uniform mat4 world_to_shadow;  // world to the map's texture coordinates and depth
uniform float shadow_texel;    // side of a texel, m

float sun_seen(vec3 position, vec3 normal) {
    // The filter reaches one texel; the offset is a little more.
    vec3 map = (world_to_shadow * vec4(position + 1.5 * shadow_texel * normal, 1.0)).xyz;
    return texture(shadow_map, vec3(map.xy, min(map.z, 1.0)));
}
