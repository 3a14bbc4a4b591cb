// Points and arrows over the picture, as renderer/picture/marks.cpp draws them.
const headBreadth = 3.2, headLength = 3.6;  // of an arrow's head, in widths of its shaft
const css = (colour) => `rgb(${colour.map((c) => Math.round(255 * c)).join(" ")})`;

class Marks {
    // An area of a canvas: x, y from the upper left, width and height in pixels.
    constructor(context, camera, area) {
        this.context = context;
        this.area = area;
        this.worldToClip = cameraView(camera, area.width / area.height);
        this.casing = Math.max(0.7, area.height / 720);
    }

    // In pixels; none in front of the near plane.
    place(point) {
        const [x, y, z, w] = transformed(this.worldToClip, point);
        if (z <= -w || w <= 0) return null;
        return [this.area.x + this.area.width * (0.5 + 0.5 * x / w), this.area.y + this.area.height * (0.5 - 0.5 * y / w)];
    }

    line(from, to, width, colour) {
        const {context} = this;
        context.lineCap = "round";
        context.lineWidth = width;
        context.strokeStyle = colour;
        context.beginPath();
        context.moveTo(...from);
        context.lineTo(...to);
        context.stroke();
    }

    dot(point, colour) {
        const place = this.place(point);
        if (!place) return;
        const {context} = this;
        for (const [radius, fill] of [[Math.max(2, this.area.height / 160) + this.casing, "rgb(255 255 255 / 0.85)"], [Math.max(2, this.area.height / 160), css(colour)]]) {
            context.fillStyle = fill;
            context.beginPath();
            context.arc(place[0], place[1], radius, 0, 2 * Math.PI);
            context.fill();
        }
    }

    arrow(start, end, colour) {
        const from = this.place(start), to = this.place(end);
        if (!from || !to) return;
        const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
        if (length < 2) return;
        const width = Math.min(Math.max(1.5, this.area.height / 220), length / (2 * headLength));
        const back = [(from[0] - to[0]) / length, (from[1] - to[1]) / length];
        const on = (along, aside) => [to[0] + along * back[0] - aside * back[1], to[1] + along * back[1] + aside * back[0]];
        const corners = [to, on(headLength * width, 0.5 * headBreadth * width), on(headLength * width, -0.5 * headBreadth * width)];
        const neck = on(0.5 * headLength * width, 0);
        const {context} = this;
        const head = () => {
            context.beginPath();
            corners.forEach((corner, i) => i ? context.lineTo(...corner) : context.moveTo(...corner));
            context.closePath();
        };
        this.line(from, neck, width + 2 * this.casing, "rgb(255 255 255 / 0.85)");
        context.lineJoin = "round";
        context.lineWidth = 2 * this.casing;
        context.strokeStyle = "rgb(255 255 255 / 0.85)";
        head();
        context.stroke();
        this.line(from, neck, width, css(colour));
        context.fillStyle = css(colour);
        head();
        context.fill();
    }
}
