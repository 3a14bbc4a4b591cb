// The page: clock, camera, what is shown, and what other programs may ask (window.pushfactor, see demos/FORMATS.md).
const about = JSON.parse($("run").textContent);
const end = JSON.parse($("end").textContent);
const measures = [
    {title: "Energy", unit: "J", of: [["kinetic", (m) => m[0]], ["potential", (m) => m[1]], ["sum", (m) => m[0].map((x, i) => x + m[1][i])]]},
    {title: "Deepest overlap", unit: "m", of: [["", (m) => m[2]]]},
    {title: "Largest speed", unit: "m/s", of: [["", (m) => m[3]]]},
    {title: "Residual of the solver", unit: "m/s", logarithmic: true, of: [["", (m) => m[4]]]},
];
const keyTable = [
    ["Space", "play or pause"], ["← →", "one frame back or forward; with Shift ten"], ["Home End", "first or last frame"],
    ["[ ]", "slower or faster"], ["1 2 3 4", "contacts, forces, push, velocities on or off"], ["− +", "shorter or longer arrows"],
    ["W A S D", "turn the camera"], ["Shift W A S D", "move it"], ["Q E", "closer or farther"],
    ["0", "the scene's own camera"], ["F", "all bodies in view"], ["B", "follow the chosen body"], ["N P", "choose the next or previous body"],
    ["Esc", "choose none"], ["G", "side by side or overlaid"],
    ["drag", "turn the camera; with Shift, the right button or two fingers move it; wheel or two fingers: closer or farther"],
];

const seconds = about.seconds_a_frame;
const lastFrame = end.frames - 1;
const state = {frame: 0, isPlaying: false, speed: about.play_speed, show: new Set(), scale: 0, mode: "side", camera: null, chosen: null, follows: false};
let tracks = [], stages = [], painter, plots = [], drawnFrame = -1, drawWanted = false;

// ---- camera ----

const sceneCamera = (run, time) => {
    const {eye, target, field_of_view: fieldOfView} = tracks[run].stage.camera;
    const angle = radians(about.degrees_a_second * time), offset = minus(eye, target);
    const turned = angle === 0 ? offset
        : [Math.cos(angle) * offset[0] + Math.sin(angle) * offset[2], offset[1], Math.cos(angle) * offset[2] - Math.sin(angle) * offset[0]];
    return {eye: add(target, turned), target, fieldOfView};
};
const stagesShown = () => tracks.map(({stage}) => stage);
const isNarrow = (aspect) => tracks.length > 1 || aspect < 0.98 * about.width / about.height;
const widened = (camera, aspect) => isNarrow(aspect) ? shownAcross(camera, acrossOf(stagesShown()), aspect) : camera;
const cameraOf = (run, area) => widened(state.camera || sceneCamera(run, state.frame * seconds), area.width / area.height);
const ownCamera = () => {
    if (!state.camera) state.camera = sceneCamera(0, state.frame * seconds);
    return state.camera;
};

const turnCamera = (right, up) => {
    turnEye(ownCamera(), right, up);
    cameraChanged();
};
const moveCamera = (right, up) => {
    shiftCamera(ownCamera(), right, up);
    cameraChanged();
};
const zoomCamera = (factor) => {
    zoomEye(ownCamera(), factor);
    cameraChanged();
};
const cameraChanged = () => {
    wantDraw();
    noteAddress();
};
const resetCamera = () => {
    state.camera = null;
    setFollow(false);
    cameraChanged();
};
const fitCamera = () => {
    const balls = tracks.flatMap((track) => {
        const {position} = track.poses(state.frame);
        return track.stage.recorded.map((body) => ({centre: [...position.subarray(3 * body, 3 * body + 3)], radius: track.stage.bodies[body].unit}));
    });
    const [area] = areas();
    if (!frameBalls(ownCamera(), balls, area.width / area.height)) return;
    cameraChanged();
};
const placeOf = ({run, body}) => {
    const {position} = tracks[run].poses(state.frame);
    return [position[3 * body], position[3 * body + 1], position[3 * body + 2]];
};
let followed = null;
const setFollow = (on) => {
    state.follows = Boolean(on && state.chosen);
    followed = state.follows ? placeOf(state.chosen) : null;
    $("follow").setAttribute("aria-pressed", String(state.follows));
    if (state.follows) {
        const camera = ownCamera(), shift = minus(followed, camera.target);
        camera.eye = add(camera.eye, shift);
        camera.target = followed;
        cameraChanged();
    }
};
const followChosen = () => {
    if (!state.follows) return;
    const place = placeOf(state.chosen), shift = minus(place, followed);
    state.camera.eye = add(state.camera.eye, shift);
    state.camera.target = add(state.camera.target, shift);
    followed = place;
};

// ---- drawing ----

const areas = () => cellsOf($("picture"), stagesShown(), state.mode === "ghost" ? 1 : tracks.length);

const wantedParts = () => {
    const names = ["poses"];
    if (about.parts.includes("velocities") && (state.show.has("velocities") || state.chosen)) names.push("velocities");
    if (about.parts.includes("forces") && (state.chosen || ["contacts", "forces", "push"].some((kind) => state.show.has(kind)))) names.push("forces");
    return names;
};
const isReady = (frame) => tracks.every((track) => track.isReady(frame, wantedParts()));

const unitsAMetre = (kind) => {
    const given = about.overlay.find((item) => item.kind === kind);
    const {eye, target} = tracks[0].stage.camera;
    const chosen = (end.typical && end.typical[kind] || 1) / (0.11 * norm(minus(eye, target)));
    return (given && given.units_a_metre || chosen) / 2 ** state.scale;
};

const drawMarks = (marks, run) => {
    const acting = state.show.size > (state.show.has("velocities") ? 1 : 0) ? tracks[run].acting(state.frame) : [];
    drawActing(marks, acting, state.show, about.legend, unitsAMetre);
    if (!state.show.has("velocities")) return;
    tracks[run].stage.recorded.forEach((body, i) => {
        drawVelocity(marks, placeOf({run, body}), velocityOf(run, i).linear, tracks[run].stage.bodies[body], about.legend, unitsAMetre);
    });
};

// Stored velocities if the file has them, else those between frames: this one and the one before, or at the beginning of
// a block the one after.
const velocityOf = (run, i) => {
    const stored = tracks[run].velocity(state.frame, i);
    if (stored) return {...stored, isStored: true};
    const body = tracks[run].stage.recorded[i];
    const block = tracks[run].block(state.frame), values = tracks[run].part("poses", state.frame);
    if (block.count < 2 || values instanceof Promise) return {linear: [0, 0, 0], angular: [0, 0, 0]};
    const frame = Math.max(state.frame, block.first + 1);
    const number = (k, at) => values[(7 * i + k) * block.count + at - block.first] * tracks[run].units[body];
    return {linear: [0, 1, 2].map((k) => (number(k, frame) - number(k, frame - 1)) / seconds), angular: [0, 0, 0]};
};

const drawChosen = (context, marks, camera, area) => {
    const {run, body} = state.chosen, {bodies} = tracks[run].stage;
    const place = marks.place(placeOf(state.chosen));
    if (!place) return;
    const radius = Math.max(8, bodies[body].unit * 0.5 * area.height / (halfTangent(camera.fieldOfView) * norm(minus(placeOf(state.chosen), camera.eye))));
    context.lineWidth = Math.max(1.5, area.height / 360);
    for (const [colour, dash] of [["rgb(255 255 255 / 0.9)", []], ["#1f2328", [6, 4]]]) {
        context.strokeStyle = colour;
        context.setLineDash(dash.map((x) => x * area.height / 540));
        context.beginPath();
        context.arc(place[0], place[1], radius, 0, 2 * Math.PI);
        context.stroke();
    }
    context.setLineDash([]);
};

const draw = () => {
    drawWanted = false;
    if (!tracks.length || end.frames === 0) return;
    fitCanvases();
    if (!isReady(state.frame)) {
        // What is missing is on its way; what is shown stays until then.
        Promise.all(tracks.map((track) => track.load(state.frame, wantedParts()))).then(wantDraw);
        return;
    }
    followChosen();
    painter.clearPage();
    const context = $("marks").getContext("2d");
    context.clearRect(0, 0, $("marks").width, $("marks").height);
    const cells = areas(), height = $("picture").height;
    const scenes = stages.map((stage) => stage.at(state.frame));
    cells.forEach((cell, i) => {
        const camera = cameraOf(i, cell);
        painter.draw(state.mode === "ghost" ? scenes : [scenes[i]], camera, {...cell, y: height - cell.y - cell.height});
        context.save();
        context.beginPath();
        context.rect(cell.x, cell.y, cell.width, cell.height);
        context.clip();
        const marks = new Marks(context, camera, cell);
        (state.mode === "ghost" ? tracks.map((_, run) => run) : [i]).forEach((run) => drawMarks(marks, run));
        marks.draw();
        if (state.chosen && (state.mode === "ghost" || state.chosen.run === i)) drawChosen(context, marks, camera, cell);
        context.restore();
    });
    drawnFrame = state.frame;
    showNumbers();
};
const wantDraw = () => {
    if (drawWanted) return;
    drawWanted = true;
    requestAnimationFrame(() => {
        if (drawWanted) draw();
    });
};

// ---- what is written ----

const showNumbers = () => {
    const {frame} = state;
    $("scrub").value = String(frame);
    const text = `${(frame * seconds).toFixed(3)} s, frame ${frame} of ${lastFrame}`;
    $("scrub").setAttribute("aria-valuetext", text);
    $("time").textContent = text;
    plots.forEach((plot) => plot.show(frame));
    labelCells();
    showFacts();
};

const labelCells = () => {
    const texts = state.mode === "ghost" ? [tracks.map(({stage}, i) => stage.label + (i ? " (ghost)" : "")).join(" · ")] : tracks.map(({stage}) => stage.label);
    showLabels(areas(), texts);
};

const showLegend = () => {
    const camera = tracks[0].stage.camera;
    const pixels = $("view").clientHeight / (2 * norm(minus(camera.eye, camera.target)) * halfTangent(camera.field_of_view));
    $("legend").replaceChildren(...legendLines(tracks.map(({stage}) => stage), state.show, about.legend, unitsAMetre, pixels));
};

const fact = (name, value) => {
    const line = document.createElement("div"), term = document.createElement("dt"), text = document.createElement("dd");
    term.textContent = name;
    text.textContent = value;
    line.append(term, text);
    return line;
};
const showFacts = () => {
    if (!state.chosen) {
        $("facts").replaceChildren();
        return;
    }
    const {run, body} = state.chosen, track = tracks[run], {bodies, gravity, recorded} = track.stage;
    const facts = factsOf(run, body);
    const vector = (v) => v.map((x) => shortNumber(Math.abs(x) < 1e-9 ? 0 : x)).join(", ");
    const lines = [fact("Name", bodies[body].name), fact("Mass", facts.mass === null ? "static" : `${shortNumber(facts.mass)} kg`),
        fact("Position", `${vector(facts.position)} m`)];
    if (recorded.includes(body)) {
        lines.push(fact(facts.isStored ? "Speed" : "Speed between frames", `${shortNumber(facts.speed)} m/s`));
        if (facts.kinetic !== null) lines.push(fact("Turning", `${shortNumber(norm(facts.angular))} rad/s`), fact("Kinetic energy", `${shortNumber(facts.kinetic)} J`));
        if (facts.mass !== null && norm(gravity) > 0) lines.push(fact("Potential energy", `${shortNumber(facts.potential)} J`));
    }
    if (facts.forces) {
        for (const {by, force, points} of facts.forces.slice(0, 8)) {
            lines.push(fact(`Force by ${by}${points > 1 ? `, ${points} points` : ""}`, `${shortNumber(norm(force))} N (${vector(force)})`));
        }
        if (!facts.forces.length) lines.push(fact("Forces", "none but weight"));
        else lines.push(fact("All of these", `${shortNumber(norm(facts.sum))} N (${vector(facts.sum)})`));
    }
    $("facts").replaceChildren(...lines);
};
const factsOf = (run, body) => {
    const track = tracks[run], {bodies, gravity, recorded} = track.stage, described = bodies[body];
    const position = placeOf({run, body}), index = recorded.indexOf(body);
    const moving = index < 0 ? null : velocityOf(run, index);
    const mass = described.mass === undefined ? null : described.mass;
    let kinetic = null;
    if (mass !== null && moving && moving.isStored) {
        const {orientation} = track.poses(state.frame);
        const own = rotated(conjugate([...orientation.subarray(4 * body, 4 * body + 4)]), moving.angular);
        kinetic = 0.5 * mass * dot(moving.linear, moving.linear) + 0.5 * own.reduce((sum, w, k) => sum + described.moments[k] * w * w, 0);
    }
    let forces = null, sum = [0, 0, 0];
    if (about.parts.includes("forces")) {
        const acting = track.acting(state.frame), by = new Map();
        for (let at = 0; at < acting.length; at += actingSize) {
            const isOn = acting[at + 1] === body;
            // A contact is listed once, a distance or joint at each movable end.
            if (!isOn && !(acting[at + 2] === body && acting[at] < 2)) continue;
            const force = times(isOn ? 1 : -1, [acting[at + 6], acting[at + 7], acting[at + 8]]);
            if (norm(force) === 0) continue;
            const other = bodies[acting[at + (isOn ? 2 : 1)]].name;
            const name = acting[at] < 2 ? other : acting[at] === 2 ? `bar to ${other}` : acting[at] === 3 ? `joint to ${other}` : "the scene";
            const found = by.get(name) || {by: name, force: [0, 0, 0], points: 0};
            found.force = add(found.force, force);
            ++found.points;
            by.set(name, found);
            sum = add(sum, force);
        }
        forces = [...by.values()].sort((a, b) => norm(b.force) - norm(a.force));
    }
    return {name: described.name, mass, position, velocity: moving && moving.linear, angular: moving && moving.angular,
        isStored: Boolean(moving && moving.isStored), speed: moving ? norm(moving.linear) : 0, kinetic,
        potential: mass === null ? 0 : -mass * dot(gravity, position), forces, sum};
};

// ---- choosing a body ----

const hitDistance = (body, from, along, meshes) => {
    const origin = rotated(conjugate(body.orientation), minus(from, body.position)), ray = rotated(conjugate(body.orientation), along);
    if (body.kind === "spheres") {
        const middle = -dot(origin, ray), square = dot(origin, origin) - middle * middle, rest = body.bevel * body.bevel - square;
        return rest < 0 || middle < 0 ? Infinity : middle - Math.sqrt(rest);
    }
    if (body.kind === "boxes") {
        let near = -Infinity, far = Infinity;
        for (let k = 0; k < 3; ++k) {
            const one = (-body.half[k] - origin[k]) / ray[k], two = (body.half[k] - origin[k]) / ray[k];
            near = Math.max(near, Math.min(one, two));
            far = Math.min(far, Math.max(one, two));
        }
        return near <= far && far > 0 ? near : Infinity;
    }
    const {vertices, indices} = meshes[body.mesh];
    const corner = (i) => [0, 1, 2].map((k) => vertices[6 * i + k] * (body.half[k] - body.bevel) + vertices[6 * i + 3 + k] * body.bevel);
    let nearest = Infinity;
    for (let i = 0; i < indices.length - 2; i += 3) {
        const a = corner(indices[i]), b = minus(corner(indices[i + 1]), a), c = minus(corner(indices[i + 2]), a);
        const p = cross(ray, c), d = dot(b, p);
        if (Math.abs(d) < 1e-30) continue;
        const t = minus(origin, a), u = dot(t, p) / d, q = cross(t, b), v = dot(ray, q) / d, s = dot(c, q) / d;
        if (u >= 0 && v >= 0 && u + v <= 1 && s > 0) nearest = Math.min(nearest, s);
    }
    return nearest;
};
const bodyAt = (x, y) => {
    const box = $("view").getBoundingClientRect(), ratio = $("picture").width / box.width;
    const px = (x - box.left) * ratio, py = (y - box.top) * ratio;
    const cells = areas();
    const index = cells.findIndex((cell) => px >= cell.x && py >= cell.y && px < cell.x + cell.width && py < cell.y + cell.height);
    if (index < 0) return null;
    const cell = cells[index], camera = cameraOf(index, cell);
    const forward = unit(minus(camera.target, camera.eye)), right = unit(cross(forward, screenUp(forward))), up = cross(right, forward);
    const half = halfTangent(camera.fieldOfView), aspect = cell.width / cell.height;
    const along = unit(add(forward, add(times((2 * (px - cell.x) / cell.width - 1) * half * aspect, right), times((1 - 2 * (py - cell.y) / cell.height) * half, up))));
    let best = null;
    for (const run of state.mode === "ghost" ? tracks.map((_, i) => i) : [index]) {
        for (const body of stages[run].bodies) {
            const distance = hitDistance(body, camera.eye, along, tracks[run].meshes);
            if (distance < (best ? best.distance : Infinity)) best = {run, body: body.index, distance};
        }
    }
    return best && {run: best.run, body: best.body};
};
const choose = (chosen) => {
    state.chosen = chosen;
    $("which").value = chosen ? `${chosen.run}:${chosen.body}` : "";
    $("follow").disabled = !chosen;
    setFollow(state.follows && chosen);
    if (chosen) say(`${tracks[chosen.run].stage.bodies[chosen.body].name} is chosen.`);
    wantDraw();
    noteAddress();
};

// ---- clock ----

let started = null;  // when playing: the time and the frame at which it began
const setPlaying = (on) => {
    if (on && state.frame >= lastFrame) state.frame = 0;
    state.isPlaying = on && lastFrame > 0;
    started = null;
    $("play").textContent = state.isPlaying ? "❚❚" : "▶";
    $("play").setAttribute("aria-label", state.isPlaying ? "Pause" : "Play");
    if (state.isPlaying) requestAnimationFrame(tick); else noteAddress();
};
const tick = (now) => {
    if (!state.isPlaying) return;
    if (!started) started = {now, frame: state.frame};
    const frame = Math.min(started.frame + Math.floor((now - started.now) / 1000 * state.speed / seconds + 1e-6), lastFrame);
    const next = Math.min(tracks[0].block(frame).first + tracks[0].block(frame).count, lastFrame);
    tracks.forEach((track) => track.isReady(next, wantedParts()));  // inflates the block to come
    if (frame !== state.frame) {
        if (isReady(frame)) {
            state.frame = frame;
            draw();
        } else {
            started = null;  // waits
        }
    }
    if (state.frame >= lastFrame) setPlaying(false); else requestAnimationFrame(tick);
};
const seek = async (frame) => {
    state.frame = clamp(Math.round(Number(frame) || 0), 0, lastFrame);
    started = null;
    await Promise.all(tracks.map((track) => track.load(state.frame, wantedParts())));
    draw();
    noteAddress();
};
const stepBy = (frames) => {
    if (state.isPlaying) setPlaying(false);
    seek(state.frame + frames);
};
const setSpeed = (speed) => {
    state.speed = speed;
    started = null;
    $("speed").value = String(speed);
};

// ---- address ----

let addressTimer = 0;
const addressText = () => {
    const parts = [`t=${Number((state.frame * seconds).toFixed(6))}`];
    const list = (v) => v.map((x) => Number(x.toPrecision(6))).join(",");
    if (document.body.classList.contains("bare")) parts.push("bare");
    if (state.camera) parts.push(`eye=${list(state.camera.eye)}`, `target=${list(state.camera.target)}`, `fov=${Number(state.camera.fieldOfView.toPrecision(6))}`);
    if (state.show.size) parts.push(`show=${[...state.show].join(",")}`);
    if (state.scale) parts.push(`scale=${state.scale}`);
    if (state.mode !== "side") parts.push(`mode=${state.mode}`);
    if (state.chosen) parts.push(`body=${state.chosen.run}:${state.chosen.body}`);
    return "#" + parts.join("&");
};
const noteAddress = () => {
    clearTimeout(addressTimer);
    addressTimer = setTimeout(() => {
        try {
            history.replaceState(null, "", addressText());
        } catch {
            // Some browsers deny it to pages on disk; "Copy link" works all the same.
        }
    }, 400);
};
const readAddress = () => {
    const words = new URLSearchParams(location.hash.slice(1));
    const three = (name) => {
        const numbers = (words.get(name) || "").split(",").map(Number);
        return numbers.length === 3 && numbers.every(Number.isFinite) ? numbers : null;
    };
    document.body.classList.toggle("bare", words.has("bare"));
    const eye = three("eye"), target = three("target"), fov = Number(words.get("fov"));
    state.camera = eye && target && norm(minus(eye, target)) > 0
        ? {eye, target, fieldOfView: fov >= 1 && fov <= 120 ? fov : tracks[0].stage.camera.field_of_view} : null;
    state.show = new Set((words.has("show") ? words.get("show").split(",") : about.overlay.map((item) => item.kind)).filter((kind) => kinds.includes(kind) && canShow(kind)));
    state.scale = clamp(Number(words.get("scale")) || 0, -3, 3);
    state.mode = words.get("mode") === "ghost" && tracks.length > 1 ? "ghost" : "side";
    const [run, body] = (words.get("body") || "").split(":").map(Number);
    state.chosen = tracks[run] && tracks[run].stage.bodies[body] ? {run, body} : null;
    const time = Number(words.get("t"));
    state.frame = clamp(Math.round((Number.isFinite(time) ? time : 0) / seconds), 0, Math.max(lastFrame, 0));
    showControls();
};

// ---- controls ----

const canShow = (kind) => kind === "velocities" || about.parts.includes("forces");
const toggle = (kind) => {
    if (!canShow(kind)) return;
    if (state.show.has(kind)) state.show.delete(kind); else state.show.add(kind);
    showControls();
    wantDraw();
    noteAddress();
};
const setScale = (scale) => {
    state.scale = clamp(Math.round(scale * 20) / 20, -3, 3);
    showControls();
    wantDraw();
    noteAddress();
};
const setMode = (mode) => {
    if (tracks.length < 2) return;
    state.mode = mode;
    showControls();
    wantDraw();
    noteAddress();
};
const showControls = () => {
    for (const box of $("show").querySelectorAll("input")) box.checked = state.show.has(box.value);
    for (const radio of $("mode").querySelectorAll("input")) radio.checked = radio.value === state.mode;
    $("scale").value = String(state.scale);
    $("which").value = state.chosen ? `${state.chosen.run}:${state.chosen.body}` : "";
    $("follow").disabled = !state.chosen;
    showLegend();
};

const speedName = (speed) => speed < 1 ? `1/${Number((1 / speed).toPrecision(3))}` : String(speed);
const makeControls = () => {
    $("scrub").max = String(Math.max(lastFrame, 0));
    const speeds = [...new Set([1 / 16, 1 / 8, 1 / 4, 1 / 2, 1, 2, 4, 8, about.play_speed])].sort((a, b) => a - b);
    $("speed").append(...speeds.map((speed) => new Option(`× ${speedName(speed)}`, String(speed))));
    setSpeed(about.play_speed);
    const changeSpeed = (steps) => setSpeed(speeds[clamp(speeds.indexOf(state.speed) + steps, 0, speeds.length - 1)]);
    kinds.forEach((kind) => {
        const label = kindBox(kind, about.legend, toggle);
        if (canShow(kind)) return;
        label.querySelector("input").disabled = true;
        label.title = "This file has poses only";
    });
    $("mode").hidden = tracks.length < 2;
    const options = [new Option("none", "")];
    tracks.forEach((track, run) => track.stage.bodies.forEach((body, i) => {
        if (body.name === "world" && i === track.stage.bodies.length - 1 && !body.box && !body.plane) return;
        options.push(new Option(tracks.length > 1 ? `${body.name} (${track.stage.label})` : body.name, `${run}:${i}`));
    }));
    $("which").append(...options);
    $("which").addEventListener("change", () => {
        const [run, body] = $("which").value.split(":").map(Number);
        choose($("which").value ? {run, body} : null);
    });
    const chooseNext = (step) => {
        const values = options.map((option) => option.value);
        $("which").value = values[(values.indexOf($("which").value) + step + values.length) % values.length];
        $("which").dispatchEvent(new Event("change"));
    };
    $("play").addEventListener("click", () => setPlaying(!state.isPlaying));
    $("back").addEventListener("click", () => stepBy(-1));
    $("forward").addEventListener("click", () => stepBy(1));
    $("scrub").addEventListener("input", () => {
        if (state.isPlaying) setPlaying(false);
        seek($("scrub").value);
    });
    $("speed").addEventListener("change", () => setSpeed(Number($("speed").value)));
    $("scale").addEventListener("input", () => setScale(Number($("scale").value)));
    for (const radio of $("mode").querySelectorAll("input")) radio.addEventListener("change", () => setMode(radio.value));
    $("home").addEventListener("click", resetCamera);
    $("fit").addEventListener("click", fitCamera);
    $("follow").addEventListener("click", () => setFollow(!state.follows));
    $("link").addEventListener("click", () => copy(location.href.split("#")[0] + addressText(), $("link"), "Copy link"));

    const turn = 0.06;
    const keys = {
        " ": () => setPlaying(!state.isPlaying), ArrowLeft: (event) => stepBy(event.shiftKey ? -10 : -1), ArrowRight: (event) => stepBy(event.shiftKey ? 10 : 1),
        Home: () => stepBy(-state.frame), End: () => stepBy(lastFrame), "[": () => changeSpeed(-1), "]": () => changeSpeed(1),
        "+": () => setScale(state.scale + 0.25), "=": () => setScale(state.scale + 0.25), "-": () => setScale(state.scale - 0.25),
        a: () => turnCamera(turn, 0), d: () => turnCamera(-turn, 0), w: () => turnCamera(0, turn), s: () => turnCamera(0, -turn),
        A: () => moveCamera(-0.05, 0), D: () => moveCamera(0.05, 0), W: () => moveCamera(0, 0.05), S: () => moveCamera(0, -0.05),
        q: () => zoomCamera(0.93), e: () => zoomCamera(1 / 0.93), 0: resetCamera, f: fitCamera, b: () => setFollow(!state.follows),
        n: () => chooseNext(1), p: () => chooseNext(-1), Escape: () => choose(null), g: () => setMode(state.mode === "side" ? "ghost" : "side"),
    };
    kinds.forEach((kind, i) => { keys[String(i + 1)] = () => toggle(kind); });
    document.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const {tagName, type} = event.target;
        // Controls keep their own keys: buttons the space bar, sliders and lists the arrows and letters.
        if (tagName === "SELECT" || (tagName === "INPUT" && (type !== "checkbox" || event.key === " "))) {
            if (event.target !== $("scrub") || event.key.startsWith("Arrow") || event.key === "Home" || event.key === "End") return;
        }
        if ((tagName === "BUTTON" || tagName === "SUMMARY") && event.key === " ") return;
        const action = keys[event.key] || keys[event.key.toLowerCase()];
        if (!action) return;
        event.preventDefault();
        action(event);
    });
    listenToPointer($("view"), {turn: turnCamera, move: moveCamera, zoom: zoomCamera, click: (x, y) => choose(bodyAt(x, y))});
};

const makeTexts = () => {
    document.title = `${about.scene} – Pushfactor replay`;
    $("title").textContent = about.scene;
    $("caption").textContent = [about.caption.split("   ").slice(1).join(" · "), about.compared ? `compared: ${about.compared}` : ""].filter(Boolean).join(" · ");
    $("command").textContent = about.command;
    const rows = [["Command", about.command], ["Version", about.version]];
    tracks.forEach(({stage}, i) => {
        const of = stage.label ? `, ${stage.label}` : "";
        const run = end.runs[i];
        if (run) rows.push([`State hash${of}`, `${run.state_hash} after step ${run.steps}, ${shortNumber(run.time)} s`]);
        rows.push([`Options${of}`, Object.entries(stage.options).map(([name, text]) => `--${name} ${text}`).join(" ")]);
    });
    rows.push(["Frames", `${end.frames}, one per ${shortNumber(seconds)} s`]);
    rows.push(["Accuracy", "positions to 1e-4 of the radius of a body's bounding sphere, orientations to 1e-4 rad" + (about.parts.includes("forces") ? ", forces to 1e-3" : "; the file has poses only")]);
    fillTable($("about").tBodies[0], rows.slice(1));
    fillTable($("keys").tBodies[0], keyTable);
    if (end.note) {
        $("note").textContent = `The run stopped early: ${end.note}`;
        $("note").hidden = false;
    }
    const texts = {command: () => about.command, about: () => rows.map(([name, text]) => `${name}: ${text}`).join("\n")};
    for (const button of document.querySelectorAll("button.copy")) {
        const label = button.textContent;
        button.addEventListener("click", () => copy(texts[button.dataset.of](), button, label));
    }
};

const makePlots = async () => {
    for (const track of tracks) {
        for (const first of track.firsts) await track.openMeasures(first);
    }
    const several = tracks.length > 1;
    plots = measures.map((measure) => {
        // Of several runs only the sum of the energies.
        const of = several ? measure.of.slice(-1) : measure.of;
        const lines = tracks.flatMap((track) => of.map(([name, values]) => ({name: several ? track.stage.label : name, values: values(track.measures)})));
        return new Plot($("lines"), measure, lines, (frame) => frame * seconds, (frame) => {
            if (state.isPlaying) setPlaying(false);
            seek(frame);
        });
    });
    plots.forEach((plot) => {
        plot.prepare();
        plot.show(state.frame);
    });
};

const resized = () => {
    plots.forEach((plot) => {
        plot.prepare();
        plot.show(state.frame);
    });
    showLegend();
    wantDraw();
};

// ---- for other programs ----

const api = {
    version: 1,
    get frames() { return end.frames; },
    get secondsAFrame() { return seconds; },
    get frame() { return drawnFrame; },
    get runs() { return tracks.map(({stage}) => stage.label); },
    get stateHashes() { return end.runs.map((run) => run.state_hash); },
    bodies: (run = 0) => tracks[run].stage.bodies.map(({name}) => name),
    recorded: (run = 0) => [...tracks[run].stage.recorded],
    units: (run = 0) => tracks[run].stage.bodies.map((body) => body.unit),
    // A point of the world in CSS pixels of the window; null behind the eye.
    onPage: (point, run = 0) => {
        const cell = areas()[state.mode === "ghost" ? 0 : run], box = $("view").getBoundingClientRect();
        const place = new Marks(null, cameraOf(run, cell), cell).place(point), ratio = $("picture").width / $("view").clientWidth;
        return place && [box.left + $("view").clientLeft + place[0] / ratio, box.top + $("view").clientTop + place[1] / ratio];
    },
    seek,
    play: () => setPlaying(true),
    pause: () => setPlaying(false),
    pose: (body, run = 0) => {
        const {position, orientation} = tracks[run].poses(drawnFrame);
        return {position: [...position.subarray(3 * body, 3 * body + 3)], orientation: [...orientation.subarray(4 * body, 4 * body + 4)]};
    },
    poses: (run = 0) => {
        const {position, orientation} = tracks[run].poses(drawnFrame);
        return {positions: [...position], orientations: [...orientation]};
    },
    facts: async (body, run = 0) => {
        for (const name of about.parts) await tracks[run].part(name, state.frame);
        return factsOf(run, body);
    },
    acting: async (run = 0) => {
        if (!about.parts.includes("forces")) return [];
        await tracks[run].part("forces", state.frame);
        const list = tracks[run].acting(state.frame), items = [];
        for (let at = 0; at < list.length; at += actingSize) {
            const three = (k) => [...list.subarray(at + k, at + k + 3)];
            items.push({kind: ["touching", "within margin", "distance", "joint", "outside"][list[at]], body: list[at + 1], other: list[at + 2],
                place: three(3), force: three(6), push: three(9), lastingPush: three(12)});
        }
        return items;
    },
    camera: (run = 0) => cameraOf(run, areas()[state.mode === "ghost" ? 0 : run]),
    setCamera: (camera) => {
        state.camera = camera && {eye: [...camera.eye], target: [...camera.target], fieldOfView: camera.fieldOfView || tracks[0].stage.camera.field_of_view};
        draw();
    },
    show: async (list) => {
        state.show = new Set(list.filter((kind) => kinds.includes(kind) && canShow(kind)));
        showControls();
        await seek(state.frame);
    },
    choose: async (body, run = 0) => {
        choose(body === null ? null : {run, body});
        await seek(state.frame);
    },
    setMode: async (mode) => {
        setMode(mode);
        await seek(state.frame);
    },
    // Milliseconds to draw the current frame, finished by the GPU, the mean of `count`.
    timeDrawing: (count = 10) => {
        const gl = painter.gl, pixel = new Uint8Array(4);
        const begin = performance.now();
        for (let i = 0; i < count; ++i) {
            draw();
            gl.bindFramebuffer(gl.FRAMEBUFFER, null);
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
        }
        return (performance.now() - begin) / count;
    },
};

const start = async () => {
    if (typeof DecompressionStream === "undefined") throw new Error("this browser lacks DecompressionStream, which inflates the data; browsers since 2023 have it");
    for (let run = 0; run < about.runs; ++run) tracks.push(new Track(run, about));
    await Promise.all(tracks.map((track, run) => track.open(end.cameras[run])));
    if (end.frames === 0) throw new Error("the file has no frame");
    const common = meshesIn(await inflated($("meshes").textContent));
    try {
        painter = new Painter($("picture"), JSON.parse($("shaders").textContent), common);
    } catch (error) {
        if (error.message !== "WebGL 2 is missing") throw error;
        fail("This page draws with WebGL 2, which this browser does not have or has switched off. Numbers and plots are below; the picture is not.");
        $("view").hidden = true;
    }
    stages = tracks.map((track) => new Stage(track));
    makeTexts();
    $("player").hidden = false;
    makeControls();
    readAddress();
    if (!painter) painter = {clearPage() {}, draw() {}};
    await seek(state.frame);
    addEventListener("hashchange", async () => {
        readAddress();
        await seek(state.frame);
    });
    new ResizeObserver(resized).observe($("view"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", resized);
    $("picture").addEventListener("webglcontextlost", (event) => {
        event.preventDefault();
        fail("The graphics driver has stopped; reload the page.");
    });
    api.firstFrameMs = performance.now();
    makePlots();
};
api.ready = start().catch((error) => {
    fail(`This replay cannot be shown: ${error.message}`);
    throw error;
});
window.pushfactor = api;
