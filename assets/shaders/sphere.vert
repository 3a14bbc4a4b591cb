// Places one vertex of a sphere. Only the half that faces the viewer is drawn, and its corners do not turn with
// the body: the outline is equally round from everywhere and does not waver when the sphere rolls.
#version 330 core

layout(location = 1) in vec3 dome;              // point of a unit half sphere around +z, which faces the viewer
layout(location = 2) in vec3 body_position;     // m
layout(location = 3) in float radius;           // m
layout(location = 4) in vec4 body_orientation;  // unit quaternion, body to world
layout(location = 6) in vec3 body_colour;

uniform mat4 world_to_clip;
uniform vec3 viewer;    // the eye, world frame, m; or the direction towards a viewer at infinity
uniform bool parallel;  // whether it is a direction

out vec3 position;   // world frame, m
out vec3 normal;
out vec3 direction;  // the normal in the body's frame
out vec3 colour;
flat out float drawn_radius;  // the radius

void main() {
    vec3 towards = normalize(parallel ? viewer : viewer - body_position);
    vec3 right = normalize(cross(abs(towards.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), towards));
    vec3 up = cross(towards, right);
    normal = right * dome.x + up * dome.y + towards * dome.z;
    position = body_position + radius * normal;
    vec3 inverse_axis = -body_orientation.xyz;
    direction = normal + 2.0 * cross(inverse_axis, cross(inverse_axis, normal) + body_orientation.w * normal);
    colour = body_colour;
    drawn_radius = radius;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
