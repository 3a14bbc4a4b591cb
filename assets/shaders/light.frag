// The light of the scene: a hemisphere of sky and one warm sun with a shadow. All colours are linear.
#version 330 core

uniform vec3 eye;                   // world frame, m
uniform vec3 towards_sun;           // unit length
uniform sampler2DShadow shadow_map;
uniform mat4 world_to_shadow;       // world to the map's texture coordinates and depth
uniform float shadow_texel;         // side of a texel, m

const vec3 sun_light = 1.25 * vec3(1.0, 0.94, 0.84);
const vec3 sky_light = vec3(0.38, 0.44, 0.54);
const vec3 ground_light = vec3(0.25, 0.235, 0.22);

// The part of the sun's disc that is seen from a point, 0..1: the mean of 3x3 interpolated comparisons. Along
// each axis they weigh four texels with 1-f, 1, 1 and f; two interpolated lookups give the same sum.
float sun_seen(vec3 position, vec3 normal) {
    // A step off the surface, longer than the two texels that the filter reaches, avoids its own shadow. GL
    // clamps the depth of what lies behind all bodies to that of the map's empty texels, which counts as lit.
    vec3 map = (world_to_shadow * vec4(position + 2.5 * shadow_texel * normal, 1.0)).xyz;
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

// Bends bright light towards 1 instead of cutting it off, all channels alike so that the hue stays.
vec3 exposed(vec3 light) {
    const float straight = 0.6;
    float brightest = max(light.r, max(light.g, light.b));
    float excess = max(brightest - straight, 0.0) / (1.0 - straight);
    float bent = min(brightest, straight) + (1.0 - straight) * (1.0 - exp(-excess));
    return light * (bent / max(brightest, 1e-6));
}

// The light that a surface sends to the eye. `gloss` is the strength of its highlight, 0..1.
vec3 lit(vec3 albedo, float gloss, vec3 position, vec3 normal) {
    vec3 towards_eye = normalize(eye - position);
    float facing = max(dot(normal, towards_sun), 0.0);
    vec3 sun = sun_light * sun_seen(position, normal);
    vec3 ambient = mix(ground_light, sky_light, 0.5 + 0.5 * normal.y);

    // Where the normal turns within a pixel, as on distant bevels, a sharp highlight would sparkle.
    vec3 turn = fwidth(normal);
    float spread = 1.0 + 12.0 * dot(turn, turn);
    vec3 halfway = normalize(towards_sun + towards_eye);
    float highlight = facing > 0.0 ? pow(max(dot(normal, halfway), 0.0), 64.0 / spread) / spread : 0.0;
    float rim = pow(1.0 - max(dot(normal, towards_eye), 0.0), 5.0);
    return exposed(albedo * (ambient + sun * facing) + gloss * (sun * highlight + 0.5 * rim * sky_light));
}
