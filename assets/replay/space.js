// Vectors [x, y, z], quaternions [w, x, y, z] and matrices of 16 numbers, column by column. World frame, y up, m.
const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const times = (k, a) => [k * a[0], k * a[1], k * a[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => times(1 / norm(a), a);
const clamp = (x, low, high) => Math.min(Math.max(x, low), high);
const radians = (degrees) => degrees * Math.PI / 180;

const rotated = (q, v) => {
    const axis = [q[1], q[2], q[3]];
    return add(v, times(2, cross(axis, add(cross(axis, v), times(q[0], v)))));
};
const conjugate = (q) => [q[0], -q[1], -q[2], -q[3]];

// The vector at right angles that Eigen's unitOrthogonal() gives: springs bend the same way in pictures and pages.
const orthogonal = (v) => {
    const small = (x, y) => Math.abs(x) <= 1e-12 * Math.abs(y);
    if (!small(v[0], v[2]) || !small(v[1], v[2])) {
        const k = 1 / Math.hypot(v[0], v[1]);
        return [-v[1] * k, v[0] * k, 0];
    }
    const k = 1 / Math.hypot(v[1], v[2]);
    return [0, -v[2] * k, v[1] * k];
};

const product = (a, b) => {
    const m = new Float64Array(16);
    for (let column = 0; column < 4; ++column) {
        for (let row = 0; row < 4; ++row) {
            let sum = 0;
            for (let k = 0; k < 4; ++k) sum += a[4 * k + row] * b[4 * column + k];
            m[4 * column + row] = sum;
        }
    }
    return m;
};
// [x, y, z, w]
const transformed = (m, v, w = 1) => [0, 1, 2, 3].map((row) => m[row] * v[0] + m[4 + row] * v[1] + m[8 + row] * v[2] + m[12 + row] * w);

// Up on the screen: y, except when looking along it.
const screenUp = (direction) => Math.abs(unit(direction)[1]) > 0.999 ? [0, 0, -1] : [0, 1, 0];

const lookAt = (eye, target) => {
    const forward = unit(minus(target, eye));
    const right = unit(cross(forward, screenUp(forward)));
    const up = cross(right, forward);
    return Float64Array.of(right[0], up[0], -forward[0], 0, right[1], up[1], -forward[1], 0, right[2], up[2], -forward[2], 0,
        -dot(right, eye), -dot(up, eye), dot(forward, eye), 1);
};
const perspective = (degrees, aspect, near, far) => {
    const t = Math.tan(radians(0.5 * degrees));
    return Float64Array.of(1 / (aspect * t), 0, 0, 0, 0, 1 / t, 0, 0, 0, 0, -(far + near) / (far - near), -1,
        0, 0, -2 * far * near / (far - near), 0);
};
const parallel = (left, right, bottom, top, near, far) => Float64Array.of(2 / (right - left), 0, 0, 0, 0, 2 / (top - bottom), 0, 0,
    0, 0, -2 / (far - near), 0, -(right + left) / (right - left), -(top + bottom) / (top - bottom), -(far + near) / (far - near), 1);

const linearLight = (srgb) => srgb.map((c) => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
