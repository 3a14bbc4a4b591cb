// Of several renderings the sum is exposed, on the CPU.
#version 330 core


// Where rounding makes a base of pow() negative the light is not a number, which a sum would keep.
vec3 exposed(vec3 light) { return isnan(light.r) ? vec3(0.0) : light; }
