// node main.mjs PACKAGES PROGRAM ASSETS OUT [CASE...]   cases: figure_07 mass-ratios atlas, all of them if none is named
// Writes OUT/index.html with tables, pictures and replays, and OUT/today.csv; prints the tables.
import fs from "node:fs";
import path from "node:path";
import {pathToFileURL} from "node:url";
import {flight, outcome, depth, sceneOf, stack} from "./cases.mjs";
import {engines} from "./engines.mjs";
import {Page} from "./page.mjs";
import {ourTrajectory, trajectoryOf} from "./runs.mjs";

const [packages, program, assets, out, ...wanted] = process.argv.slice(2);
const cases = ["figure_07", "mass-ratios", "atlas"];
const unknown = wanted.find((name) => !cases.includes(name));
if (unknown) {
    console.error(`tests/compare today ${unknown}: must be one of ${cases.join(", ")}`);
    process.exit(2);
}
const isWanted = (name) => !wanted.length || wanted.includes(name);
fs.mkdirSync(out, {recursive: true});

// An engine whose package is missing is left out.
const loaded = [];
for (const [name, load] of Object.entries(engines)) {
    try {
        loaded.push(await load(pathToFileURL(path.resolve(packages) + "/").href));
    } catch (error) {
        console.error(`${name}: left out: ${String(error.message).split("\n")[0]}`);
    }
}

// This engine and the others as they are compared: {engine, setting, run(scene, seconds)}.
const ours = (setting, options) => ({engine: "Pushfactor", setting, run: (scene, seconds) => ourTrajectory(program, options, scene, seconds, out)});
const others = loaded.flatMap((Engine) => Engine.settings.map((setting) => ({
    engine: `${Engine.title} ${Engine.version}`, setting: setting.name, run: (scene, seconds) => trajectoryOf(Engine, setting, scene, seconds),
})));
const shipped = (list) => list.filter(({setting}) => setting.startsWith("as shipped"));
const page = new Page({program, assets, out});
const number = (x) => !Number.isFinite(x) ? "–" : Math.abs(x) < 5e-7 ? "0" : String(Number(x.toPrecision(3)));

if (isWanted("figure_07")) {
    const scene = sceneOf(program, "intersecting-stack"), seconds = 2;
    const all = [ours("original method (preset paper)", ["--preset", "paper"]), ours("default", ["--preset", "default"]), ...others];
    page.section("figure_07", "Figure 7: five cubes that start inside each other",
        "Cubes of 2.4 m, inside each other by 0.4 m and in the ground by 1.2 m. Right is that they part and stand, the topmost at 10.8 m, and keep no speed of their parting. The picture is the state after 0.5 s.");
    const rows = [];
    for (const {engine, setting, run} of all) {
        const trajectory = run(scene, seconds), measured = flight(scene, trajectory);
        const shown = page.record("figure_07", `${engine}, ${setting}`, scene, trajectory, {at: 0.5, camera: {eye_m: [15, 17, 34], target_m: [0, 11, 0]}});
        rows.push({engine, setting, ...measured, shown});
    }
    page.table(rows, number);
    page.pictures(rows.map(({engine, setting, shown}) => ({title: `${engine}, ${setting}`, ...shown})));
}

if (isWanted("mass-ratios")) {
    const ratios = [1, 10, 100, 1e3, 1e4, 1e5, 1e6];
    page.section("mass-ratios", "A heavy cube on a light one",
        "Cubes of 1 m that touch, the lower one of 1 kg, the upper one heavier by the ratio; 10 s. A number is how deep they overlap at the end, in m, where they stand.");
    const all = [ours("default", ["--preset", "default"]), ...others];
    page.table(all.map(({engine, setting, run}) => ({engine, setting, ...Object.fromEntries(ratios.map((ratio) => {
        const scene = stack(2, ratio), trajectory = run(scene, 10), end = outcome(scene, trajectory);
        return [`ratio ${ratio}`, end === "stands" || end === "sags" ? depth(scene, trajectory) : end];
    }))})), number);
}

if (isWanted("atlas")) {
    const ratios = [1, 10, 100, 1e3, 1e4, 1e5, 1e6], counts = [2, 3, 5, 10, 20, 40];
    page.section("atlas", "Stability atlas: stacks with a heavy cube on top",
        "Cubes of 1 m and 1 kg that touch, the topmost heavier by the ratio; 10 s. Stands: every cube within 5 % of its edge of where it belongs. Sags: within half an edge. Crushed, falls: beyond. Explodes: thrown up by more than half an edge. Each cell opens its replay. Settings as shipped; MuJoCo at its own step of 2 ms.");
    const all = [ours("default", ["--preset", "default"]), ...shipped(others).filter(({engine, setting}) => !engine.startsWith("MuJoCo") || setting.includes("2 ms"))];
    for (const {engine, setting, run} of all) {
        page.grid(`${engine}, ${setting}`, "cubes", counts, "ratio", ratios, (count, ratio) => {
            const scene = stack(count, ratio), trajectory = run(scene, 10);
            const {replay} = page.record("atlas", `${engine}, ${count} cubes, ratio ${ratio}`, scene, trajectory, {every: 6});
            return {text: outcome(scene, trajectory), replay};
        });
    }
}
page.write();
console.log(`${out}/index.html`);
