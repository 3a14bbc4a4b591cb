// Places one vertex of a sphere: only the half that is seen is drawn, and its rim is the outline, which thus is
// equally round from everywhere and does not waver when the sphere turns.
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
    vec3 offset = parallel ? viewer : viewer - body_position;
    vec3 towards = normalize(offset);
    vec3 right = normalize(cross(abs(towards.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), towards));
    vec3 up = cross(towards, right);

    // From nearby less than a half is seen: the rim moves up to where lines of sight touch the sphere.
    float rim = parallel ? 0.0 : min(radius / length(offset), 1.0);
    float height = mix(rim, 1.0, dome.z);
    vec2 across = dome.xy * sqrt((1.0 - height * height) / max(dot(dome.xy, dome.xy), 1e-12));
    normal = right * across.x + up * across.y + towards * height;

    position = body_position + radius * normal;
    vec3 inverse_axis = -body_orientation.xyz;
    direction = normal + 2.0 * cross(inverse_axis, cross(inverse_axis, normal) + body_orientation.w * normal);
    colour = body_colour;
    drawn_radius = radius;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
