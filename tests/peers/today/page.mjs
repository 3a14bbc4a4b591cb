// The page of the comparison, and its tables as text.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {movedScene, trajectoryCsv} from "./runs.mjs";

const escaped = (text) => String(text).replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
const fileName = (text) => text.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
const looks = {stands: "holds", sags: "known", crushed: "fails", falls: "fails", explodes: "fails"};
const verdict = (text) => `<span class="verdict ${looks[text]}">${text}</span>`;
const tableOf = (head, lines) => `<div class="scroll" tabindex="0"><table><thead><tr>${head.map((key) => `<th>${escaped(key)}</th>`).join("")}</tr></thead><tbody>
${lines.map((cells) => `<tr>${cells.join("")}</tr>`).join("\n")}</tbody></table></div>`;
const leastDifference = 1e-6;  // m or m/s, below which nobody is better

export class Page {
    constructor({program, assets, out, number}) {
        Object.assign(this, {program, assets, out, number, parts: [], csv: [], better: []});
    }

    // What follows belongs to this case; its files are in a folder of that name.
    begin(name) { this.name = name; }
    section(title, text, source) {
        if (this.title) this.parts.push("</section>");
        this.title = title;
        this.parts.push(`<section id="${this.name}"><h2>${escaped(title)}</h2>\n<p>${escaped(text)}${source ? ` <a href="${source}">Source</a>` : ""}</p>`);
        console.log(`\n${title}`);
    }

    // The trajectory as a file, a replay of every so many states, and with `at` a picture of that instant.
    record(name, scene, trajectory, {at, every = 1, camera}) {
        const base = path.join(this.name, fileName(name)), full = path.join(this.out, base);
        fs.mkdirSync(path.dirname(full), {recursive: true});
        const kept = trajectory.filter((state, i) => i % every === 0 && state.bodies.every(({position}) => position.every(Number.isFinite)));
        fs.writeFileSync(`${full}.csv`, trajectoryCsv(kept));
        fs.writeFileSync(`${full}.json`, JSON.stringify(movedScene({...scene, name: `${scene.name}: ${name}`.replaceAll("/", ":")}, kept, camera)));
        const rate = Math.round((kept.length - 1) / kept.at(-1).time), seconds = Math.max(kept.at(-1).time, 1 / 60);
        execFileSync(this.program, ["run", `${full}.json`, "--seconds", String(seconds), "--replay", `${full}.html`, "--replay-data", "poses", "--fps", rate > 30 ? "60" : "10"], {stdio: "pipe"});
        const shown = {replay: `${base}.html`, trajectory: `${base}.csv`};
        if (at !== undefined) {
            const camera_ = camera ? "scene" : "fit";
            execFileSync(this.program, ["render", `${full}.json`, "--at", String(at), "--seconds", String(seconds), "--caption", "off", "--camera", camera_, "--size", "360x480", "--samples", "4", "--out", `${full}.frames`], {stdio: "pipe"});
            fs.renameSync(path.join(`${full}.frames`, `at_${at}s.png`), `${full}.png`);
            fs.rmSync(`${full}.frames`, {recursive: true});
            Object.assign(shown, {picture: `${base}.png`, at});
        }
        fs.rmSync(`${full}.json`);
        return shown;
    }

    // Rows are objects with the same keys, of which `shown` (from `record`) becomes a picture and a link. Of the measures in `judged`
    // less is better, if `isRight` is not false.
    table(rows, number, judged) {
        const keys = Object.keys(rows[0]).filter((key) => key !== "shown" && key !== "isRight");
        const text = (value) => typeof value === "number" ? number(value) : value;
        const cell = (value) => looks[value] ? `<td>${verdict(value)}</td>` : `<td${typeof value === "number" ? " class=\"number\"" : ""}>${escaped(text(value))}</td>`;
        const shown = rows.filter((row) => row.shown);
        this.parts.push(tableOf(keys, rows.map((row) => keys.map((key) => cell(row[key])))));
        this.parts.push(`<div class="pictures">${shown.map(({engine, setting, shown: {picture, replay, trajectory, at}}) => `<figure><a href="${replay}"><img src="${picture}" alt="${escaped(`${engine}, ${setting}`)} after ${at} s"></a><figcaption>${escaped(`${engine}, ${setting}`)}, ${at} s (<a href="${trajectory}">trajectory</a>)</figcaption></figure>`).join("\n")}</div>`);
        console.log([keys, ...rows.map((row) => keys.map((key) => text(row[key])))].map((line) => line.join(" | ")).join("\n"));
        for (const row of rows) {
            for (const key of keys.slice(2)) this.csv.push([this.name, row.engine, row.setting, key, row[key]]);
        }
        const ours = rows.find(({setting}) => setting === "default");
        for (const key of judged) this.compare(key, ours[key], rows.filter(({engine, isRight}) => engine !== ours.engine && isRight !== false).map((row) => ({...row, value: row[key]})));
    }
    compare(measure, ours, theirs) {
        const amount = (value) => typeof value === "number" ? value : Infinity;
        for (const engine of new Set(theirs.map((row) => row.engine))) {
            const best = theirs.filter((row) => row.engine === engine).reduce((a, b) => amount(b.value) < amount(a.value) ? b : a);
            if (amount(best.value) < amount(ours) - leastDifference) this.better.push({name: this.name, title: this.title, measure, engine, setting: best.setting, value: best.value, ours});
        }
    }

    grid(engine, setting, rowName, rows, columnName, columns, cellOf) {
        const lines = rows.map((row) => [row, columns.map((column) => {
            const cell = cellOf(row, column);
            this.csv.push([this.name, engine, setting, `${rowName} ${row}, ${columnName} ${column}`, cell.text]);
            return cell;
        })]);
        const standing = lines.flatMap(([, cells]) => cells).filter(({text}) => text === "stands").length;
        this.parts.push(`<h3>${escaped(`${engine}, ${setting}`)}: ${standing} of ${rows.length * columns.length} stand</h3>`
            + tableOf([`${rowName} \\ ${columnName}`, ...columns], lines.map(([row, cells]) => [`<th>${row}</th>`, ...cells.map(({text, replay}) => `<td><a class="verdict ${looks[text]}" href="${replay}">${text}</a></td>`)])));
        console.log(`\n${engine}, ${setting}: ${standing} stand\n${[rowName, ...columns].join(" | ")}\n${lines.map(([row, cells]) => [row, ...cells.map(({text}) => text)].join(" | ")).join("\n")}`);
        const found = {engine, setting, cells: lines.flatMap(([row, cells]) => cells.map(({text}, i) => [`${rowName} ${row}, ${columnName} ${columns[i]}`, text]))};
        if (!this.grids || this.grids.name !== this.name) this.grids = {name: this.name, ours: found};
        else found.cells.forEach(([measure, text], i) => {
            const ours = this.grids.ours.cells[i][1];
            if (text === "stands" && ours !== "stands") this.better.push({name: this.name, title: this.title, measure, engine, setting, value: text, ours});
        });
    }

    // The first table, and a paragraph for each engine: `about` maps the name of an engine to what is known of it.
    summary(about) {
        const text = (value) => looks[value] ? verdict(value) : typeof value === "number" ? this.number(value) : escaped(value);
        const line = ({name, measure, engine, setting, value, ours}) => [`<td><a href="#${name}">${name}</a></td>`, `<td>${escaped(measure)}</td>`, `<td>${escaped(`${engine}, ${setting}`)}</td>`, `<td>${text(value)}</td>`, `<td>${text(ours)}</td>`];
        const table = this.better.length ? tableOf(["case", "measure", "who", "there", "here"], this.better.map(line)) : "<p>In none of these cases.</p>";
        const paragraphs = Object.entries(about).map(([engine, {title, text: words}]) => {
            const own = [...new Set(this.better.filter((entry) => entry.engine === title).map((entry) => `<a href="#${entry.name}">${escaped(entry.title)}</a>`))];
            return `<p id="${engine}"><b>${escaped(title)}.</b> ${escaped(words)} ${own.length ? `Better than this engine here: ${own.join("; ")}.` : "Better than this engine in none of these cases."}</p>`;
        });
        return `<section id="better"><h2>Where another engine is better</h2><p>By more than 1e-6 m or m/s, with its best setting of those shown, against the default of this engine; where all stands that should, and nothing is thrown. Less is better in all measures.</p>${table}</section>
<section id="engines"><h2>The engines</h2>${paragraphs.join("\n")}</section>`;
    }

    write(about) {
        this.parts.push("</section>");
        const style = fs.readFileSync(path.join(this.assets, "pages/page.css"), "utf8");
        fs.writeFileSync(path.join(this.out, "index.html"), `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>Pushfactor beside the engines of today</title>
<style>${style}.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)); gap: 1rem; } a.verdict { text-decoration: none; } figcaption a { display: inline; }</style></head>
<body><header><h1>Pushfactor beside the engines of today</h1><p>The same scenes in each engine, as trajectories, measured and drawn alike. Rapier, Jolt and MuJoCo are their npm packages (WebAssembly, single precision but MuJoCo), so there are no times here. Bodies do not sleep. A picture opens its replay.</p></header>
<main>${this.summary(about)}${this.parts.join("\n")}</main></body></html>\n`);
        fs.writeFileSync(path.join(this.out, "today.csv"), [["case", "engine", "setting", "measure", "value"], ...this.csv].map((line) => line.map((cell) => /[",]/.test(cell) ? `"${String(cell).replaceAll("\"", "\"\"")}"` : cell).join(",")).join("\n") + "\n");
    }
}
