// The cases: a scene, how long, and what is measured of a trajectory.
import {execFileSync} from "node:child_process";

export const sceneOf = (program, ...words) => JSON.parse(execFileSync(program, ["scene", ...words], {encoding: "utf8"}));

const edge = (scene) => scene.bodies.find((body) => body.mass_kg !== undefined).size_m[1];
const heights = (state) => state.bodies.map(({position}) => position[1]);

// Of a stack whose cubes are listed from the ground up: the deepest overlap of neighbours, or of the lowest with the ground,
// measured between centres; none between cubes that have left the stack.
const overlap = (scene, state) => {
    const size = edge(scene);
    let last = null, deepest = 0;
    for (const {position} of state.bodies) {
        const gap = last === null ? position[1] - size / 2 : position[1] - last[1] - size;
        const aside = last === null ? 0 : Math.hypot(position[0] - last[0], position[2] - last[2]);
        if (aside < size / 2) deepest = Math.max(deepest, -gap);
        last = position;
    }
    return deepest;
};

// What became of a stack that should stand: its cubes where they belong, pressed into each other, fallen or thrown.
export const outcome = (scene, trajectory) => {
    const size = edge(scene), end = trajectory.at(-1);
    const right = end.bodies.map((_, i) => (i + 0.5) * size);
    let highest = 0;
    for (const state of trajectory) {
        const now = heights(state);
        if (!now.every(Number.isFinite)) return "explodes";
        now.forEach((y, i) => { highest = Math.max(highest, y - right[i]); });
    }
    if (highest > 0.5 * size) return "explodes";
    const off = end.bodies.map(({position}, i) => [Math.abs(position[1] - right[i]), Math.hypot(position[0], position[2])]);
    if (off.some(([down, aside]) => down > 0.5 * size || aside > 0.5 * size)) return overlap(scene, end) > 0.3 * size ? "crushed" : "falls";
    if (off.some(([down, aside]) => down > 0.05 * size || aside > 0.05 * size)) return "sags";
    return "stands";
};

// Cubes of 1 m and 1 kg, one on the other and touching; the topmost is heavier.
export const stack = (count, ratio) => ({
    version: 1, name: `stack of ${count}, topmost ${ratio} times as heavy`, gravity_m_per_s2: [0, -10, 0], contacts: true,
    bodies: [{name: "ground", shape: "plane", position_m: [0, 0, 0], orientation_wxyz: [1, 0, 0, 0], friction: 0.5},
        ...Array.from({length: count}, (_, i) => ({name: `cube ${i + 1}`, shape: "box", size_m: [1, 1, 1], mass_kg: i + 1 === count ? ratio : 1,
            position_m: [0, i + 0.5, 0], orientation_wxyz: [1, 0, 0, 0], friction: 0.5}))],
});

export const flight = (scene, trajectory) => {
    const until = (time) => trajectory.filter((state) => state.time <= time + 1e-6);
    const upwards = (state) => Math.max(...state.bodies.map(({velocity}) => velocity[1]));
    const at = (time) => until(time).at(-1);
    return {
        "greatest stored speed upwards, m/s": Math.max(0, ...trajectory.map(upwards)),
        "at 0.5 s, m/s": Math.max(0, upwards(at(0.5))),
        "overlap at 0.5 s, m": overlap(scene, at(0.5)),
        "overlap at 2 s, m": overlap(scene, at(2)),
        "topmost cube at 0.5 s, m": heights(at(0.5)).at(-1),
    };
};
export const depth = (scene, trajectory) => overlap(scene, trajectory.at(-1));
