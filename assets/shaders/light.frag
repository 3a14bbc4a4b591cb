// The light of the scene: a hemisphere of sky and one warm sun. All colours are linear.
#version 330 core

uniform vec3 eye;          // world frame, m
uniform vec3 towards_sun;  // unit length

// The visible share of the sun's disc from a point, 0..1.
float sun_seen(vec3 position, vec3 normal);  // shadow.frag or no_shadow.frag

const vec3 sun_light = 1.25 * vec3(1.0, 0.94, 0.84);
const vec3 sky_light = vec3(0.38, 0.44, 0.54);
const vec3 ground_light = vec3(0.25, 0.235, 0.22);

// How much of the sun's light is the sun's, 0..1; the sky has what the ground then lacks.
uniform float sun_share;

// open_sky.frag or sampled/sky.frag: the light of sky and ground on a surface; and then, what of the sky's light comes
// along the surface.
vec3 surroundings(vec3 sky_light, vec3 ground_light, vec3 albedo, vec3 position, vec3 normal);
vec3 along_surface(vec3 sky_light);
vec3 exposed(vec3 light);  // exposed.frag or sampled/unexposed.frag

// The light that a surface sends to the eye. `gloss` is the strength of its highlight, 0..1.
vec3 lit(vec3 albedo, float gloss, vec3 position, vec3 normal) {
    vec3 towards_eye = normalize(eye - position);
    float facing = max(dot(normal, towards_sun), 0.0);
    vec3 sun = sun_share * sun_light * sun_seen(position, normal);
    vec3 sky = sky_light + (1.0 - sun_share) * max(towards_sun.y, 0.0) * sun_light;
    vec3 ambient = surroundings(sky, ground_light, albedo, position, normal);

    // Where the normal turns within a pixel, as on distant bevels, a sharp highlight would sparkle.
    vec3 turn = fwidth(normal);
    float spread = 1.0 + 12.0 * dot(turn, turn);
    vec3 halfway = normalize(towards_sun + towards_eye);
    float highlight = facing > 0.0 ? pow(max(dot(normal, halfway), 0.0), 64.0 / spread) / spread : 0.0;
    float rim = pow(1.0 - max(dot(normal, towards_eye), 0.0), 5.0);
    return exposed(albedo * (ambient + sun * facing) + gloss * (sun * highlight + 0.5 * rim * along_surface(sky_light)));
}
