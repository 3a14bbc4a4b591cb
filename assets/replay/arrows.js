// Contact points, forces, pushes and velocities over a picture, and their legend. What acts in a step is a list of 15
// numbers each: kind, body, other, place, force, push for this step only, push that lasts.
const kinds = ["contacts", "forces", "push", "velocities"];
const actingSize = 15;

// `show` is a set of kinds; unitsAMetre(kind) scales arrows.
const drawArrow = (marks, place, value, kind, entry, legend, unitsAMetre) =>
    marks.arrow(place, add(place, times(1 / unitsAMetre(kind), value)), legend[kind][entry].colour);
const drawActing = (marks, acting, show, legend, unitsAMetre) => {
    const vector = (at, k) => [acting[at + k], acting[at + k + 1], acting[at + k + 2]];
    if (show.has("contacts")) {
        for (let at = 0; at < acting.length; at += actingSize) {
            if (acting[at] < 2) marks.dot(vector(at, 3), legend.contacts[acting[at]].colour);
        }
    }
    for (const kind of ["forces", "push"]) {
        if (!show.has(kind)) continue;
        const arrow = (at, k, entry) => drawArrow(marks, vector(at, 3), vector(at, k), kind, entry, legend, unitsAMetre);
        for (let at = 0; at < acting.length; at += actingSize) {
            if (kind === "forces") {
                arrow(at, 6, Math.max(0, acting[at] - 1));
            } else {
                arrow(at, 9, 0);
                arrow(at, 12, 1);
            }
        }
    }
};
// Of a body of a stage; one without mass is moved.
const drawVelocity = (marks, place, velocity, body, legend, unitsAMetre) =>
    drawArrow(marks, place, velocity, "velocities", body.mass === undefined ? 1 : 0, legend, unitsAMetre);

const rounded = (value) => {
    const power = 10 ** Math.floor(Math.log10(value)), digit = value / power;
    return power * (digit >= 5 ? 5 : digit >= 2 ? 2 : 1);
};
// A line per colour that may occur, with the length of a round value; `pixels` per metre.
const legendLines = (stages, show, legend, unitsAMetre, pixels) => {
    const occurs = (kind, i) => {
        if (kind === "forces" && i > 0) return stages.some((stage) => i === 3 ? stage.has_outside_forces : stage.links.length > 0);
        if (kind === "velocities" && i > 0) return stages.some((stage) => stage.recorded.some((body) => stage.bodies[body].mass === undefined));
        return true;
    };
    const lines = [];
    for (const kind of kinds.filter((one) => show.has(one))) {
        const camera = stages[0].camera;
        const example = rounded(1.3 * 0.11 * norm(minus(camera.eye, camera.target)) * unitsAMetre(kind));
        legend[kind].forEach(({name, colour, unit: unitText}, i) => {
            if (!occurs(kind, i)) return;
            const line = document.createElement("div"), mark = document.createElement("i"), text = document.createElement("span");
            text.textContent = unitText ? `${name}, ${shortNumber(example)} ${unitText}` : name;
            mark.style.background = css(colour);
            if (unitText) mark.style.width = `${Math.min(example / unitsAMetre(kind) * pixels, 160)}px`; else mark.className = "point";
            line.append(text, mark);
            lines.push(line);
        });
    }
    return lines;
};

// A box that shows a kind or hides it, in the fieldset of the page.
const kindBox = (kind, legend, toggle) => {
    const label = document.createElement("label"), box = document.createElement("input"), swatch = document.createElement("i");
    box.type = "checkbox";
    box.value = kind;
    swatch.style.background = css(legend[kind][0].colour);
    label.append(box, swatch, kind);
    $("show").append(label);
    box.addEventListener("change", () => toggle(kind));
    return label;
};
