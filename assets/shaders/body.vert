// Places one vertex of a body. The shadow map, the bodies and the ground all use it.
#version 330 core

layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 corner_normal;
layout(location = 2) in vec3 body_position;     // m
layout(location = 3) in float bevel;            // m
layout(location = 4) in vec4 body_orientation;  // unit quaternion, body to world
layout(location = 5) in vec3 half_extents;      // m
layout(location = 6) in vec3 body_colour;
layout(location = 7) in float number;           // in the list of bodies

uniform mat4 world_to_clip;

out vec3 position;  // world frame, m
out vec3 normal;
out vec3 colour;

vec3 rotated(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

void main() {
    position = body_position + rotated(body_orientation, corner * (half_extents - bevel) + corner_normal * bevel);
    normal = rotated(body_orientation, corner_normal);
    colour = body_colour;
    gl_Position = world_to_clip * vec4(position, 1.0);
    // Against z-fighting: of overlapping bodies that share a face one is in front everywhere.
    gl_Position.z -= 4e-6 * mod(number, 16.0) * gl_Position.w;
}
