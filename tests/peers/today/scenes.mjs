// Scenes that are compared. Those that others publish are rebuilt from the numbers of their sources.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";

export const sceneOf = (program, ...words) => JSON.parse(execFileSync(program, ["scene", ...words], {encoding: "utf8", maxBuffer: 1 << 28}));

const gravity = [0, -10, 0];  // m/s^2, in all of them
const upright = [1, 0, 0, 0];
const aboutZ = (angle) => [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)];
const onGround = (name, friction, bodies) => ({
    version: 1, name, gravity_m_per_s2: gravity, contacts: true,
    bodies: [{name: "ground", shape: "plane", position_m: [0, 0, 0], orientation_wxyz: upright, friction},
        ...bodies.map((body) => ({orientation_wxyz: upright, friction, ...body}))],
});
const box = (name, size, mass, position, more) => ({name, shape: "box", size_m: size, mass_kg: mass, position_m: position, ...more});
const range = (count) => Array.from({length: count}, (_, i) => i);

// Cubes of 1 m and 1 kg, one on the other, each by `overlap` inside what is below it; the topmost is heavier.
export const stack = (count, ratio, overlap = 0) => onGround(`stack of ${count}, topmost ${ratio} times as heavy, overlap ${overlap}`, 0.5,
    range(count).map((i) => box(`cube ${i + 1}`, [1, 1, 1], i + 1 === count ? ratio : 1, [0, 0.5 + i - (i + 1) * overlap, 0])));

// Box3D, shared/benchmarks.c, CreateLargePyramid: cubes of 1 m and 100 kg, `base` of them at the bottom.
export const pyramid = (base) => onGround(`pyramid of ${base}`, 0.6, range(base).flatMap((i) =>
    range(base - i).map((j) => box(`row ${i + 1}, cube ${j + 1}`, [1, 1, 1], 100, [(i + 1) / 2 + j - base / 2, i + 0.5, 0]))));

// Box3D, shared/benchmarks.c, CreateConvexPile: layers of 8 x 8 hulls of 32 random points on a ball of 2 m, who start as close as
// their balls. The program turns each into its principal axes, so that an origin is a centre of mass everywhere.
export const heap = (program, layers, folder) => {
    let random = 42;
    const next = () => {
        random = (Math.imul(random, 2147001325) + 715136305) >>> 0;
        return (random & 0xffff) / 65535 - 0.5;
    };
    const point = () => {
        for (;;) {
            const found = [next(), next(), next()], length = Math.hypot(...found);
            if (length <= 0.5) return found.map((x) => 2 * x / length);
        }
    };
    const points = range(32).map(point), file = path.join(folder, "heap.json");
    const bodies = range(layers).flatMap((y) => range(8).flatMap((z) => range(8).map((x) => ({
        name: `layer ${y + 1}, row ${z + 1}, hull ${x + 1}`, shape: "polyhedron", points_m: points, density_kg_per_m3: 1000,
        position_m: [4 * (x - 4), 2 + 4 * y, 4 * (z - 4)],
    }))));
    fs.writeFileSync(file, JSON.stringify(onGround(`heap of ${bodies.length} hulls`, 0.6, bodies)));
    const scene = sceneOf(program, file);
    fs.rmSync(file);
    return scene;
};

// Solver2D, samples/collection/sample_contact.cpp, CardHouse (its own source is PEEL): cards of 2 mm and 0.4 m, leaning by 25
// degrees, in five storeys; those that lie overlap their neighbours, those below the ground. Here they are 0.4 m wide.
export const cardHouse = () => {
    const cards = [], half = 0.2, thickness = 0.002, lean = 25 * Math.PI / 180;
    const card = (kind, x, y, angle) => cards.push(box(`${kind} ${cards.length + 1}`, [thickness, 2 * half, 2 * half], 2 * half * thickness, [x, y, 0], {orientation_wxyz: aboutZ(angle)}));
    let left = 0, y = half - 0.02;
    for (let count = 5; count > 0; --count, y += 2 * half - 0.03, left += 0.175) {
        range(count).forEach((i) => {
            const x = left + 0.35 * i;
            if (i + 1 < count) card("lying", x + 0.25, y + half - 0.015, Math.PI / 2);
            card("leaning", x, y, -lean);
            card("leaning", x + 0.175, y, lean);
        });
    }
    return onGround("card house", 0.7, cards);
};

// Box3D, samples/sample_robustness.cpp, and Solver2D, sample_contact.cpp, High Mass Ratio 1: three pyramids of cubes of 2 m and 8
// kg; the topmost, 2 m above the rest, are 100, 200 and 300 times as heavy.
export const heavyTops = () => onGround("pyramids with heavy tops", 0.6, range(3).flatMap((j) => range(10).flatMap((row) => range(10 - row).map((i) =>
    box(`${row === 9 ? "top" : "cube"} ${j + 1} ${row + 1} ${i + 1}`, [2, 2, 2], row === 9 ? 800 * (j + 1) : 8,
        [2 * i - (10 - row) - 20 + 22 * j, 2 * row + 1 + (row === 9 ? 2 : 0), 0])))));

// Solver2D, sample_contact.cpp, High Mass Ratio 2: a box of 20 m falls by 15 m on two of 1 m, 400 times lighter. Here all are 20 m deep.
export const heavyBox = () => onGround("big box on small boxes", 0.6, [box("left", [1, 1, 20], 20, [-9, 0.5, 0]), box("right", [1, 1, 20], 20, [9, 0.5, 0]),
    box("big", [20, 20, 20], 8000, [0, 26, 0])]);
