// The data of the page as numbers: the counterpart of demos/pictures/replay, where the format is described.
class Integers {
    constructor(bytes, at = 0) {
        this.bytes = bytes;
        this.at = at;
    }
    byte() { return this.bytes[this.at++]; }
    next() {
        let byte = this.bytes[this.at++];
        if (byte < 128) return byte & 1 ? -((byte + 1) >> 1) : byte >> 1;
        let value = byte & 127, scale = 128;
        do {
            byte = this.bytes[this.at++];
            value += (byte & 127) * scale;
            scale *= 128;
        } while (byte >= 128);
        return value % 2 ? -(value + 1) / 2 : value / 2;
    }
}

// Of each quantity the values of all frames, one after the other.
const quantities = (bytes, count, frames) => {
    const numbers = new Integers(bytes);
    const values = new Float64Array(count * frames);
    for (let quantity = 0; quantity < count; ++quantity) {
        const first = quantity * frames;
        const kind = numbers.byte();
        if (kind === 0) {
            values.fill(numbers.next(), first, first + frames);
            continue;
        }
        for (let i = 0; i < frames; ++i) {
            const at = first + i;
            const degree = Math.min(kind - 1, i - 1);
            const foretold = degree < 0 ? 0 : degree === 0 ? values[at - 1] : degree === 1 ? 2 * values[at - 1] - values[at - 2]
                : 3 * (values[at - 1] - values[at - 2]) + values[at - 3];
            values[at] = foretold + numbers.next();
        }
    }
    return values;
};

// Per frame a list of what acts (arrows.js).
const forceFrames = (bytes, frames, units) => {
    const head = new Integers(bytes);
    const lengths = [head.next(), head.next(), head.next(), head.next()];
    let start = head.at;
    const [who, where, force, push] = lengths.map((length) => {
        const part = new Integers(bytes, start);
        start += length;
        return part;
    });
    const lists = [];
    let last = {who: [], raw: new Float64Array(0), index: null};
    for (let frame = 0; frame < frames; ++frame) {
        const length = who.next();
        let list = last.who;
        if (length > 0) {
            list = new Array(3 * (length - 1));
            let body = 0;
            for (let i = 0; i < list.length; i += 3) {
                list[i] = who.next();
                body += who.next();
                list[i + 1] = body;
                list[i + 2] = body + who.next();
            }
        }
        const count = list.length / 3;
        const same = list === last.who;
        // Items of the frame before by kind, bodies, and the number of equal ones before.
        const keys = (items) => {
            const index = new Map(), seen = new Map();
            for (let i = 0; i < items.length / 3; ++i) {
                const key = items[3 * i] + 8 * (items[3 * i + 1] + units.length * items[3 * i + 2]);
                const number = seen.get(key) || 0;
                seen.set(key, number + 1);
                index.set(1024 * key + number, i);
            }
            return index;
        };
        const index = same ? last.index : keys(list);
        const before = new Int32Array(count);
        if (same) {
            for (let i = 0; i < count; ++i) before[i] = i;
        } else {
            if (!last.index) last.index = keys(last.who);
            for (const [key, i] of index) before[i] = last.index.has(key) ? last.index.get(key) : -1;
        }
        // Integers: place, then exponent and three numbers of each vector.
        const raw = new Float64Array(15 * count);
        const out = new Float32Array(actingSize * count);
        for (let i = 0; i < count; ++i) {
            const base = 15 * before[i];
            const from = (k) => before[i] < 0 ? 0 : last.raw[base + k];
            for (let k = 0; k < 3; ++k) raw[15 * i + k] = from(k) + where.next();
            for (let k = 3; k < 15; ++k) raw[15 * i + k] = from(k) + (k < 7 ? force : push).next();
            const to = actingSize * i;
            for (let k = 0; k < 3; ++k) out[to + k] = list[3 * i + k];
            for (let k = 0; k < 3; ++k) out[to + 3 + k] = raw[15 * i + k] * units[list[3 * i + 1]];
            for (let vector = 0; vector < 3; ++vector) {
                const at = 15 * i + 3 + 4 * vector;
                const scale = 2 ** (raw[at] - 10);
                for (let k = 0; k < 3; ++k) out[to + 6 + 3 * vector + k] = raw[at + 1 + k] * scale;
            }
        }
        lists.push(out);
        last = {who: list, raw, index};
    }
    return lists;
};

// The frames of one run, in blocks that are inflated when they are needed and forgotten when there are many.
class Track {
    constructor(run, about) {
        this.run = run;
        this.about = about;
        this.blocks = new Map();  // by first frame
        this.firsts = [];
        this.measures = [];       // kinetic energy, potential energy, overlap, speed, residual: of all frames
        const parts = (part) => document.querySelectorAll(`script[data-part="${part}"][data-run="${run}"]`);
        this.stageText = parts("stage")[0].textContent;
        this.meshText = parts("meshes").length ? parts("meshes")[0].textContent : null;
        for (const part of ["poses", "velocities", "forces", "measures"]) {
            for (const element of parts(part)) {
                const first = Number(element.dataset.first);
                if (!this.blocks.has(first)) {
                    this.blocks.set(first, {first, count: Number(element.dataset.count), elements: {}, loaded: {}, used: 0});
                    this.firsts.push(first);
                }
                this.blocks.get(first).elements[part] = element;
            }
        }
        this.firsts.sort((a, b) => a - b);
        this.clock = 0;
    }

    // `camera` is known at the end of the run.
    async open(camera) {
        this.stage = {...JSON.parse(new TextDecoder().decode(await inflated(this.stageText))), camera};
        this.meshes = this.meshText ? meshesIn(await inflated(this.meshText)) : [];
        this.units = this.stage.bodies.map((body) => body.unit * this.about.units.position);
        const last = this.firsts.length ? this.blocks.get(this.firsts[this.firsts.length - 1]) : {first: 0, count: 0};
        this.frames = last.first + last.count;
        this.measures = [0, 1, 2, 3, 4].map(() => new Float32Array(this.frames).fill(NaN));
    }

    async openMeasures(first) {
        const block = this.blocks.get(first);
        const bytes = await inflated(block.elements.measures.textContent);
        const values = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4);
        this.measures.forEach((measure, i) => measure.set(values.subarray(i * block.count, (i + 1) * block.count), first));
    }

    block(frame) {
        let low = 0, high = this.firsts.length - 1;
        while (low < high) {
            const middle = (low + high + 1) >> 1;
            if (this.firsts[middle] <= frame) low = middle; else high = middle - 1;
        }
        return this.blocks.get(this.firsts[low]);
    }

    // The part of the block that has a frame; a promise the first time, then the part itself.
    part(name, frame) {
        const block = this.block(frame);
        block.used = ++this.clock;
        if (block.loaded[name] === undefined && block.elements[name]) {
            block.loaded[name] = inflated(block.elements[name].textContent).then((bytes) => {
                const recorded = this.stage.recorded.length;
                block.loaded[name] = name === "forces" ? forceFrames(bytes, block.count, this.units)
                    : quantities(bytes, (name === "poses" ? 7 : 6) * recorded, block.count);
                this.forgetOldest(name);
                return block.loaded[name];
            });
        }
        return block.loaded[name];
    }

    forgetOldest(name) {
        const limit = name === "forces" ? 3 : Math.max(4, Math.floor(1.6e7 / (7 * this.stage.recorded.length * this.block(0).count + 1)));
        const held = [...this.blocks.values()].filter((block) => block.loaded[name] && !(block.loaded[name] instanceof Promise));
        held.sort((a, b) => b.used - a.used).slice(limit).forEach((block) => delete block.loaded[name]);
    }

    // Whether everything of this frame that is wanted is there.
    isReady(frame, names) {
        return names.every((name) => {
            const part = this.part(name, frame);
            return !(part instanceof Promise);
        });
    }
    async load(frame, names) {
        for (const name of names) await this.part(name, frame);
    }

    // Poses of all bodies at a frame that is ready: three and four numbers each.
    poses(frame) {
        const {bodies, recorded} = this.stage;
        if (!this.now) {
            this.now = {position: new Float64Array(3 * bodies.length), orientation: new Float64Array(4 * bodies.length)};
            bodies.forEach((body, i) => {
                this.now.position.set(body.position, 3 * i);
                this.now.orientation.set(body.orientation, 4 * i);
            });
        }
        const block = this.block(frame), values = this.part("poses", frame), at = frame - block.first;
        recorded.forEach((body, i) => {
            for (let k = 0; k < 3; ++k) this.now.position[3 * body + k] = values[(7 * i + k) * block.count + at] * this.units[body];
            let square = 0;
            for (let k = 0; k < 4; ++k) {
                const number = values[(7 * i + 3 + k) * block.count + at];
                this.now.orientation[4 * body + k] = number;
                square += number * number;
            }
            for (let k = 0; k < 4; ++k) this.now.orientation[4 * body + k] /= Math.sqrt(square);
        });
        return this.now;
    }

    // Velocity and angular velocity of the i-th recorded body at a frame that is ready; none if they were left out.
    velocity(frame, i) {
        const values = this.part("velocities", frame);
        if (!values || values instanceof Promise) return null;
        const block = this.block(frame), at = frame - block.first;
        const unit = this.about.units.velocity;
        const number = (k) => values[(6 * i + k) * block.count + at] * unit;
        const size = this.stage.bodies[this.stage.recorded[i]].unit;
        return {linear: times(size, [number(0), number(1), number(2)]), angular: [number(3), number(4), number(5)]};
    }

    acting(frame) {
        const lists = this.part("forces", frame);
        return !lists || lists instanceof Promise ? new Float32Array(0) : lists[frame - this.block(frame).first];
    }
}
