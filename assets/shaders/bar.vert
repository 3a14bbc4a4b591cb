// Places one corner of a rectangle around a bar that faces the viewer. The shadow map and the bars use it.
#version 330 core

layout(location = 0) in vec3 corner;            // x: across the bar, z: along it; -1 or 1
layout(location = 2) in vec3 body_position;     // m
layout(location = 3) in float true_radius;      // m
layout(location = 4) in vec4 body_orientation;  // unit quaternion, body to world; the bar lies along y
layout(location = 5) in vec3 half_extents;      // m; y: half of the length with the round ends
layout(location = 6) in vec3 body_colour;

uniform mat4 world_to_clip;
uniform vec3 viewer;         // the eye, world frame, m; or the direction towards a viewer at infinity
uniform bool parallel;       // whether it is a direction
uniform float least_radius;  // m at a distance of 1 m: keeps bars wider than a pixel
uniform float margin;        // m at a distance of 1 m, around the bar

out vec3 position;     // on the rectangle, which the bar's axis lies in, world frame, m
out float across;      // from the axis, m
out float along;       // from the middle, m
out float half_seen;   // half of the length without the ends, as the viewer sees it, m
out float radius;      // m
out float pixel_side;  // the margin, m
out vec3 right;        // unit vectors: across,
out vec3 forwards;     // along,
out vec3 towards;      // and to the viewer
out vec3 colour;

vec3 rotated(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

void main() {
    vec3 axis = rotated(body_orientation, vec3(0.0, 1.0, 0.0));
    float half_length = half_extents.y - true_radius;
    vec3 end = body_position + corner.z * half_length * axis;
    towards = normalize(parallel ? viewer : viewer - end);
    right = cross(axis, towards);
    float slant = length(right);
    // A bar that points at the viewer is a disc.
    if (slant < 1e-4) right = cross(abs(towards.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), towards);
    right = normalize(right);
    forwards = cross(towards, right);

    float distance = (world_to_clip * vec4(end, 1.0)).w;  // 1 in parallel light
    radius = max(true_radius, least_radius * distance);
    pixel_side = margin * distance;
    float reach = radius + pixel_side;
    half_seen = slant * half_length;
    across = corner.x * reach;
    along = corner.z * (half_seen + reach);
    position = end + across * right + corner.z * reach * forwards;
    colour = body_colour;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
