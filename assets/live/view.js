// The picture of runs side by side: camera, cells, what is drawn over them.
class View {
    // `changed` is called when the camera has been moved; `labels` gives the text of each cell; `decorate(marks, i)`
    // adds marks to it.
    constructor(painter, legend, changed) {
        this.painter = painter;
        this.legend = legend;
        this.changed = changed;
        this.show = new Set();
        this.scale = 0;
        this.camera = null;
        this.runs = [];
        this.labels = [];
        this.decorate = () => {};
        this.start = ({eye, target}) => ({eye: [...eye], target: [...target]});  // of the scene's own camera
        this.largest = {};
        this.wanted = false;
        listenToPointer($("view"), {
            turn: (right, up) => this.move(() => turnEye(this.own(), right, up)),
            move: (right, up) => this.move(() => shiftCamera(this.own(), right, up)),
            zoom: (factor) => this.move(() => zoomEye(this.own(), factor)),
            click: () => {},
        });
    }

    // What is drawn from now on: runs with stage, meshes, poses(), acting(), velocity(i), placeOf(body).
    take(runs, labels) {
        this.runs = runs;
        this.labels = labels;
        this.stages = runs.map((run) => new Stage({stage: run.stage, meshes: run.meshes, poses: () => run.poses()}));
        this.largest = {};
    }

    first(i) {
        const {camera} = this.runs[i].stage;
        return {...this.start(camera), fieldOfView: camera.field_of_view};
    }
    own() {
        if (!this.camera) this.camera = this.first(0);
        return this.camera;
    }
    move(change) {
        if (!this.runs.length) return;
        change();
        this.want();
        this.changed();
    }
    home() {
        this.camera = null;
        this.want();
        this.changed();
    }
    fit() {
        const balls = this.runs.flatMap((run) => run.stage.recorded.map((body) => ({centre: run.placeOf(body), radius: run.stage.bodies[body].unit})));
        const [cell] = this.cells();
        this.move(() => frameBalls(this.own(), balls, cell.width / cell.height));
    }

    shown() { return this.runs.map(({stage}) => stage); }
    cells() { return cellsOf($("picture"), this.shown()); }
    cameraOf(i, cell) {
        const camera = this.camera || this.first(i), aspect = cell.width / cell.height;
        return this.runs.length > 1 || aspect < 1.7 ? shownAcross(camera, acrossOf(this.shown()), aspect) : camera;
    }

    // The largest arrow so far has at most a fifth of what is between eye and target.
    unitsAMetre(kind) {
        const {eye, target} = this.first(0);
        return roundUp(Math.max(this.largest[kind] || 0, 1e-6)) / (0.2 * norm(minus(eye, target))) / 2 ** this.scale;
    }
    measure() {
        const most = (kind, value) => { this.largest[kind] = Math.max(this.largest[kind] || 0, value); };
        for (const run of this.runs) {
            run.stage.recorded.forEach((_, i) => most("velocities", norm(run.velocity(i))));
            const list = run.acting();
            for (let at = 0; at < list.length; at += actingSize) {
                const length = (k) => Math.hypot(list[at + k], list[at + k + 1], list[at + k + 2]);
                most("forces", length(6));
                most("push", Math.max(length(9), length(12)));
            }
        }
    }

    want() {
        if (this.wanted) return;
        this.wanted = true;
        requestAnimationFrame(() => {
            this.wanted = false;
            this.draw();
        });
    }

    draw() {
        if (!this.runs.length || !this.painter) return;
        fitCanvases();
        const {width, height} = $("picture");
        this.measure();
        this.painter.clearPage();
        const context = $("marks").getContext("2d");
        context.clearRect(0, 0, width, height);
        const cells = this.cells();
        cells.forEach((cell, i) => {
            const camera = this.cameraOf(i, cell), run = this.runs[i];
            this.painter.draw([this.stages[i].at(0)], camera, {...cell, y: height - cell.y - cell.height});
            context.save();
            context.beginPath();
            context.rect(cell.x, cell.y, cell.width, cell.height);
            context.clip();
            const marks = new Marks(context, camera, cell);
            const scale = (kind) => this.unitsAMetre(kind);
            drawActing(marks, run.acting(), this.show, this.legend, scale);
            if (this.show.has("velocities")) {
                run.stage.recorded.forEach((body, k) => drawVelocity(marks, run.placeOf(body), run.velocity(k), run.stage.bodies[body], this.legend, scale));
            }
            this.decorate(marks, i);
            marks.draw();
            context.restore();
        });
        this.label(cells);
    }

    label(cells) {
        const {eye, target, fieldOfView} = this.first(0);
        const pixels = $("view").clientHeight / (2 * norm(minus(eye, target)) * halfTangent(fieldOfView));
        $("legend").replaceChildren(...legendLines(this.shown(), new Set([...this.show].filter((kind) => kind === "contacts" || this.largest[kind] > 0)), this.legend, (kind) => this.unitsAMetre(kind), pixels));
        showLabels(cells, this.labels);
    }
}
