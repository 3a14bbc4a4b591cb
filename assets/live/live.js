// The page: modes, clock, controls, address, and what other programs may ask (window.pushfactor, see demos/FORMATS.md).
const keyTable = [
    ["Space", "play or pause"], ["→", "one step; of the rows the next one, with Shift a sweep"], ["R", "restart"], ["Home End", "of the rows: none, or all sweeps"],
    ["1 2 3 4", "contacts, forces, push, velocities on or off"], ["− +", "shorter or longer arrows"], ["W A S D", "turn the camera"],
    ["Shift W A S D", "move it"], ["Q E", "closer or farther"], ["0", "the scene's own camera"], ["F", "all bodies in view"],
    ["drag", "turn the camera; with Shift, the right button or two fingers move it; wheel or two fingers: closer or farther"],
];
const mostSteps = 36000;     // of a run: its measures fill memory
const batchMilliseconds = 40;  // that the worker may work before the next picture
const plotEvery = 100;       // ms

let program, menu, view, modes, mode, runs = [], plots = [];
let goal = 0;                // step that an address asks for
let playing = null;          // since when and from which step: {now, step, until}
let speed = 1;
let wanted = false, opening = null, slots = 0, lastPlot = 0;

// ---- runs ----

// Opens the runs of the mode anew, as often as it changes meanwhile, and goes to the step that is asked for.
const open = () => {
    wanted = true;
    if (!opening) {
        opening = (async () => {
            while (wanted) {
                wanted = false;
                await openOnce();
            }
        })().finally(() => { opening = null; });
    }
    return opening;
};
const openOnce = async () => {
    const ofMode = mode, wishes = await ofMode.wishes();
    $("problem").hidden = true;
    const opened = wishes.map(({label}) => new Run(program, ++slots, label));
    const close = (some) => some.forEach(({slot}) => program.call("close", slot));
    try {
        for (const [i, run] of opened.entries()) await run.open(wishes[i].scene, wishes[i].options);
    } catch (error) {
        // What is shown stays, with the reason why it is not what was asked for.
        close(opened);
        setPlaying(false);
        fail(error.message);
        return;
    }
    close(runs);
    runs = opened;
    if (ofMode.name === "rows") {
        await advance(ofMode.values.moment);
        const data = await program.call("microscope", runs[0].slot);
        if (data.refused || data.failed) {
            fail(data.refused || data.failed);
            return;
        }
        view.take(ofMode.take(data, runs[0]), ofMode.labels());
    } else {
        view.take(runs, ofMode.labels());
        if (goal > 0) await advance(goal);
    }
    if (wanted || ofMode !== mode) return;
    goal = 0;
    if (playing) playing = {...playing, now: null};
    makePlots();
    refresh(true);
    view.draw();
};

const advance = async (steps) => {
    const own = runs;
    for (let left = Math.min(steps, mostSteps - own[0].step); left > 0 && own === runs;) {
        const some = Math.min(left, batchOf());
        const answers = await program.call("advance", own.map((run) => [run.slot, run.failed ? 0 : some]));
        own.forEach((run, i) => { if (!run.failed) run.take(answers[i]); });
        left -= some;
        if (own.every((run) => run.failed)) break;
    }
};
// Steps that take about as long as a picture may wait.
const batchOf = () => {
    const most = runs.reduce((sum, run) => sum + (run.step > 0 ? run.milliseconds / run.step : 0), 0);
    return clamp(Math.floor(batchMilliseconds / Math.max(most, 0.05)), 1, 600);
};

const stepOnce = async () => {
    setPlaying(false);
    await opening;
    if (mode.name === "rows" || !runs.length) return;
    await advance(1);
    refresh(true);
    view.draw();
    noteAddress();
};
const restart = async () => {
    goal = 0;
    await open();
    noteAddress();
};

// ---- clock ----

const setPlaying = (on, until = Infinity) => {
    if (Boolean(playing) === on) return;
    playing = on ? {now: null, step: 0, until} : null;
    $("play").textContent = on ? "❚❚" : "▶";
    $("play").setAttribute("aria-label", on ? "Pause" : "Play");
    if (on) requestAnimationFrame(tick); else noteAddress();
};
// Until the instant of the figure.
const playShortly = () => {
    setSpeed(mode.autoplay.speed);
    setPlaying(true, mode.autoplay.until);
};
const setSpeed = (value) => {
    speed = value;
    $("speed").value = String(value);
    if (playing) playing.now = null;
};
const tick = async (now) => {
    if (!playing) return;
    if (!opening && runs.length && mode.name !== "rows") {
        const dt = runs[0].stage.seconds_a_step;
        if (playing.now === null) Object.assign(playing, {now, step: runs[0].step});
        const due = playing.step + Math.floor((now - playing.now) / 1000 * speed / dt + 1e-6) - runs[0].step;
        if (due > 0) {
            const some = Math.min(due, batchOf(), Math.max(1, Math.round(playing.until / dt) - runs[0].step));
            if (some < due) Object.assign(playing, {now, step: runs[0].step + some});  // slower than time
            await advance(some);
            refresh(false);
            view.draw();
            if (!playing) return;
            const atEnd = runs[0].step >= mostSteps || runs.every((run) => run.failed);
            if (atEnd || runs[0].time >= playing.until) setPlaying(false);
            if (runs[0].step >= mostSteps) say("The run ends here: it is ten minutes long.");
        }
    }
    if (playing) requestAnimationFrame(tick); else refresh(true);
};

// ---- what is written ----

// Plots are made anew only every tenth of a second while the run goes on.
const refresh = (all) => {
    if (mode.name !== "rows") {
        $("time").textContent = `${runs[0].time.toFixed(3)} s, step ${runs[0].step}`;
        mode.refresh(runs);
        const failed = runs.find((run) => run.failed);
        if (failed && mode.name === "scenes") fail(`The run stopped: ${failed.failed}`);
    }
    const now = performance.now();
    if (all || now - lastPlot > plotEvery) {
        lastPlot = now;
        plots.forEach((plot) => {
            plot.prepare();
            plot.show(plot.lines[0].values.length - 1);
        });
        showCommands();
    }
};
const makePlots = () => {
    $("lines").replaceChildren();
    const several = runs.length > 1;
    plots = mode.plots.map((plot) => new Plot($("lines"), plot,
        runs.flatMap((run) => plot.of.map(([name, measure]) => ({name: several ? run.label : name, values: run.measures[measureNames.indexOf(measure)]}))),
        (step) => step * runs[0].stage.seconds_a_step, (step) => goTo(step)));
};
const goTo = async (step) => {
    setPlaying(false);
    await opening;
    if (step < runs[0].step) {
        goal = step;
        await open();
    } else {
        await advance(step - runs[0].step);
        refresh(true);
        view.draw();
    }
    noteAddress();
};
const showCommands = () => {
    while ($("commands").children.length > runs.length) $("commands").lastChild.remove();
    while ($("commands").children.length < runs.length) {
        const line = document.createElement("div"), code = document.createElement("code"), button = document.createElement("button");
        line.className = "command";
        button.type = "button";
        button.textContent = "Copy";
        code.append(document.createElement("b"), document.createElement("span"));
        const index = $("commands").children.length;
        button.addEventListener("click", () => copy(runs[index].command, button, "Copy"));
        line.append(code, button);
        $("commands").append(line);
    }
    runs.forEach((run, i) => {
        const [command, hash] = $("commands").children[i].firstChild.children;
        command.textContent = run.command;
        hash.textContent = `state hash ${run.hash} after step ${run.step}${run.label ? `: ${run.label}` : ""}`;
    });
};

// ---- modes and controls ----

const setMode = async (name, words) => {
    mode = modes[name];
    if (words) await mode.read(words);
    view.show = new Set(words && words.has("show") ? words.get("show").split(",").filter((kind) => kinds.includes(kind)) : mode.shows);
    view.camera = null;
    view.start = mode.camera || (({eye, target}) => ({eye: [...eye], target: [...target]}));
    view.decorate = (marks, i) => { if (mode.decorate) mode.decorate(marks, i); };
    $("player").dataset.mode = name;
    for (const tab of $("modes").children) {
        tab.setAttribute("aria-selected", String(tab.dataset.mode === name));
        tab.tabIndex = tab.dataset.mode === name ? 0 : -1;
    }
    for (const part of document.querySelectorAll("[data-for]")) part.hidden = !part.dataset.for.split(" ").includes(name);
    makeSliders();
    if (name === "scenes") mode.write();
    showControls();
};
const makeSliders = () => {
    $("sliders").replaceChildren(...mode.table.map(({name, label, unit: unitText, low, high, step, values}) => {
        const field = document.createElement("label"), shown = document.createElement("output");
        field.className = "field";
        const change = (value) => {
            mode.values[name] = value;
            if (mode.name === "rows") mode.at = 0;
            goal = 0;
            open();
            if (mode.autoplay && !playing) playShortly();
            noteAddress();
        };
        if (values) {
            const select = document.createElement("select");
            select.append(...values.map((value) => new Option(unitText ? `${value} ${unitText}` : value, value)));
            select.value = mode.values[name];
            select.dataset.slider = name;
            select.addEventListener("change", () => change(select.value));
            field.append(`${label} `, select);
            return field;
        }
        const input = Object.assign(document.createElement("input"), {type: "range", min: low, max: high, step});
        const write = () => { shown.textContent = unitText ? `${mode.values[name]} ${unitText}` : String(mode.values[name]); };
        input.value = String(mode.values[name]);
        input.dataset.slider = name;
        input.addEventListener("input", () => {
            change(Number(input.value));
            write();
        });
        write();
        field.append(`${label} `, input, shown);
        return field;
    }));
};
const toggle = (kind) => {
    if (view.show.has(kind)) view.show.delete(kind); else view.show.add(kind);
    showControls();
    view.want();
    noteAddress();
};
const setScale = (scale) => {
    view.scale = clamp(Math.round(scale * 20) / 20, -3, 3);
    showControls();
    view.want();
    noteAddress();
};
const showControls = () => {
    for (const box of $("show").querySelectorAll("input")) box.checked = view.show.has(box.value);
    $("scale").value = String(view.scale);
};
const changeMode = async (name) => {
    setPlaying(false);
    goal = 0;
    await setMode(name);
    await open();
    noteAddress();
};

const makeControls = () => {
    for (const tab of $("modes").children) {
        tab.addEventListener("click", () => changeMode(tab.dataset.mode));
        tab.addEventListener("keydown", (event) => {
            const step = {ArrowLeft: -1, ArrowRight: 1}[event.key];
            if (!step) return;
            event.preventDefault();
            event.stopPropagation();
            const tabs = [...$("modes").children], next = tabs[(tabs.indexOf(tab) + step + tabs.length) % tabs.length];
            next.focus();
            changeMode(next.dataset.mode);
        });
    }
    $("to-rows").addEventListener("click", (event) => {
        event.preventDefault();
        changeMode("rows").then(() => $("modes").scrollIntoView());
    });
    kinds.forEach((kind) => kindBox(kind, menu.legend, toggle));
    $("speed").append(...[[1, "× 1"], [1 / 2, "× 1/2"], [1 / 4, "× 1/4"], [1 / 8, "× 1/8"], [1 / 16, "× 1/16"]].map(([value, text]) => new Option(text, String(value))));
    $("speed").addEventListener("change", () => setSpeed(Number($("speed").value)));
    $("play").addEventListener("click", () => setPlaying(!playing));
    $("step").addEventListener("click", stepOnce);
    $("restart").addEventListener("click", restart);
    $("scale").addEventListener("input", () => setScale(Number($("scale").value)));
    $("home").addEventListener("click", () => view.home());
    $("fit").addEventListener("click", () => view.fit());
    $("link").addEventListener("click", async () => copy(location.href.split("#")[0] + await addressText(), $("link"), "Copy link"));
    modes.rows.changed = () => {
        view.labels = modes.rows.labels();
        view.want();
        noteAddress();
    };
    modes.scenes.changed = async () => {
        goal = 0;
        modes.scenes.write();
        await open();
        noteAddress();
    };
    for (const name of ["dragover", "drop"]) {
        document.addEventListener(name, async (event) => {
            event.preventDefault();
            const [file] = event.dataTransfer ? event.dataTransfer.files : [];
            if (name !== "drop" || !file) return;
            setPlaying(false);
            if (mode.name !== "scenes") await setMode("scenes");
            await modes.scenes.openFile(file);
        });
    }
    makeKeys();
};
const makeKeys = () => {
    const turn = 0.06, rows = modes.rows;
    const next = (event) => {
        if (mode !== rows) stepOnce();
        else if (event.shiftKey) $("row-sweep").click();
        else $("row-next").click();
    };
    const keys = {
        " ": () => mode === rows ? $("row-next").click() : setPlaying(!playing), ArrowRight: next, r: restart,
        Home: () => mode === rows ? rows.go(0) : restart(), End: () => { if (mode === rows) rows.go(Infinity); },
        ArrowLeft: () => { if (mode === rows) rows.go(rows.at - 1); },
        "+": () => setScale(view.scale + 0.25), "=": () => setScale(view.scale + 0.25), "-": () => setScale(view.scale - 0.25),
        a: () => view.move(() => turnEye(view.own(), turn, 0)), d: () => view.move(() => turnEye(view.own(), -turn, 0)),
        w: () => view.move(() => turnEye(view.own(), 0, turn)), s: () => view.move(() => turnEye(view.own(), 0, -turn)),
        A: () => view.move(() => shiftCamera(view.own(), -0.05, 0)), D: () => view.move(() => shiftCamera(view.own(), 0.05, 0)),
        W: () => view.move(() => shiftCamera(view.own(), 0, 0.05)), S: () => view.move(() => shiftCamera(view.own(), 0, -0.05)),
        q: () => view.move(() => zoomEye(view.own(), 0.93)), e: () => view.move(() => zoomEye(view.own(), 1 / 0.93)),
        0: () => view.home(), f: () => view.fit(),
    };
    kinds.forEach((kind, i) => { keys[String(i + 1)] = () => toggle(kind); });
    document.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const {tagName, type} = event.target;
        // Controls keep their own keys.
        if (tagName === "SELECT" || (tagName === "INPUT" && (type !== "checkbox" || event.key === " "))) return;
        if ((tagName === "BUTTON" || tagName === "SUMMARY" || tagName === "A") && event.key === " ") return;
        const action = keys[event.key] || keys[event.key.toLowerCase()];
        if (!action || !runs.length) return;
        event.preventDefault();
        action(event);
    });
};

// ---- address ----

let addressTimer = 0;
const addressText = async () => {
    const words = await mode.words(), list = (v) => v.map((x) => Number(x.toPrecision(6))).join(",");
    if (mode.name !== "rows" && runs.length && runs[0].step) words.push(["step", String(runs[0].step)]);
    if (view.camera) words.push(["eye", list(view.camera.eye)], ["target", list(view.camera.target)]);
    if ([...view.show].join() !== mode.shows.join()) words.push(["show", [...view.show].join()]);
    if (view.scale) words.push(["scale", String(view.scale)]);
    return "#" + [mode.name, ...words.map(([name, text]) => `${name}=${encodeURIComponent(text).replaceAll("%2F", "/").replaceAll("%2C", ",")}`)].join("&");
};
const noteAddress = () => {
    clearTimeout(addressTimer);
    addressTimer = setTimeout(async () => {
        if (playing) return;
        try {
            history.replaceState(null, "", await addressText());
        } catch {
            // Some browsers deny it to pages on disk; "Copy link" works all the same.
        }
    }, 400);
};
const readAddress = async () => {
    const words = new URLSearchParams(location.hash.slice(1));
    const three = (name) => {
        const numbers = (words.get(name) || "").split(",").map(Number);
        return numbers.length === 3 && numbers.every(Number.isFinite) ? numbers : null;
    };
    await setMode(Object.keys(modes).find((name) => words.has(name)) || "figure", words);
    const eye = three("eye"), target = three("target");
    goal = clamp(Math.round(Number(words.get("step")) || 0), 0, mostSteps);
    view.scale = clamp(Number(words.get("scale")) || 0, -3, 3);
    showControls();
    await open();
    if (eye && target && norm(minus(eye, target)) > 0 && runs.length) {
        view.camera = {eye, target, fieldOfView: runs[0].stage.camera.field_of_view};
        view.draw();
    } else if (words.has("fit") && runs.length) {
        view.fit();
    }
    return words;
};

// ---- for other programs ----

const api = {
    version: 1,
    get mode() { return mode.name; },
    get steps() { return runs.map(({step}) => step); },
    get stateHashes() { return runs.map(({hash}) => hash); },
    get commands() { return runs.map(({command}) => command); },
    get playing() { return Boolean(playing); },
    get rows() { return modes.rows.data; },
    // Milliseconds of work per step, of all runs together.
    get millisecondsAStep() { return runs.reduce((sum, run) => sum + run.milliseconds / Math.max(run.step, 1), 0); },
    poses: (run = 0) => ({positions: [...runs[run].now.position], orientations: [...runs[run].now.orientation]}),
    // A scene with options of the command line, as pairs of texts.
    open: async (scene, options) => {
        setPlaying(false);
        const words = new URLSearchParams([["scene", scene], ...options]);
        goal = 0;
        await setMode("scenes", words);
        await open();
    },
    play: () => setPlaying(true),
    pause: () => setPlaying(false),
    advance: async (steps) => {
        setPlaying(false);
        await opening;
        await advance(steps);
        refresh(true);
        view.draw();
    },
    // Milliseconds to draw the current state, finished by the GPU, the mean of `count`.
    timeDrawing: (count = 10) => {
        const {gl} = view.painter, pixel = new Uint8Array(4);
        const begin = performance.now();
        for (let i = 0; i < count; ++i) {
            view.draw();
            gl.bindFramebuffer(gl.FRAMEBUFFER, null);
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        }
        return (performance.now() - begin) / count;
    },
};

const start = async () => {
    if (typeof DecompressionStream === "undefined") throw new Error("this browser lacks DecompressionStream, which inflates the program; browsers since 2023 have it");
    const worker = new Worker(URL.createObjectURL(new Blob([$("worker").textContent], {type: "text/javascript"})));
    program = new Worked(worker);
    menu = await program.call("start", bytesOf($("program").textContent));
    let painter = null;
    try {
        painter = new Painter($("picture"), JSON.parse($("shaders").textContent), meshesIn(menu.meshes));
    } catch (error) {
        if (error.message !== "WebGL 2 is missing") throw error;
    }
    view = new View(painter, menu.legend, () => noteAddress());
    modes = {figure: new Figure(), rows: new Rows(), scenes: new Scenes(menu, program)};
    $("version").textContent = menu.version;
    fillTable($("keys").tBodies[0], keyTable);
    $("player").hidden = false;
    makeControls();
    const words = await readAddress();
    $("starting").hidden = true;
    if (!painter) {
        fail("This page draws with WebGL 2, which this browser does not have or has switched off. Numbers and plots are below; the picture is not.");
        $("view").hidden = true;
    }
    api.firstFrameMs = performance.now();
    addEventListener("hashchange", readAddress);
    new ResizeObserver(() => {
        view.draw();
        if (runs.length) refresh(true);
    }).observe($("view"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => refresh(true));
    $("picture").addEventListener("webglcontextlost", (event) => {
        event.preventDefault();
        fail("The graphics driver has stopped; reload the page.");
    });
    // A page that is opened without an address shows what it is about by itself.
    if (![...words].length && !matchMedia("(prefers-reduced-motion: reduce)").matches) playShortly();
};
api.ready = start().catch((error) => {
    $("starting").hidden = true;
    fail(`This page cannot run: ${error.message}`);
    throw error;
});
window.pushfactor = api;
