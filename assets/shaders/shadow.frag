// The sun's light with the shadows of bodies.
#version 330 core

uniform sampler2DShadow shadow_map;
uniform mat4 world_to_shadow;  // world to the map's texture coordinates and depth
uniform float shadow_texel;    // side of a texel, m

// The part of the sun's disc that is seen from a point, 0..1: the mean of 3x3 interpolated comparisons. Along
// each axis they weigh four texels with 1-f, 1, 1 and f; two interpolated lookups give the same sum.
float sun_seen(vec3 position, vec3 normal) {
    // An offset from the surface, longer than the two texels that the filter reaches, avoids self-shadowing.
    vec3 map = (world_to_shadow * vec4(position + 2.5 * shadow_texel * normal, 1.0)).xyz;
    // What lies behind all bodies has the depth of the map's empty texels, which counts as lit. GL clamps it by itself,
    // but not all of WebGL does.
    map.z = min(map.z, 1.0);
    vec2 size = vec2(textureSize(shadow_map, 0));
    vec2 texel = map.xy * size - 0.5;
    vec2 f = fract(texel);
    vec2 first = (floor(texel) - 0.5 + 1.0 / (2.0 - f)) / size;
    vec2 second = (floor(texel) + 1.5 + f / (1.0 + f)) / size;
    vec2 first_weight = (2.0 - f) / 3.0;
    vec2 second_weight = (1.0 + f) / 3.0;
    return first_weight.y * (first_weight.x * texture(shadow_map, vec3(first, map.z)) +
                             second_weight.x * texture(shadow_map, vec3(second.x, first.y, map.z))) +
           second_weight.y * (first_weight.x * texture(shadow_map, vec3(first.x, second.y, map.z)) +
                              second_weight.x * texture(shadow_map, vec3(second, map.z)));
}
