// A round bar with round ends, and its coverage of a pixel.
#version 330 core

in vec3 position;
in float across;
in float along;
in float half_seen;
in float radius;
in float pixel_side;
in vec3 right;
in vec3 forwards;
in vec3 towards;
in vec3 colour;

out vec4 pixel;

vec3 lit(vec3 albedo, float gloss, vec3 position, vec3 normal);  // light.frag
vec3 through_haze(vec3 light, vec3 position);                    // haze.frag

void main() {
    // From the nearest point of the axis.
    vec2 offset = vec2(across, sign(along) * max(abs(along) - half_seen, 0.0));
    float from_axis = length(offset);
    float coverage = clamp((radius - from_axis) / pixel_side + 0.5, 0.0, 1.0);
    if (coverage <= 0.0) discard;

    vec2 tilt = offset / max(radius, from_axis);
    vec3 normal = right * tilt.x + forwards * tilt.y + towards * sqrt(max(1.0 - dot(tilt, tilt), 0.0));
    vec3 surface = position - offset.x * right - offset.y * forwards + radius * normal;
    pixel = vec4(through_haze(lit(colour, 0.35, surface, normalize(normal)), surface), coverage);
}
