// node main.mjs PACKAGES PROGRAM ASSETS OUT [CASE...]   cases: the files in cases/, all of them if none is named
// Writes OUT/index.html with tables, pictures, replays and trajectories, and OUT/today.csv; prints the tables.
import fs from "node:fs";
import path from "node:path";
import {fileURLToPath, pathToFileURL} from "node:url";
import {about} from "./about.mjs";
import {engines} from "./engines.mjs";
import {Page} from "./page.mjs";
import {ourTrajectory, trajectoryOf} from "./runs.mjs";

const [packages, program, assets, out, ...wanted] = process.argv.slice(2);
const folder = path.join(path.dirname(fileURLToPath(import.meta.url)), "cases");
const order = ["figure_07", "mass-ratios", "atlas", "overlaps", "pyramid", "pyramid-80", "card-house", "heavy-tops", "heavy-box", "heap"];
const cases = fs.readdirSync(folder).map((file) => path.basename(file, ".mjs")).sort((a, b) => order.indexOf(a) - order.indexOf(b));
const unknown = wanted.find((name) => !cases.includes(name));
if (unknown) {
    console.error(`tests/compare today ${unknown}: must be one of ${cases.join(", ")}`);
    process.exit(2);
}
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

// This engine and the others as they are compared: {engine, setting, run(scene, seconds, {perSecond, rate})}, with the setting's own
// step unless a rate, in steps a second, is asked for. `shipped` are the first settings of the others.
const ours = (setting, options = ["--preset", setting]) => ({
    engine: "Pushfactor", setting,
    run: (scene, seconds, {perSecond = 60, rate} = {}) => ourTrajectory(program, rate ? [...options, "--dt", `1/${rate}`] : options, scene, seconds, perSecond, out),
});
const titleOf = (Engine) => `${Engine.title} ${Engine.version}`;
const others = loaded.flatMap((Engine) => Engine.settings.map((setting) => ({
    engine: titleOf(Engine), setting: setting.name,
    run: (scene, seconds, {perSecond = 60, rate} = {}) => trajectoryOf(Engine, rate ? {...setting, dt: 1 / rate} : setting, scene, seconds, perSecond),
})));
const shipped = others.filter(({engine}, i) => others.findIndex((other) => other.engine === engine) === i);
const number = (x) => !Number.isFinite(x) ? "–" : Math.abs(x) < 5e-7 ? "0" : String(Number(x.toPrecision(3)));

const page = new Page({program, assets, out, number});
for (const name of wanted.length ? cases.filter((known) => wanted.includes(known)) : cases) {
    page.begin(name);
    const {run} = await import(pathToFileURL(path.join(folder, `${name}.mjs`)).href);
    run({page, ours, others, shipped, program, out, number});
}
page.write(Object.fromEntries(loaded.map((Engine) => [Engine.title, {title: titleOf(Engine), text: about[Engine.title]}])));
console.log(`${out}/index.html`);
