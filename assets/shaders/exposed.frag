// The exposure of a picture that is rendered once. images/exposure.cpp has the same for the sum of several.
#version 330 core

// Bends bright light towards 1 instead of cutting it off, all channels alike so that the hue stays.
vec3 exposed(vec3 light) {
    const float straight = 0.6;
    float brightest = max(light.r, max(light.g, light.b));
    float excess = max(brightest - straight, 0.0) / (1.0 - straight);
    float bent = min(brightest, straight) + (1.0 - straight) * (1.0 - exp(-excess));
    return light * (bent / max(brightest, 1e-6));
}
