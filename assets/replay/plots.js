// Lines over time under the picture, with a cursor. A click or a drag jumps to a time.
const lineColours = ["#7b5cb8", "#c9772a", "#1f7fc4", "#159078", "#d2492f", "#8a8577"];

const roundUp = (value) => {
    const power = 10 ** Math.floor(Math.log10(value));
    return power * ([1, 2, 2.5, 5, 10].find((digit) => digit * power >= value * (1 - 1e-9)) || 10);
};
const shortNumber = (value) => {
    if (!Number.isFinite(value)) return "–";
    if (value === 0) return "0";
    const size = Math.abs(value);
    return size >= 1e5 || size < 1e-3 ? value.toExponential(2).replace("e+", "e") : String(Number(value.toPrecision(4)));
};

class Plot {
    // `lines`: name and values of all frames; `time` of a frame, s.
    constructor(parent, {title, unit: unitText, logarithmic}, lines, time, jump) {
        this.lines = lines;
        this.time = time;
        this.logarithmic = logarithmic;
        this.unitText = unitText;
        this.figure = document.createElement("figure");
        this.figure.className = "plot";
        const caption = document.createElement("figcaption");
        const name = document.createElement("b");
        name.textContent = logarithmic ? `${title} (logarithmic)` : title;
        this.now = document.createElement("span");
        this.now.className = "now";
        caption.append(name, " ", this.now);
        this.canvas = document.createElement("canvas");
        this.canvas.setAttribute("role", "img");
        this.title = title;
        this.figure.append(caption, this.canvas);
        parent.append(this.figure);
        this.canvas.addEventListener("pointerdown", (event) => {
            this.canvas.setPointerCapture(event.pointerId);
            jump(this.frameAt(event));
        });
        this.canvas.addEventListener("pointermove", (event) => {
            if (event.buttons) jump(this.frameAt(event));
        });
    }

    frameAt(event) {
        const box = this.canvas.getBoundingClientRect();
        const share = (event.clientX - box.left - this.left) / Math.max(box.width - this.left - this.right, 1);
        return Math.round(clamp(share, 0, 1) * (this.lines[0].values.length - 1));
    }

    range() {
        let low = Infinity, high = -Infinity;
        for (const {values} of this.lines) {
            for (const value of values) {
                if (!Number.isFinite(value) || (this.logarithmic && value <= 0)) continue;
                low = Math.min(low, value);
                high = Math.max(high, value);
            }
        }
        if (low > high) return this.logarithmic ? [1e-12, 1] : [0, 1];
        if (this.logarithmic) {
            const bottom = 10 ** Math.floor(Math.log10(low)), top = 10 ** Math.ceil(Math.log10(high));
            return [bottom, top > bottom ? top : 10 * bottom];
        }
        const top = high > 0 ? roundUp(high) : 0, bottom = low < 0 ? -roundUp(-low) : 0;
        return [bottom, top > bottom ? top : bottom + 1];
    }

    // The lines; anew for another size or more values.
    prepare() {
        const ratio = window.devicePixelRatio || 1;
        const box = this.canvas.getBoundingClientRect();
        if (!box.width) return;
        this.canvas.width = Math.round(box.width * ratio);
        this.canvas.height = Math.round(box.height * ratio);
        this.left = 58;
        this.right = 8;
        this.image = document.createElement("canvas");
        this.image.width = this.canvas.width;
        this.image.height = this.canvas.height;
        const context = this.image.getContext("2d");
        context.scale(ratio, ratio);
        const style = getComputedStyle(this.figure);
        const ink = style.getPropertyValue("--faint").trim(), faint = style.getPropertyValue("--line").trim();
        const [low, high] = this.range();
        const top = 8, bottom = box.height - 20, width = box.width - this.left - this.right;
        const up = (value) => this.logarithmic ? (Math.log10(Math.max(value, low)) - Math.log10(low)) / (Math.log10(high) - Math.log10(low)) : (value - low) / (high - low);
        const y = (value) => bottom - clamp(up(value), -0.05, 1.05) * (bottom - top);
        context.font = "11px system-ui, 'DejaVu Sans', sans-serif";
        context.fillStyle = ink;
        context.strokeStyle = faint;
        context.textAlign = "right";
        context.textBaseline = "middle";
        const middle = this.logarithmic ? Math.sqrt(low * high) : (low + high) / 2;
        for (const value of [low, middle, high]) {
            context.beginPath();
            context.moveTo(this.left, Math.round(y(value)) + 0.5);
            context.lineTo(this.left + width, Math.round(y(value)) + 0.5);
            context.stroke();
            context.fillText(this.logarithmic ? value.toExponential(0).replace("e+", "e") : shortNumber(value), this.left - 6, y(value));
        }
        const frames = this.lines[0].values.length, end = this.time(frames - 1);
        context.textBaseline = "top";
        for (let i = 0; i <= 4; ++i) {
            context.textAlign = i === 0 ? "left" : i === 4 ? "right" : "center";
            context.fillText(shortNumber(end * i / 4) + (i === 4 ? " s" : ""), this.left + width * i / 4, bottom + 5);
        }
        this.lines.forEach(({values, dash}, index) => {
            context.strokeStyle = lineColours[index % lineColours.length];
            context.lineWidth = 1.6;
            context.setLineDash(dash || []);
            context.beginPath();
            let isOpen = false;
            const columns = Math.ceil(width * ratio), perColumn = frames / columns;
            const visit = (frame, value) => {
                if (!Number.isFinite(value)) {
                    isOpen = false;
                    return;
                }
                const x = this.left + width * frame / Math.max(frames - 1, 1);
                if (isOpen) context.lineTo(x, y(value)); else context.moveTo(x, y(value));
                isOpen = true;
            };
            if (perColumn <= 2) {
                values.forEach((value, frame) => visit(frame, value));
            } else {
                // The least and the largest value of each column of pixels.
                for (let column = 0; column < columns; ++column) {
                    let least = Infinity, most = -Infinity;
                    const first = Math.floor(column * perColumn), last = Math.min(Math.ceil((column + 1) * perColumn), frames);
                    for (let frame = first; frame < last; ++frame) {
                        least = Math.min(least, values[frame]);
                        most = Math.max(most, values[frame]);
                    }
                    visit(first, least);
                    visit(first, most);
                }
            }
            context.stroke();
        });
        const spans = this.lines.map(({name, values}) => {
            let least = Infinity, most = -Infinity;
            for (const value of values) {
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
            return `${name ? name + " " : ""}${shortNumber(least)} to ${shortNumber(most)}`;
        });
        this.canvas.setAttribute("aria-label", `${this.title} in ${this.unitText} over ${shortNumber(end)} s: ${spans.join("; ")}`);
    }

    show(frame) {
        if (!this.image) return;
        const context = this.canvas.getContext("2d"), ratio = window.devicePixelRatio || 1;
        context.clearRect(0, 0, this.canvas.width, this.canvas.height);
        context.drawImage(this.image, 0, 0);
        const frames = this.lines[0].values.length;
        const width = this.canvas.width / ratio - this.left - this.right;
        const x = (this.left + width * frame / Math.max(frames - 1, 1)) * ratio;
        context.fillStyle = getComputedStyle(this.figure).getPropertyValue("--ink").trim();
        context.fillRect(Math.round(x), 4 * ratio, Math.max(1, Math.round(ratio)), this.canvas.height - 24 * ratio);
        this.now.replaceChildren(...this.lines.map(({name, values}, index) => {
            const span = document.createElement("span");
            const swatch = document.createElement("i");
            swatch.style.background = lineColours[index % lineColours.length];
            span.append(swatch, `${name ? name + " " : ""}${shortNumber(values[frame])} ${this.unitText}`);
            return span;
        }));
    }
}
