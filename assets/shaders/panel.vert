// Passes on one vertex of a translucent panel.
#version 330 core

layout(location = 0) in vec3 vertex_position;  // world frame, m
layout(location = 1) in vec3 vertex_normal;
layout(location = 2) in vec3 vertex_colour;
layout(location = 3) in float vertex_opacity;
layout(location = 4) in float vertex_from_edge;  // m
layout(location = 5) in vec2 vertex_in_plane;    // m

uniform mat4 world_to_clip;

out vec3 position;
out vec3 normal;
out vec3 colour;
out float opacity;
out float from_edge;
out vec2 in_plane;

void main() {
    position = vertex_position;
    normal = vertex_normal;
    colour = vertex_colour;
    opacity = vertex_opacity;
    from_edge = vertex_from_edge;
    in_plane = vertex_in_plane;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
