// Cameras {eye, target, fieldOfView}, the cells of a view, and the pointer over it.
const halfTangent = (degrees) => Math.tan(radians(0.5 * degrees));

const turnEye = (camera, right, up) => {
    const offset = minus(camera.eye, camera.target), distance = norm(offset);
    const azimuth = Math.atan2(offset[0], offset[2]) - right;
    const height = clamp(Math.asin(clamp(offset[1] / distance, -1, 1)) + up, -1.52, 1.52);
    camera.eye = add(camera.target, times(distance, [Math.sin(azimuth) * Math.cos(height), Math.sin(height), Math.cos(azimuth) * Math.cos(height)]));
};
// Shares of what is seen at the target.
const shiftCamera = (camera, right, up) => {
    const forward = unit(minus(camera.target, camera.eye));
    const aside = unit(cross(forward, screenUp(forward))), upward = cross(aside, forward);
    const size = 2 * norm(minus(camera.eye, camera.target)) * halfTangent(camera.fieldOfView);
    const shift = add(times(right * size, aside), times(up * size, upward));
    camera.eye = add(camera.eye, shift);
    camera.target = add(camera.target, shift);
};
const zoomEye = (camera, factor) => {
    camera.eye = add(camera.target, times(factor, minus(camera.eye, camera.target)));
};
// Keeps the direction and shows all balls {centre, radius}; false, and no change, without any.
const frameBalls = (camera, balls, aspect) => {
    if (!balls.length) return false;
    let low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const {centre, radius} of balls) {
        low = low.map((x, k) => Math.min(x, centre[k] - radius));
        high = high.map((x, k) => Math.max(x, centre[k] + radius));
    }
    const centre = times(0.5, add(low, high)), radius = 0.5 * norm(minus(high, low));
    const half = Math.min(halfTangent(camera.fieldOfView), halfTangent(camera.fieldOfView) * aspect);
    const distance = radius / (0.95 * Math.sin(Math.atan(half)));
    camera.eye = add(centre, times(distance, unit(minus(camera.eye, camera.target))));
    camera.target = centre;
    return true;
};
// In a narrow view the field of view grows, so that what a wide one shows to the sides (a tangent) stays in it.
const shownAcross = (camera, across, aspect) => {
    const needed = 2 * Math.atan(across / (0.9 * aspect)) * 180 / Math.PI;
    return {...camera, fieldOfView: clamp(needed, camera.fieldOfView, 120)};
};

// What the pictures of runs show to each side (film.cpp), as a tangent.
const acrossOf = (stages) => Math.max(...stages.map(({camera}) => clamp(camera.across, 0.1, 16 / 9 * halfTangent(camera.field_of_view))));

// Cells of a canvas for so many of the stages, in pixels, y from the top, as demos/pictures/camera/layout.cpp places the panels of
// a picture.
const cellsOf = (canvas, stages, count = stages.length) => {
    const across = acrossOf(stages), up = Math.max(...stages.map(({camera}) => halfTangent(camera.field_of_view)));
    if (count === 1) return [{x: 0, y: 0, width: canvas.width, height: canvas.height}];
    const gap = Math.max(2, Math.floor(Math.min(canvas.width, canvas.height) / 240));
    let best = null;
    for (let columns = 1; columns <= count; ++columns) {
        const rows = Math.ceil(count / columns);
        const width = Math.floor((canvas.width - gap * (columns - 1)) / columns), height = Math.floor((canvas.height - gap * (rows - 1)) / rows);
        const scale = Math.min(0.5 * height / up, 0.5 * width / across);
        if (!best || scale > best.scale) best = {columns, width, height, scale};
    }
    return Array.from({length: count}, (_, i) => ({x: (i % best.columns) * (best.width + gap), y: Math.floor(i / best.columns) * (best.height + gap),
        width: best.width, height: best.height}));
};

// Mouse, fingers and wheel over an element: turn(right, up), move(right, up), zoom(factor), click(x, y) in the window.
const listenToPointer = (view, {turn, move, zoom, click}) => {
    const pointers = new Map();
    let moved = 0;
    view.addEventListener("pointerdown", (event) => {
        view.setPointerCapture(event.pointerId);
        if (!pointers.size) moved = 0;
        pointers.set(event.pointerId, event);
        view.classList.add("dragged");
    });
    view.addEventListener("pointermove", (event) => {
        const last = pointers.get(event.pointerId);
        if (!last) return;
        const dx = event.clientX - last.clientX, dy = event.clientY - last.clientY, height = view.clientHeight;
        moved += Math.hypot(dx, dy);
        if (pointers.size === 2) {
            const [other] = [...pointers.values()].filter((one) => one.pointerId !== event.pointerId);
            const apart = (one) => Math.hypot(one.clientX - other.clientX, one.clientY - other.clientY);
            if (apart(event) > 0) zoom(clamp(apart(last) / apart(event), 0.5, 2));
            move(-0.5 * dx / height, 0.5 * dy / height);
        } else if (moved > 3) {
            if (event.shiftKey || event.buttons & 6) move(-dx / height, dy / height); else turn(3 * dx / height, 3 * dy / height);
        }
        pointers.set(event.pointerId, event);
    });
    const release = (event) => {
        if (pointers.delete(event.pointerId) && !pointers.size) view.classList.remove("dragged");
    };
    view.addEventListener("pointerup", (event) => {
        const isClick = pointers.size === 1 && moved <= 3 && event.button === 0;
        release(event);
        if (isClick) click(event.clientX, event.clientY);
    });
    view.addEventListener("pointercancel", release);
    view.addEventListener("contextmenu", (event) => event.preventDefault());
    view.addEventListener("wheel", (event) => {
        event.preventDefault();
        zoom(Math.exp(clamp(event.deltaY * (event.deltaMode ? 30 : 1), -300, 300) / 600));
    }, {passive: false});
};
