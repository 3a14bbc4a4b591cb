// A square on the ground below a body, as large as the area that the body can darken.
#version 330 core

layout(location = 0) in vec3 corner;
layout(location = 2) in vec3 body_position;     // m
layout(location = 3) in float bevel;            // m
layout(location = 4) in vec4 body_orientation;  // unit quaternion, body to world
layout(location = 5) in vec3 half_extents;      // m

uniform mat4 world_to_clip;
uniform float ground_height;  // m

out vec3 position;     // world frame, m
out vec3 local;        // the same point in the body's frame
flat out vec3 core;    // half extents without the bevel
flat out float bevel_radius;  // the bevel
flat out float reach;  // how far from the body the darkening ends, m

void main() {
    reach = min(half_extents.x, min(half_extents.y, half_extents.z));
    core = half_extents - bevel;
    bevel_radius = bevel;

    vec3 below = vec3(body_position.x, ground_height, body_position.z);
    position = below + corner * (length(half_extents) + reach);
    vec3 offset = position - body_position;
    vec3 inverse_axis = -body_orientation.xyz;
    local = offset + 2.0 * cross(inverse_axis, cross(inverse_axis, offset) + body_orientation.w * offset);
    gl_Position = world_to_clip * vec4(position, 1.0);
}
