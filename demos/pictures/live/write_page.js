// Writes the page with the program inside: node write_page.js PROGRAM.js ASSETS PAGE.html
"use strict";
const fs = require("fs");
const path = require("path");
const zlib = require("zlib");

const [program, assets, page] = process.argv.slice(2);
const text = (...names) => fs.readFileSync(path.join(assets, ...names), "utf8");

const shared = ["page.js", "space.js", "bytes.js", "camera.js", "scene.js", "draw.js", "marks.js", "arrows.js", "plots.js"];
const own = ["run.js", "view.js", "figure.js", "rows.js", "scenes.js", "live.js"];
const shaders = {};
for (const folder of ["shaders", "replay"]) {
    for (const name of fs.readdirSync(path.join(assets, folder)).sort()) {
        if (/\.(vert|frag)$/.test(name)) shaders[name] = text(folder, name);
    }
}
// A script element ends at the first "</script".
const inScript = (source) => {
    if (/<\/script/i.test(source)) throw new Error("a script contains the end of its element");
    return source;
};
const parts = {
    style: text("pages", "page.css") + text("replay", "replay.css") + text("live", "live.css"),
    shaders: JSON.stringify(shaders).replaceAll("<", "\\u003c"),
    worker: inScript(fs.readFileSync(program, "utf8") + "\n" + text("live", "worker.js")),
    program: zlib.gzipSync(fs.readFileSync(program.replace(/\.js$/, ".wasm")), {level: 9}).toString("base64"),
    script: inScript(shared.map((name) => text("replay", name)).concat(own.map((name) => text("live", name))).join("")),
};
let html = text("live", "page.html");
for (const [name, content] of Object.entries(parts)) {
    if (!html.includes(`@${name}@`)) throw new Error(`page.html has no @${name}@`);
    html = html.replace(`@${name}@`, () => content);
}
fs.writeFileSync(page, html);
