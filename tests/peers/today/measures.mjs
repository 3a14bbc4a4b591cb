// What is measured of a trajectory.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";

const isMovable = (body) => body.mass_kg !== undefined;
const edge = (scene) => scene.bodies.find(isMovable).size_m[1];
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

// How far the bodies have got from where the scene has them, m: the farthest, of those that are meant.
export const moved = (scene, state, isMeant = () => true) => {
    const start = new Map(scene.bodies.map((body) => [body.name, body.position_m]));
    const of = ({name, position}) => Math.hypot(...position.map((x, i) => x - start.get(name)[i]));
    return Math.max(...state.bodies.filter(isMeant).map((body) => Number.isFinite(of(body)) ? of(body) : Infinity));
};

// The section of a structure of bodies of this size that should stand: whether it does, as in `outcome`, how far its bodies have
// moved and how deep they overlap. What moves before `settled`, s, does not count.
export const structure = ({page, runs, scene, seconds, size, number, isMeant, settled = 0, perSecond = 10, rate}) => {
    page.table(runs.map(({engine, setting, run}) => {
        const trajectory = run(scene, seconds, {perSecond, rate}), end = trajectory.at(-1);
        const from = trajectory.find(({time}) => time >= settled - 1e-6);
        const settledScene = {bodies: from.bodies.map(({name, position}) => ({name, position_m: position}))};
        const distance = moved(settledScene, end, isMeant);
        return {engine, setting: rate && engine.startsWith("MuJoCo") ? "as shipped, at 1/60 s" : setting,
            "at the end": distance <= 0.05 * size ? "stands" : distance <= 0.5 * size ? "sags" : "falls",
            [settled ? `moved after ${settled} s, m` : "moved, m"]: distance, "deepest overlap at the end, m": deepest(page.program, scene, end, page.out),
            shown: page.record(`${engine}, ${setting}`, scene, trajectory, {at: Math.floor(seconds)}), isRight: distance <= 0.05 * size};
    }), number, [settled ? `moved after ${settled} s, m` : "moved, m", "deepest overlap at the end, m"]);
};

// Deepest overlap of any bodies, m, as the program measures it: of a step without forces, speeds and correction.
export const deepest = (program, scene, state, folder) => {
    const file = path.join(folder, "state.json"), csv = path.join(folder, "state.csv");
    const found = new Map(state.bodies.map((body) => [body.name, body]));
    const bodies = scene.bodies.map((body) => isMovable(body) ? {...body, position_m: found.get(body.name).position, orientation_wxyz: unit(found.get(body.name).orientation),
        velocity_m_per_s: undefined, angular_velocity_rad_per_s: undefined} : body);
    fs.writeFileSync(file, JSON.stringify({...scene, gravity_m_per_s2: [0, 0, 0], bodies, options: undefined}));
    execFileSync(program, ["run", file, "--preset", "paper", "--beta", "0", "--seconds", "1/60", "--csv", csv], {stdio: "pipe"});
    const [head, line] = fs.readFileSync(csv, "utf8").split("\n").filter((text) => !text.startsWith("#")).map((text) => text.split(","));
    for (const name of [file, csv]) fs.rmSync(name);
    return Number(line[head.indexOf("max_penetration_m")]);
};

// The words of `outcome` and `standing`, for pages.
export const words = "Stands: every cube within 5 % of its edge of where it belongs. Sags: within half an edge. Crushed, falls: beyond. Explodes: thrown up by more than half an edge.";

const unit = (q) => q.map((x) => x / Math.hypot(...q));
