// Drawable instances of a run at one frame, as renderer/picture makes them of a picture.
const boxBevel = 0.08;  // of the smallest half extent

// Shortest rotation from the y axis to a direction or its opposite, whichever is nearer.
const turnFromY = (direction) => {
    const d = direction[1] < 0 ? times(-1, direction) : direction;
    const q = [1 + d[1], d[2], 0, -d[0]];
    const length = Math.hypot(...q);
    return q.map((x) => x / length);
};

class Stage {
    constructor(track) {
        this.track = track;
        const {stage} = track;
        this.bodies = [];  // drawn ones
        this.panels = [];
        this.ground = null;
        this.towardsSun = unit(stage.towards_sun);
        const numbers = {boxes: 0, spheres: 0, polyhedra: 0};
        stage.bodies.forEach((body, index) => {
            const kind = body.box ? "boxes" : body.sphere !== undefined ? "spheres" : body.polyhedron !== undefined ? "polyhedra" : null;
            if (body.plane && body.plane.length) {
                const local = body.plane.map((corner) => rotated(conjugate(body.orientation), minus(corner, body.position)));
                this.panels.push({body: index, corners: local});
            }
            if (!kind) return;
            const half = body.box || (kind === "spheres" ? [body.sphere, body.sphere, body.sphere] : body.half_extents);
            this.bodies.push({
                kind, index, half, number: numbers[kind]++, mesh: body.polyhedron, colour: linearLight(body.colour),
                bevel: kind === "boxes" ? boxBevel * Math.min(...half) : kind === "spheres" ? body.sphere : body.roundness,
                radius: norm(half), position: [0, 0, 0], orientation: [1, 0, 0, 0],
            });
        });
        // A level plane is the ground, the last one of several; one that is only drawn is no body.
        if (stage.ground !== undefined) {
            const planes = stage.bodies.map((body, index) => ({body, index})).filter(({body}) => body.plane && rotated(body.orientation, [0, 1, 0])[1] > 0.9999);
            this.ground = {height: stage.ground, body: planes.length ? planes[planes.length - 1].index : -1};
            this.panels = this.panels.filter((panel) => !planes.some(({index}) => index === panel.body));
        }
    }

    // Everything at a frame, by kind.
    at(frame) {
        const {stage} = this.track;
        const {position, orientation} = this.track.poses(frame);
        const place = (i) => [position[3 * i], position[3 * i + 1], position[3 * i + 2]];
        const turn = (i) => [orientation[4 * i], orientation[4 * i + 1], orientation[4 * i + 2], orientation[4 * i + 3]];
        const point = (i, p) => add(place(i), rotated(turn(i), p));
        for (const body of this.bodies) {
            body.position = place(body.index);
            body.orientation = turn(body.index);
        }
        const bars = [];
        const bar = (from, to, radius) => {
            const length = norm(minus(to, from));
            bars.push({
                position: times(0.5, add(from, to)), bevel: radius, number: bars.length, colour: barColour,
                orientation: turnFromY(length > 0 ? times(1 / length, minus(to, from)) : [0, 1, 0]),
                half: [radius, 0.5 * length + radius, radius], radius: Math.hypot(radius, 0.5 * length + radius, radius),
            });
        };
        for (const link of stage.links) {
            const from = point(link.a, link.point_a), to = point(link.b, link.point_b);
            if (link.spring_length !== undefined) {
                const along = minus(to, from);
                if (norm(along) === 0) continue;
                const bends = 10, aside = times(0.06 * link.spring_length, orthogonal(along));
                let last = from;
                for (let bend = 1; bend <= bends; ++bend) {
                    const next = add(add(from, times((bend - 0.5) / bends, along)), times(bend % 2 ? -1 : 1, aside));
                    bar(last, next, link.radius);
                    last = next;
                }
                bar(last, to, link.radius);
            } else {
                const half = link.half_pin ? rotated(turn(link.a), link.half_pin) : [0, 0, 0];
                bar(minus(from, half), add(to, half), link.radius);
            }
        }
        const ground = this.ground && {height: this.ground.body >= 0 ? position[3 * this.ground.body + 1] : this.ground.height};
        const panels = this.panels.map((panel) => ({corners: panel.corners.map((corner) => point(panel.body, corner))}));
        const of = (kind) => this.bodies.filter((body) => body.kind === kind);
        return {boxes: of("boxes"), spheres: of("spheres"), polyhedra: of("polyhedra"), bars, ground, panels, towardsSun: this.towardsSun,
            meshes: this.track.meshes};
    }
}
const barColour = linearLight([0.3, 0.3, 0.3]);
