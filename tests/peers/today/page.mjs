// The page of the comparison, and its tables as text.
import {execFileSync} from "node:child_process";
import fs from "node:fs";
import path from "node:path";
import {movedScene} from "./runs.mjs";

const escaped = (text) => String(text).replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
const fileName = (text) => text.toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "");
const looks = {stands: "holds", sags: "known", crushed: "fails", falls: "fails", explodes: "fails"};

export class Page {
    constructor({program, assets, out}) {
        Object.assign(this, {program, assets, out, parts: [], csv: []});
    }

    section(id, title, text) {
        if (this.id) this.parts.push("</section>");
        this.id = id;
        this.parts.push(`<section id="${id}"><h2>${escaped(title)}</h2>\n<p>${escaped(text)}</p>`);
        console.log(`\n${title}`);
    }

    // A replay of the trajectory, of every so many states, and with `at` a picture of that instant.
    record(folder, name, scene, trajectory, {at, every = 1, camera}) {
        const base = path.join(folder, fileName(name)), full = path.join(this.out, base);
        fs.mkdirSync(path.dirname(full), {recursive: true});
        const kept = trajectory.filter((state, i) => i % every === 0 && state.bodies.every(({position}) => position.every(Number.isFinite)));
        fs.writeFileSync(`${full}.json`, JSON.stringify(movedScene({...scene, name: `${scene.name}: ${name}`.replaceAll("/", ":")}, kept, camera)));
        const seconds = Math.max(kept.at(-1).time, 1 / 60);
        execFileSync(this.program, ["run", `${full}.json`, "--seconds", String(seconds), "--replay", `${full}.html`, "--replay-data", "poses", "--fps", every > 1 ? "10" : "60"], {stdio: "pipe"});
        const shown = {replay: `${base}.html`};
        if (at !== undefined) {
            execFileSync(this.program, ["render", `${full}.json`, "--at", String(at), "--caption", "off", "--camera", "scene", "--size", "360x480", "--samples", "4", "--out", `${full}.frames`], {stdio: "pipe"});
            fs.renameSync(path.join(`${full}.frames`, `at_${at}s.png`), `${full}.png`);
            fs.rmSync(`${full}.frames`, {recursive: true});
            shown.picture = `${base}.png`;
        }
        fs.rmSync(`${full}.json`);
        return shown;
    }

    // Rows are objects with the same keys; `shown` is for pictures.
    table(rows, number) {
        const keys = Object.keys(rows[0]).filter((key) => key !== "shown");
        const text = (value) => typeof value === "number" ? number(value) : value;
        const cell = (value) => looks[value] ? `<td><span class="verdict ${looks[value]}">${value}</span></td>` : `<td${typeof value === "number" ? " class=\"number\"" : ""}>${escaped(text(value))}</td>`;
        this.parts.push(`<div class="scroll" tabindex="0"><table><thead><tr>${keys.map((key) => `<th>${escaped(key)}</th>`).join("")}</tr></thead><tbody>`
            + rows.map((row) => `<tr>${keys.map((key) => cell(row[key])).join("")}</tr>`).join("\n") + "</tbody></table></div>");
        console.log([keys, ...rows.map((row) => keys.map((key) => text(row[key])))].map((line) => line.join(" | ")).join("\n"));
        for (const row of rows) {
            for (const key of keys.slice(2)) this.csv.push([this.id, row.engine, row.setting, key, row[key]]);
        }
    }

    pictures(list) {
        this.parts.push(`<div class="pictures">${list.map(({title, picture, replay}) => `<figure><a href="${replay}"><img src="${picture}" alt="${escaped(title)} after 0.5 s"></a><figcaption>${escaped(title)}</figcaption></figure>`).join("\n")}</div>`);
    }

    grid(title, rowName, rows, columnName, columns, cellOf) {
        const lines = rows.map((row) => [row, columns.map((column) => {
            const cell = cellOf(row, column);
            this.csv.push([this.id, title, `${rowName} ${row}`, `${columnName} ${column}`, cell.text]);
            return cell;
        })]);
        this.parts.push(`<h3>${escaped(title)}</h3><div class="scroll" tabindex="0"><table><thead><tr><th>${rowName} \\ ${columnName}</th>${columns.map((column) => `<th>${column}</th>`).join("")}</tr></thead><tbody>`
            + lines.map(([row, cells]) => `<tr><th>${row}</th>${cells.map(({text, replay}) => `<td><a class="verdict ${looks[text]}" href="${replay}">${text}</a></td>`).join("")}</tr>`).join("\n") + "</tbody></table></div>");
        console.log(`\n${title}\n${[rowName, ...columns].join(" | ")}\n${lines.map(([row, cells]) => [row, ...cells.map(({text}) => text)].join(" | ")).join("\n")}`);
    }

    write() {
        this.parts.push("</section>");
        const style = fs.readFileSync(path.join(this.assets, "pages/page.css"), "utf8");
        fs.writeFileSync(path.join(this.out, "index.html"), `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1"><title>Pushfactor beside the engines of today</title>
<style>${style}.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(13rem, 1fr)); gap: 1rem; } a.verdict { text-decoration: none; }</style></head>
<body><header><h1>Pushfactor beside the engines of today</h1><p>The same scenes in each engine, as trajectories, measured and drawn alike. Rapier, Jolt and MuJoCo are their npm packages (WebAssembly, single precision but MuJoCo), so there are no times here.</p></header>
<main>${this.parts.join("\n")}</main></body></html>\n`);
        fs.writeFileSync(path.join(this.out, "today.csv"), [["case", "engine", "setting", "measure", "value"], ...this.csv].map((line) => line.map((cell) => /[",]/.test(cell) ? `"${String(cell).replaceAll("\"", "\"\"")}"` : cell).join(",")).join("\n") + "\n");
    }
}
