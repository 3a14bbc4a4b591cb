// The light of sky and ground with what bodies hide of it. Each of several renderings looks in one direction of the
// sky, with a shadow map of its own, and takes away what would come from there; the mean takes away all that is
// hidden, and where nothing is hidden there is no noise.
#version 330 core

uniform sampler2DShadow sky_map;
uniform mat4 world_to_sky;  // world to the map's texture coordinates and depth
uniform float sky_texel;    // side of a texel, m
uniform vec3 towards_sky;   // unit length
uniform float sky_weight;   // irradiance from this direction of a sky of radiance 1, divided by pi, in its normal plane

// The part of the ground's light that does not come from the opposite direction.
float ground_lost(vec3 position, vec3 normal);  // bounce.frag or no_bounce.frag

// Bodies that hide the sky send light too: as if they had the colour of what they shade, and were lit this much.
const float returned = 0.25;

float hidden;  // of the sky in this direction, from the point of the last call of surroundings()

vec3 surroundings(vec3 sky_light, vec3 ground_light, vec3 albedo, vec3 position, vec3 normal) {
    // The filter reaches one texel; the offset is a little more.
    vec3 map = (world_to_sky * vec4(position + 1.5 * sky_texel * normal, 1.0)).xyz;
    hidden = 1.0 - texture(sky_map, vec3(map.xy, min(map.z, 1.0)));
    float facing = sky_weight * max(dot(normal, towards_sky), 0.0);
    float opposite = sky_weight * max(-dot(normal, towards_sky), 0.0);
    vec3 lost = sky_light * facing * hidden + ground_light * opposite * ground_lost(position, normal);
    return mix(ground_light, sky_light, 0.5 + 0.5 * normal.y) - lost * (1.0 - returned * albedo);
}

vec3 along_surface(vec3 sky_light) { return (1.0 - hidden) * sky_light; }
