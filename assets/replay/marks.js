// Points and arrows over the picture, as renderer/picture/marks.cpp draws them, but all light outlines below all colours:
// thousands of arrows are a few paths.
const headBreadth = 3.2, headLength = 3.6;  // of an arrow's head, in widths of its shaft
const css = (colour) => `rgb(${colour.map((c) => Math.round(255 * c)).join(" ")})`;
const casingColour = "rgb(255 255 255 / 0.85)";

class Marks {
    // An area of a canvas: x, y from the upper left, width and height in pixels.
    constructor(context, camera, area) {
        this.context = context;
        this.area = area;
        this.worldToClip = cameraView(camera, area.width / area.height);
        this.casing = Math.max(0.7, area.height / 720);
        this.paths = new Map();  // by colour and width
    }

    // In pixels; none in front of the near plane.
    place(point) {
        const [x, y, z, w] = transformed(this.worldToClip, point);
        if (z <= -w || w <= 0) return null;
        return [this.area.x + this.area.width * (0.5 + 0.5 * x / w), this.area.y + this.area.height * (0.5 - 0.5 * y / w)];
    }

    path(colour, width) {
        const key = `${colour} ${width}`;
        if (!this.paths.has(key)) this.paths.set(key, {colour, width, lines: new Path2D(), areas: new Path2D()});
        return this.paths.get(key);
    }

    dot(point, colour) {
        const place = this.place(point);
        if (!place) return;
        const radius = Math.max(2, this.area.height / 160), {areas: path} = this.path(colour, 0);
        path.moveTo(place[0] + radius, place[1]);
        path.arc(place[0], place[1], radius, 0, 2 * Math.PI);
    }

    arrow(start, end, colour) {
        const from = this.place(start), to = this.place(end);
        if (!from || !to) return;
        const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
        if (length < 2) return;
        const width = Math.min(Math.max(1.5, this.area.height / 220), length / (2 * headLength));
        const back = [(from[0] - to[0]) / length, (from[1] - to[1]) / length];
        const on = (along, aside) => [to[0] + along * back[0] - aside * back[1], to[1] + along * back[1] + aside * back[0]];
        const {lines, areas: heads} = this.path(colour, Math.ceil(4 * width) / 4);
        lines.moveTo(...from);
        lines.lineTo(...on(0.5 * headLength * width, 0));
        heads.moveTo(...to);
        heads.lineTo(...on(headLength * width, 0.5 * headBreadth * width));
        heads.lineTo(...on(headLength * width, -0.5 * headBreadth * width));
        heads.closePath();
    }

    draw() {
        const {context} = this;
        context.lineCap = context.lineJoin = "round";
        for (const {width, lines, areas: filled} of this.paths.values()) {
            context.strokeStyle = casingColour;
            context.lineWidth = width + 2 * this.casing;
            context.stroke(lines);
            context.lineWidth = 2 * this.casing;
            context.stroke(filled);
        }
        for (const {colour, width, lines, areas: filled} of this.paths.values()) {
            context.strokeStyle = context.fillStyle = css(colour);
            if (width > 0) {
                context.lineWidth = width;
                context.stroke(lines);
            }
            context.fill(filled);
        }
    }
}
