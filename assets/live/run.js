// The program in its worker, and a run there with what drawing needs of a replay's track.
class Worked {
    constructor(worker) {
        this.worker = worker;
        this.waiting = new Map();
        this.last = 0;
        worker.onmessage = ({data: {id, answer, error}}) => {
            const {resolve, reject} = this.waiting.get(id);
            this.waiting.delete(id);
            if (error === undefined) resolve(answer); else reject(new Error(error));
        };
        worker.onerror = (event) => {
            for (const {reject} of this.waiting.values()) reject(new Error(event.message || "the worker has stopped"));
            this.waiting.clear();
        };
    }
    call(name, ...args) {
        return new Promise((resolve, reject) => {
            this.waiting.set(++this.last, {resolve, reject});
            this.worker.postMessage({id: this.last, name, args});
        });
    }
}

// Lines of measures of a step, in their order in LiveRun::numbers().
const measureNames = ["kinetic", "potential", "overlap", "speed", "residual", "upwards"];

class Run {
    constructor(program, slot, label) {
        this.program = program;
        this.slot = slot;
        this.label = label;
        this.failed = "";
    }

    // Throws an error with the program's words if it refuses.
    async open(scene, options) {
        const about = await this.program.call("open", this.slot, scene, options);
        if (about.refused || about.failed) throw new Error(about.refused || about.failed);
        this.stage = about;
        this.meshes = meshesIn(about.meshes);
        this.failed = "";
        this.milliseconds = 0;
        this.measures = measureNames.map(() => []);
        this.take(about.now);
    }

    take(answer) {
        if (!answer.numbers) {
            this.failed = answer.failed || answer.refused;
            return;
        }
        this.hash = answer.hash;
        this.command = answer.command;
        this.milliseconds += answer.milliseconds;
        const {numbers} = answer;
        let at = 6;
        const [step, time, lines, bodies, recorded, acting] = numbers;
        const next = (count) => numbers.subarray(at, at += count);
        this.step = step;
        this.time = time;
        for (let line = 0; line < lines; ++line) {
            const values = next(measureNames.length);
            this.measures.forEach((list, i) => list.push(values[i]));
        }
        this.now = {position: next(3 * bodies), orientation: next(4 * bodies)};
        this.velocities = next(6 * recorded);
        this.list = next(actingSize * acting);
    }

    measure(name) {
        const list = this.measures[measureNames.indexOf(name)];
        return list[list.length - 1];
    }
    poses() { return this.now; }
    acting() { return this.list; }
    velocity(i) { return [this.velocities[6 * i], this.velocities[6 * i + 1], this.velocities[6 * i + 2]]; }
    placeOf(body) { return [this.now.position[3 * body], this.now.position[3 * body + 1], this.now.position[3 * body + 2]]; }
}
