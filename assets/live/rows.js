// The step under the microscope: rows of one step of two or three cubes, solved one after the other.
const rowTable = [
    {name: "count", label: "Cubes", low: 1, high: 3, step: 1, value: 2},
    {name: "push", label: "Push", values: ["none", "persistent", "single-frame"], value: "single-frame"},
    {name: "beta", label: "β", low: 0, high: 1, step: 0.05, value: 0.2},
    {name: "overlap", label: "Overlap", unit: "m", low: -0.2, high: 1, step: 0.05, value: 0.4},
    {name: "friction", label: "Friction", values: ["off", "on"], value: "off"},
    {name: "iterations", label: "Sweeps (iterations)", low: 1, high: 50, step: 1, value: 25},
    {name: "moment", label: "Step", low: 1, high: 60, step: 1, value: 1},
];
// With a minus that is as wide as a plus; null is no bound.
const number = (value, digits = 4) => (value === null ? "∞" : Math.abs(value) < 1e-12 ? "0" : Math.abs(value) >= 1e4 || Math.abs(value) < 1e-3
    ? value.toExponential(digits - 2).replace("e+", "e") : String(Number(value.toPrecision(digits)))).replaceAll("-", "−");
const term = (value) => value < -1e-12 ? `(${number(value)})` : number(value);
const bounded = (value, low, high) => Math.max(Math.min(value, high === null ? Infinity : high), low === null ? -Infinity : low);

class Rows {
    constructor() {
        this.name = "rows";
        this.table = rowTable;
        this.values = valuesFrom(rowTable, new URLSearchParams());
        this.at = 0;      // rows that have been solved
        this.data = null;
        this.shows = ["forces"];
        this.plots = [];
        this.changed = () => {};
        $("row-next").addEventListener("click", () => this.go(this.at + 1));
        $("row-sweep").addEventListener("click", () => this.go((Math.floor(this.at / this.count()) + 1) * this.count()));
        $("row-all").addEventListener("click", () => this.go(Infinity));
        $("row-start").addEventListener("click", () => this.go(0));
    }
    read(words) {
        this.values = valuesFrom(rowTable, words);
        this.at = Math.max(0, Math.round(Number(words.get("row")) || 0));
    }
    words() { return [...wordsOf(rowTable, this.values), ...(this.at ? [["row", String(this.at)]] : [])]; }
    wishes() {
        const options = stackOptions({...this.values, dt: "1/60"}, this.values.push);
        if (this.values.friction === "off") options.push(["friction", "0"]);
        return [{label: "", scene: "intersecting-stack", options}];
    }
    // With the largest force so far: of the two solves one is in hundreds of newtons, the other in weights.
    labels() {
        const names = this.data.b.length === 2 ? ["with the push: moves", "without: sets the velocity"] : ["one solve: moves, and sets the velocity"];
        return names.map((name, column) => `${name}; λ up to ${number(Math.max(...this.lambdas(column)), 3)} N`);
    }

    count() { return this.data.rows.length; }
    last() { return this.count() * (this.data.lambda[0].length - 1); }
    go(at) {
        this.at = clamp(at, 0, this.last());
        this.write();
        this.changed();
    }

    // The step's rows, and the runs that the view draws: the bodies at its start, once per solve.
    take(data, run) {
        this.data = data;
        this.at = clamp(this.at, 0, this.last());
        const flat = (key) => Float64Array.from(data.bodies.flatMap(({before}) => before[key]));
        const now = {position: flat("position"), orientation: flat("orientation")};
        const velocities = run.stage.recorded.map((body) => data.bodies[body].before.velocity);
        this.drawn = data.b.map((_, column) => ({
            stage: run.stage, meshes: run.meshes, poses: () => now, acting: () => this.acting(column), velocity: (i) => velocities[i],
            placeOf: (body) => data.bodies[body].before.position,
        }));
        this.makeTable();
        this.write();
        return this.drawn;
    }

    // Row j is solved once a sweep, in order.
    lambda(column, j, at = this.at) {
        const sweep = Math.floor(at / this.count()), done = at % this.count();
        return this.data.lambda[column][j < done ? sweep + 1 : sweep][j];
    }
    lambdas(column, at = this.at) { return this.data.rows.map((_, j) => this.lambda(column, j, at)); }
    // A lambda - b
    misses(column, lambdas) { return this.data.A.map((line, j) => line.reduce((sum, a, i) => sum + a * lambdas[i], -this.data.b[column][j])); }
    bounds(row, lambdas) {
        const factor = row.of_row < 0 ? 1 : lambdas[row.of_row];
        return [row.c_min === null ? null : row.c_min * factor, row.c_max === null ? null : row.c_max * factor];
    }
    // The natural map of each row, m/s: zero where the row, its bounds and its force agree.
    errors(column) {
        const lambdas = this.lambdas(column), {dt, diagonal, rows} = this.data;
        return this.misses(column, lambdas).map((miss, j) => diagonal[j] > 0
            ? dt * diagonal[j] * Math.abs(lambdas[j] - bounded(lambdas[j] - miss / diagonal[j], ...this.bounds(rows[j], lambdas))) : 0);
    }

    bodyName(body) { return this.data.bodies[body].name; }
    rowName(j) {
        const row = this.data.rows[j];
        return `${row.kind}, ${this.bodyName(row.a)} – ${this.bodyName(row.b)}`;
    }

    makeTable() {
        const two = this.data.b.length === 2, table = $("rows");
        const head = (text, span = 1, kind = "") => Object.assign(document.createElement("th"), {innerHTML: text, colSpan: span, scope: "col", className: kind});
        const line = (...cells) => {
            const row = document.createElement("tr");
            row.append(...cells);
            return row;
        };
        table.tHead.replaceChildren(line(head("row"), head("v<sub>j</sub>, m/s", 1, "number push"), head("c<sub>min</sub> to c<sub>max</sub>, N"),
            ...this.data.b.flatMap((_, column) => [head(`λ<sub>j</sub>${two ? column ? " without" : " with push" : ""}, N`, 1, "number forces first"), head("error, m/s", 2)])));
        this.lines = this.data.rows.map((row, j) => {
            const name = Object.assign(document.createElement("th"), {scope: "row", textContent: `${j + 1}  ${this.rowName(j)}`});
            const cell = (kind, text = "") => Object.assign(document.createElement("td"), {className: kind, textContent: text});
            const cells = this.data.b.flatMap(() => [cell("number forces first"), cell("number"), cell("bar")]);
            cells.forEach((one) => { if (one.className === "bar") one.append(document.createElement("i")); });
            const made = line(name, cell("number push", number(row.correcting + row.lasting)), cell(""), ...cells);
            made.addEventListener("click", () => this.go(Math.floor(this.at / this.count()) * this.count() + j + 1));
            made.title = "Solve up to this row";
            return made;
        });
        table.tBodies[0].replaceChildren(...this.lines);
        this.writeMatrices();
    }

    write() {
        const {rows, b} = this.data, next = this.at < this.last() ? this.at % this.count() : -1;
        const lambdas = b.map((_, column) => this.lambdas(column)), errors = b.map((_, column) => this.errors(column));
        this.lines.forEach((line, j) => {
            line.className = j === next ? "next" : "";
            const [low, high] = this.bounds(rows[j], lambdas[0]);
            line.cells[2].textContent = `${low === null ? "−∞" : number(low)} to ${number(high)}`;
            b.forEach((_, column) => {
                line.cells[3 + 3 * column].textContent = number(lambdas[column][j]);
                line.cells[4 + 3 * column].textContent = errors[column][j] < 1e-9 ? "0" : number(errors[column][j], 3);
                const share = clamp((Math.log10(Math.max(errors[column][j], 1e-9)) + 9) / 10, 0, 1);
                line.cells[5 + 3 * column].firstChild.style.width = `${100 * share}%`;
            });
        });
        const sweep = Math.floor(this.at / this.count());
        $("time").textContent = `sweep ${Math.min(sweep + 1, this.data.lambda[0].length - 1)} of ${this.data.lambda[0].length - 1}, ${this.at} of ${this.last()} rows`;
        this.writeFormula(next, lambdas);
        this.writeOutcome(errors);
    }

    writeFormula(next, lambdas) {
        const span = (html) => Object.assign(document.createElement("span"), {innerHTML: html});
        if (next < 0) {
            $("formula").replaceChildren(span("All sweeps are done. These are the forces of this step, to the last bit those that the program has used."));
            return;
        }
        const {rows, A, b, diagonal} = this.data, row = rows[next], two = b.length === 2;
        const lines = [span("")];
        lines[0].textContent = `Next is row ${next + 1}, ${this.rowName(next)}:`;
        b.forEach((_, column) => {
            const sum = A[next].reduce((total, a, i) => total + a * lambdas[column][i], 0);
            const [low, high] = this.bounds(row, lambdas[column]);
            const result = this.lambda(column, next, this.at + 1);
            lines.push(span(`${two ? column ? "without the push: " : "with the push: " : ""}<b class="forces">λ<sub>${next + 1}</sub></b> ← clamp(${number(lambdas[column][next])} + (${number(b[column][next])} − ${term(sum)}) / ${number(diagonal[next])}, ${low === null ? "−∞" : number(low)}, ${number(high)}) = <b class="forces">${number(result)} N</b>`));
        });
        $("formula").replaceChildren(...lines);
    }

    writeOutcome(errors) {
        const {bodies, dt} = this.data;
        const worst = errors.map((list) => list.reduce((most, error) => Math.max(most, error), 0));
        if (this.at < this.last()) {
            $("outcome").textContent = `Largest error now: ${worst.map((error) => `${number(error, 3)} m/s`).join(" with the push, ")}${worst.length === 2 ? " without" : ""}.`;
            return;
        }
        const parts = bodies.filter(({mass}) => mass !== null).map(({name, before, after}) => {
            const moved = (after.position[1] - before.position[1]) / dt;
            const up = (speed) => `<b class="velocities">${number(Math.abs(speed) < 5e-4 ? 0 : speed, 3)} m/s</b>`;
            return `${name} is moved with ${up(moved)} upwards in this step, and keeps ${up(after.velocity[1])}.`;
        });
        $("outcome").innerHTML = `What comes of it: ${parts.join(" ")}`;
    }

    writeMatrices() {
        const {rows, A, b, diagonal} = this.data;
        const table = (title, heads, lines) => {
            const made = document.createElement("table"), caption = document.createElement("caption");
            made.className = "matrix";
            caption.innerHTML = title;
            const head = made.createTHead().insertRow();
            head.append(...["", ...heads].map((text) => Object.assign(document.createElement("th"), {innerHTML: text, scope: "col"})));
            const body = made.createTBody();
            lines.forEach((values, j) => {
                const line = body.insertRow();
                line.append(Object.assign(document.createElement("th"), {textContent: String(j + 1), scope: "row"}));
                values.forEach((value) => {
                    const cell = line.insertCell();
                    cell.textContent = number(value, 3);
                    if (Math.abs(value) < 1e-12) cell.className = "zero";
                });
            });
            const box = document.createElement("div");
            box.className = "scroll";
            box.tabIndex = 0;
            box.setAttribute("role", "region");
            box.setAttribute("aria-label", caption.textContent);
            box.append(made);
            return box;
        };
        const axes = ["v<sub>x</sub>", "v<sub>y</sub>", "v<sub>z</sub>", "ω<sub>x</sub>", "ω<sub>y</sub>", "ω<sub>z</sub>"];
        const numbers = rows.map((_, j) => String(j + 1));
        $("numbers").replaceChildren(
            table("J: how the velocities of both bodies change the gap (6.1.2)", [...axes.map((text) => `a ${text}`), ...axes.map((text) => `b ${text}`)], rows.map(({jacobian}) => jacobian.flat())),
            table("A = J M<sup>−1</sup> J<sup>T</sup>, 1/kg: what a force of one row does to another", numbers, A),
            table("b, m/s², and A<sub>jj</sub>", [...b.map((_, column) => b.length === 2 ? column ? "b without" : "b with push" : "b"), "A<sub>jj</sub>"], rows.map((_, j) => [...b.map((list) => list[j]), diagonal[j]])));
    }

    // As LiveRun::numbers() lists what acts, with the forces so far.
    acting(column) {
        const list = [];
        this.data.contacts.forEach(({row, place, normal, friction_row: first, tangents}) => {
            const {a, b, correcting, lasting} = this.data.rows[row];
            const force = [0, 1, 2].map((k) => normal[k] * this.lambda(column, row)
                + (tangents ? tangents[0][k] * this.lambda(column, first) + tangents[1][k] * this.lambda(column, first + 1) : 0));
            const pushed = (speed) => normal.map((n) => n * speed);
            list.push(0, b, a, ...place, ...force, ...pushed(column === 0 ? correcting : 0), ...pushed(lasting));
        });
        return list;
    }
    // The point of the next row, ringed.
    decorate(marks) {
        if (!this.data || this.at >= this.last()) return;
        const next = this.at % this.count();
        const contact = this.data.contacts.find(({row, friction_row: first}) => row === next || first === next || first + 1 === next);
        const place = contact && marks.place(contact.place);
        if (!place) return;
        const {context} = marks, radius = Math.max(7, marks.area.height / 45);
        for (const [colour, width] of [["rgb(255 255 255 / 0.9)", 5], ["#1f2328", 2.5]]) {
            context.strokeStyle = colour;
            context.lineWidth = width * Math.max(1, marks.area.height / 500);
            context.beginPath();
            context.arc(...place, radius, 0, 2 * Math.PI);
            context.stroke();
        }
    }
}
