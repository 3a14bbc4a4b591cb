// Figure 7 with the hands on: the same stack under three pushes.
const pushes = [
    {name: "none", label: "a) no push", heading: "a) No push factor", text: "The contacts only try to stop cubes from sinking deeper."},
    {name: "persistent", label: "b) persistent push", heading: "b) Original method: persistent push", text: "The forces that part the cubes also set the velocity that they keep."},
    {name: "single-frame", label: "c) single-frame push", heading: "c) Improved method: single-frame push", text: "The push moves the cubes, and is forgotten after the step."},
];
const sliderTable = [
    {name: "beta", label: "β, share of the overlap per step", low: 0, high: 1, step: 0.05, value: 0.2},
    {name: "iterations", label: "Sweeps (iterations)", low: 1, high: 100, step: 1, value: 25},
    {name: "overlap", label: "Overlap of the cubes", unit: "m", low: -0.2, high: 1, step: 0.05, value: 0.4},
    {name: "dt", label: "Step Δt", unit: "s", values: ["1/15", "1/30", "1/60", "1/120", "1/240"], value: "1/60"},
    {name: "count", label: "Cubes", low: 1, high: 10, step: 1, value: 5},
];
const moves = 0.3, overlaps = 0.05;  // m/s and m, where the words change

// Options of the command line for the values of sliders; what the scene and the preset have anyway is left out.
const stackOptions = (values, push) => {
    const options = [["preset", "paper"], ["push", push]];
    if (values.beta !== 0.2) options.push(["beta", String(values.beta)]);
    if (values.iterations !== 25) options.push(["iterations", String(values.iterations)]);
    if (values.dt !== "1/60") options.push(["dt", values.dt]);
    if (values.count !== 5) options.push(["count", String(values.count)]);
    if (values.overlap !== 0.4) options.push(["gap", String(-values.overlap)]);
    return options.filter(([name, value]) => name !== "push" || value !== "persistent");
};
const wordsOf = (table, values) => table.filter(({name, value}) => values[name] !== value).map(({name}) => [name, String(values[name])]);
// Values that the table allows; others are as at the start.
const valuesFrom = (table, words) => Object.fromEntries(table.map(({name, low, high, values, step, value}) => {
    const text = words.get(name);
    if (text === null) return [name, value];
    if (values) return [name, values.includes(text) ? text : value];
    const number = Number(text);
    return [name, Number.isFinite(number) && text !== "" ? Number(clamp(step === 1 ? Math.round(number) : number, low, high).toPrecision(6)) : value];
}));

class Figure {
    constructor() {
        this.name = "figure";
        this.table = sliderTable;
        this.values = valuesFrom(sliderTable, new URLSearchParams());
        this.autoplay = {until: 0.5, speed: 1 / 4};  // s, as Figure 7; slow enough to see
        this.shows = ["velocities"];
        this.plots = [
            {title: "Speed kept, the largest upwards", unit: "m/s", of: [["", "upwards"]]},
            {title: "Deepest overlap", unit: "m", of: [["", "overlap"]]},
        ];
        $("cards").replaceChildren(...pushes.map(({heading, text}, i) => {
            const card = document.createElement("div"), head = document.createElement("h3"), what = document.createElement("p");
            const numbers = document.createElement("p"), verdict = document.createElement("p");
            card.className = "card";
            card.style.borderTopColor = lineColours[i];
            numbers.className = "numbers";
            head.textContent = heading;
            what.textContent = text;
            card.append(head, what, numbers, verdict);
            return card;
        }));
    }
    read(words) { this.values = valuesFrom(sliderTable, words); }
    words() { return wordsOf(sliderTable, this.values); }
    wishes() { return pushes.map(({name, label}) => ({label, scene: "intersecting-stack", options: stackOptions(this.values, name)})); }
    labels() { return pushes.map(({label}) => label); }
    // What flies stays in view for a while.
    camera({eye, target}) {
        const raised = add(target, [0, 0.9 * target[1], 0]);
        return {eye: add(raised, times(1.75, minus(eye, target))), target: raised};
    }

    refresh(runs) {
        runs.forEach((run, i) => {
            const [, , numbers, verdict] = $("cards").children[i].children;
            const fast = run.measure("upwards"), deep = run.measure("overlap");
            const rising = run.stage.recorded.reduce((sum, _, k) => sum + run.velocity(k)[1], 0) / run.stage.recorded.length;
            numbers.innerHTML = `Speed kept: <b class="velocities"></b> upwards · deepest overlap, in the ground too: <b></b>`;
            const [speed, depth] = numbers.querySelectorAll("b");
            speed.textContent = `${Math.max(fast, 0).toFixed(2)} m/s`;
            depth.textContent = `${deep.toFixed(3)} m`;
            verdict.textContent = run.failed ? `The run stopped: ${run.failed}` : run.step === 0 ? "At the start: at rest, one inside the other."
                : i === 0 ? "What overlaps is not parted."
                : rising > moves ? deep > overlaps ? "They are being parted, at speed." : "They are apart, and keep the speed of the push: they fly."
                : rising < -moves ? "They fall." : deep > overlaps ? "They still overlap, and part." : "They are apart, and at rest.";
        });
    }
}
