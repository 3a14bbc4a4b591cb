// Smooth edges: the counterpart of renderer/images/smoothing.cpp, which has the comments.
#version 330 core

uniform sampler2D picture;  // sRGB bytes; alpha: whether edges are smoothed here
uniform ivec2 size;         // pixels
uniform ivec2 origin;       // of the picture on the page, pixels

out vec4 pixel;

const int longest_walk = 12;
const int most_run_on = 3;

ivec2 place;   // of the pixel
ivec2 across;  // towards its neighbour
int own;       // brightness
int rise;      // of the neighbour's brightness
int walked;    // pixels, up to the end of the step
int turn;      // side that continues there: 1 the neighbour's, -1 the pixel's own, 0 neither

vec4 stored(ivec2 offset) { return texelFetch(picture, place + offset, 0); }

int at(ivec2 offset) {
    ivec3 bytes = ivec3(255.0 * stored(offset).rgb + 0.5);
    return (77 * bytes.r + 150 * bytes.g + 29 * bytes.b) >> 8;
}

bool is_marked(ivec2 offset) { return stored(offset).a > 0.0; }

int bend(ivec2 offset, ivec2 direction) { return abs(at(offset + direction) + at(offset - direction) - 2 * at(offset)); }

bool is_own(ivec2 offset) { return 2 * abs(at(offset) - own) < abs(rise); }

void follow(ivec2 along, int most) {
    walked = most + 1;
    turn = 0;
    for (int pixels = 1; pixels <= longest_walk; ++pixels) {
        if (pixels > most) return;
        ivec2 there = pixels * along;
        int beyond = at(there) + at(there + across) - (2 * own + rise);
        if (2 * abs(beyond) < abs(rise)) continue;
        walked = pixels;
        turn = (beyond > 0) == (rise > 0) ? (is_own(there - across) ? 1 : 0) : (is_own(there + 2 * across) ? 0 : -1);
        return;
    }
}

bool runs_on(ivec2 there, ivec2 along, int pixels) {
    for (int i = 1; i <= most_run_on; ++i) {
        if (i > pixels) return true;
        there += along;
        if (is_own(there) || !is_own(there - across)) return false;
    }
    return true;
}

float share_of_neighbour(ivec2 along, int before, int after) {
    follow(-along, min(before - most_run_on, longest_walk));
    int back = walked, back_turn = turn;
    follow(along, min(after - most_run_on, longest_walk));
    int forth = walked, forth_turn = turn;
    bool is_back = back < forth;
    if ((is_back ? back_turn : forth_turn) <= 0) return 0.0;
    ivec2 onward = is_back ? -along : along;
    int nearer = is_back ? back : forth;
    if (!runs_on(nearer * onward, onward, min((back + forth) / 4, most_run_on))) return 0.0;
    float to_nearer = float(nearer) - 0.5;
    return max(0.5 - to_nearer / (float(back + forth) - 1.0), 0.0);
}

vec3 light_of(vec3 srgb) {
    return mix(srgb / 12.92, pow((srgb + 0.055) / 1.055, vec3(2.4)), vec3(greaterThan(srgb, vec3(0.04045))));
}

vec3 bytes_of(vec3 light) {
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, vec3(greaterThan(light, vec3(0.0031308))));
}

void main() {
    place = ivec2(gl_FragCoord.xy) - origin;
    vec4 drawn = stored(ivec2(0));
    pixel = vec4(drawn.rgb, 1.0);
    const int border = 2;
    if (min(place.x, place.y) < border || place.x >= size.x - border || place.y >= size.y - border) return;

    ivec2 right = ivec2(1, 0), above = ivec2(0, 1);
    own = at(ivec2(0));
    int n = at(above), s = at(-above), e = at(right), w = at(-right);
    int least = min(own, min(min(n, s), min(e, w)));
    int most = max(own, max(max(n, s), max(e, w)));
    if (most - least < max(6, most / 16)) return;
    bool level = 2 * bend(ivec2(0), above) + bend(right, above) + bend(-right, above) >=
                 2 * bend(ivec2(0), right) + bend(above, right) + bend(-above, right);
    ivec2 along = level ? right : above;
    ivec2 up = level ? above : right;
    across = abs(at(up) - own) >= abs(at(-up) - own) ? up : -up;
    if (drawn.a == 0.0 && !is_marked(across)) return;
    rise = at(across) - own;
    int before = level ? place.x : place.y;
    int after = (level ? size.x : size.y) - 1 - before;
    float share = share_of_neighbour(along, before, after);
    if (share > 0.0) pixel.rgb = bytes_of(mix(light_of(drawn.rgb), light_of(stored(across).rgb), share));
}
