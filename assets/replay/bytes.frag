// The drawn picture as the sRGB bytes that it is stored in: reading an sRGB texture gives linear light.
#version 330 core

uniform sampler2D drawn;

out vec4 pixel;

void main() {
    vec4 light = texelFetch(drawn, ivec2(gl_FragCoord.xy), 0);
    vec3 srgb = mix(12.92 * light.rgb, 1.055 * pow(light.rgb, vec3(1.0 / 2.4)) - 0.055,
                    vec3(greaterThan(light.rgb, vec3(0.0031308))));
    pixel = vec4(srgb, light.a);
}
