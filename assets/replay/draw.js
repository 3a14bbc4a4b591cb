// Draws instances with WebGL 2 as renderer/frames does with OpenGL: the same shaders, meshes, order and constants. What
// the renderer reuses of the last frame is drawn anew here.
const background = linearLight([0.85, 0.875, 0.90]);
const groundReach = 12, haze = 5, leastBarWidth = 1.2, mostTexels = 2048;
const domeRadius = [9, 24, 62];  // pixels, the largest of each level of detail
const attributes = [[2, 3, 0], [3, 1, 12], [4, 4, 16], [5, 3, 32], [6, 3, 44], [7, 1, 56]];  // location, numbers, offset
const instanceBytes = 60;

// Desktop GLSL 3.30 as GLSL ES 3.00. That has one source per stage, so uniforms of several files and the prototypes of
// what they define are dropped.
const translated = (texts) => {
    const seen = new Set();
    const lines = [];
    for (const line of texts.join("\n").split("\n")) {
        const code = line.replace(/\/\/.*/, "").trimEnd();
        if (!code || code.startsWith("#version")) continue;
        if (/^(float|vec[234]) \w+\([^)]*\);$/.test(code)) continue;
        if (code.startsWith("uniform ")) {
            if (seen.has(code)) continue;
            seen.add(code);
        }
        lines.push(code);
    }
    return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2DShadow;\n" + lines.join("\n");
};

class Program {
    constructor(gl, shaders, files) {
        this.gl = gl;
        this.program = gl.createProgram();
        // Definitions before their uses.
        const fragment = files.filter((file) => file.endsWith(".frag")).reverse().map((file) => shaders[file]);
        const stages = [[gl.VERTEX_SHADER, translated([shaders[files[0]]])],
            [gl.FRAGMENT_SHADER, fragment.length ? translated(fragment) : translated(["void main() {}"])]];
        for (const [kind, text] of stages) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            gl.attachShader(this.program, shader);
            gl.deleteShader(shader);
            this.compiled = [...(this.compiled || []), shader];
        }
        gl.linkProgram(this.program);
        this.places = new Map();
    }
    check() {
        const {gl} = this;
        if (gl.getProgramParameter(this.program, gl.LINK_STATUS)) return;
        const logs = this.compiled.map((shader) => gl.getShaderInfoLog(shader)).join("\n");
        throw new Error("A shader does not compile: " + gl.getProgramInfoLog(this.program) + logs);
    }
    use(values) {
        const {gl} = this;
        gl.useProgram(this.program);
        for (const [name, value] of Object.entries(values)) {
            if (!this.places.has(name)) this.places.set(name, gl.getUniformLocation(this.program, name));
            const at = this.places.get(name);
            if (at === null) continue;
            if (value instanceof Int32Array) gl.uniform2iv(at, value);
            else if (typeof value === "number") gl.uniform1f(at, value);
            else if (typeof value === "boolean") gl.uniform1i(at, value ? 1 : 0);
            else if (value.length === 16) gl.uniformMatrix4fv(at, false, value);
            else gl.uniform3fv(at, value);
        }
    }
}

// Half of a unit sphere around +z, as dome_mesh() of renderer/meshes.
const domeMesh = (sides, rings) => {
    const vertices = [], indices = [];
    for (let ring = 0; ring < rings; ++ring) {
        const latitude = 0.5 * Math.PI * ring / rings;
        for (let side = 0; side < sides; ++side) {
            const longitude = 2 * Math.PI * side / sides;
            vertices.push(0, 0, 0, Math.cos(latitude) * Math.cos(longitude), Math.cos(latitude) * Math.sin(longitude), Math.sin(latitude));
            const low = ring * sides + side, next = ring * sides + (side + 1) % sides;
            if (ring + 1 === rings) indices.push(low, next, sides * rings);
            else indices.push(low, next, low + sides, next, next + sides, low + sides);
        }
    }
    vertices.push(0, 0, 0, 0, 0, 1);
    return {vertices: new Float32Array(vertices), indices: new Uint16Array(indices)};
};

class Mesh {
    constructor(gl, {vertices, indices}) {
        this.gl = gl;
        this.indexCount = indices.length;
        this.count = 0;
        this.array = gl.createVertexArray();
        gl.bindVertexArray(this.array);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
        gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
        for (const location of [0, 1]) {
            gl.enableVertexAttribArray(location);
            gl.vertexAttribPointer(location, 3, gl.FLOAT, false, 24, 12 * location);
        }
        this.instances = gl.createBuffer();
        gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
        for (const [location, numbers, offset] of attributes) {
            gl.enableVertexAttribArray(location);
            gl.vertexAttribPointer(location, numbers, gl.FLOAT, false, instanceBytes, offset);
            gl.vertexAttribDivisor(location, 1);
        }
        gl.bindVertexArray(null);
    }
    set(bodies) {
        const {gl} = this;
        const data = new Float32Array(15 * bodies.length);
        bodies.forEach((body, i) => {
            const q = body.orientation;
            data.set(body.position, 15 * i);
            data[15 * i + 3] = body.bevel;
            data.set([q[1], q[2], q[3], q[0]], 15 * i + 4);
            data.set(body.half, 15 * i + 8);
            data.set(body.colour, 15 * i + 11);
            data[15 * i + 14] = body.number;
        });
        this.count = bodies.length;
        gl.bindBuffer(gl.ARRAY_BUFFER, this.instances);
        gl.bufferData(gl.ARRAY_BUFFER, data, gl.STREAM_DRAW);
    }
    draw() {
        if (!this.count) return;
        this.gl.bindVertexArray(this.array);
        this.gl.drawElementsInstanced(this.gl.TRIANGLES, this.indexCount, this.gl.UNSIGNED_SHORT, 0, this.count);
        this.gl.bindVertexArray(null);
    }
}

// A picture to draw into: colours that are read again, and depth.
class Target {
    constructor(gl, width, height, format, hasDepth) {
        this.gl = gl;
        this.width = width;
        this.height = height;
        this.texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
        this.frame = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, this.texture, 0);
        if (hasDepth) {
            this.depth = gl.createRenderbuffer();
            gl.bindRenderbuffer(gl.RENDERBUFFER, this.depth);
            gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
            gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, this.depth);
        }
    }
    begin() {
        this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.frame);
        this.gl.viewport(0, 0, this.width, this.height);
    }
    remove() {
        this.gl.deleteTexture(this.texture);
        this.gl.deleteFramebuffer(this.frame);
        if (this.depth) this.gl.deleteRenderbuffer(this.depth);
    }
}

class ShadowMap {
    constructor(gl) {
        this.gl = gl;
        this.texture = gl.createTexture();
        this.frame = gl.createFramebuffer();
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.LINEAR);
        // There is no border colour here; the view has an empty border instead.
        for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, wrap, gl.CLAMP_TO_EDGE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL);
    }
    begin(width, height) {
        const {gl} = this;
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, this.texture);
        if (width !== this.width || height !== this.height) {
            gl.texImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT24, width, height, 0, gl.DEPTH_COMPONENT, gl.UNSIGNED_INT, null);
            this.width = width;
            this.height = height;
        }
        gl.bindTexture(gl.TEXTURE_2D, null);
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, this.texture, 0);
        gl.drawBuffers([gl.NONE]);
        gl.readBuffer(gl.NONE);
        gl.viewport(0, 0, width, height);
        gl.clear(gl.DEPTH_BUFFER_BIT);
    }
    bind() {
        this.gl.activeTexture(this.gl.TEXTURE0);
        this.gl.bindTexture(this.gl.TEXTURE_2D, this.texture);
    }
}

const scaleOf = (camera) => norm(minus(camera.eye, camera.target));
const cameraView = (camera, aspect) => product(
    perspective(camera.fieldOfView, aspect, 0.01 * scaleOf(camera), 1.5 * groundReach * scaleOf(camera)),
    lookAt(camera.eye, camera.target));
const lineSpacing = (scale) => 10 ** Math.floor(Math.log10(scale / 6));

// As sun_view() of renderer/picture/views.h.
const sunView = (camera, towardsSun, bodies) => {
    const turn = lookAt([0, 0, 0], times(-1, towardsSun));
    const seen = (p) => transformed(turn, p).slice(0, 3);
    const target = seen(camera.target), scale = scaleOf(camera);
    let low = bodies.length ? seen(bodies[0].position) : target, high = low;
    for (const body of bodies) {
        const p = seen(body.position);
        low = low.map((x, k) => Math.min(x, p[k] - body.radius));
        high = high.map((x, k) => Math.max(x, p[k] + body.radius));
    }
    const limited = (p) => p.map((x, k) => k === 2 ? x : clamp(x, target[k] - 4 * scale, target[k] + 4 * scale));
    low = limited(low);
    high = limited(high);
    const border = 3, step = 32, room = mostTexels - 2 * (step + border);
    const extent = Math.max(high[0] - low[0], high[1] - low[1]);
    let texel = scale / 700;
    if (extent > room * texel) texel *= 2 ** (Math.ceil(32 * Math.log2(extent / (room * texel))) / 32);
    const first = low.map((x) => step * Math.floor((x / texel - border) / step));
    const last = high.map((x) => step * Math.ceil((x / texel + border) / step));
    const clip = parallel(texel * first[0], texel * last[0], texel * first[1], texel * last[1], -texel * last[2], -texel * first[2]);
    return {worldToClip: product(clip, turn), width: last[0] - first[0], height: last[1] - first[1], texel};
};

class Painter {
    constructor(canvas, shaders, common) {
        const gl = canvas.getContext("webgl2", {antialias: false, alpha: false, depth: false, stencil: false});
        if (!gl) throw new Error("WebGL 2 is missing");
        this.gl = gl;
        const light = ["light.frag", "open_sky.frag", "exposed.frag", "shadow.frag", "haze.frag"];
        const program = (...files) => new Program(gl, shaders, files);
        this.programs = {
            shadow: program("body.vert"), sphereShadow: program("sphere.vert"), barShadow: program("bar.vert"),
            ground: program("body.vert", "ground.frag", "lines.frag", ...light),
            contact: program("contact.vert", "contact.frag", "haze.frag"),
            body: program("body.vert", "body.frag", ...light), sphere: program("sphere.vert", "sphere.frag", ...light),
            bar: program("bar.vert", "bar.frag", ...light), panel: program("panel.vert", "panel.frag", "lines.frag", ...light),
            bytes: program("whole.vert", "bytes.frag"), smooth: program("whole.vert", "smooth.frag"),
        };
        // All are compiled before the first is waited for.
        Object.values(this.programs).forEach((one) => one.check());
        const mesh = (data) => new Mesh(gl, data);
        const [box, square] = common;
        this.boxes = mesh(box);
        this.bars = mesh(square);
        this.groundSquare = mesh(square);
        this.contacts = mesh(square);
        this.domes = [[12, 2], [20, 2], [32, 4], [96, 12]].map(([sides, rings]) => mesh(domeMesh(sides, rings)));
        this.polyhedra = new Map();  // by the mesh's data
        this.shadowMap = new ShadowMap(gl);
        this.panelArray = gl.createVertexArray();
        this.panelBuffer = gl.createBuffer();
        gl.bindVertexArray(this.panelArray);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.panelBuffer);
        for (const [location, numbers, offset] of [[0, 3, 0], [1, 3, 12], [2, 3, 24], [3, 1, 36], [4, 1, 40], [5, 2, 44]]) {
            gl.enableVertexAttribArray(location);
            gl.vertexAttribPointer(location, numbers, gl.FLOAT, false, 52, offset);
        }
        gl.bindVertexArray(null);
        this.empty = gl.createVertexArray();
        gl.enable(gl.CULL_FACE);
        gl.enable(gl.DEPTH_TEST);
        this.clearPage();
    }

    // Draws scenes over each other, all but the first as ghosts, into an area of the canvas: x, y from the lower left,
    // width and height in pixels.
    draw(scenes, camera, area) {
        const {gl} = this;
        if (!this.target || this.target.width !== area.width || this.target.height !== area.height) {
            for (const old of [this.target, this.stored]) if (old) old.remove();
            this.target = new Target(gl, area.width, area.height, gl.SRGB8_ALPHA8, true);
            this.stored = new Target(gl, area.width, area.height, gl.RGBA8, false);
        }
        const pixel = 2 * Math.tan(radians(0.5 * camera.fieldOfView)) / area.height;
        scenes.forEach((scene, i) => this.drawScene(scene, camera, area.width / area.height, pixel, i > 0));
        this.present(area);
    }

    drawScene(all, camera, aspect, pixel, isGhost) {
        const {gl, programs} = this;
        const reach = groundReach * scaleOf(camera);
        const scene = {...all};
        for (const kind of ["boxes", "spheres", "polyhedra", "bars"]) {
            const near = all[kind].map((body) => [norm(minus(camera.eye, body.position)), body]);
            scene[kind] = near.filter(([distance, body]) => distance - body.radius <= reach).sort((a, b) => a[0] - b[0]).map(([, body]) => body);
        }
        const thick = [...scene.boxes, ...scene.spheres, ...scene.polyhedra];
        const sun = sunView(camera, all.towardsSun, [...thick, ...scene.bars]);
        const textureFromClip = Float64Array.of(0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0.5, 0.5, 0.5, 1);
        const view = {
            world_to_clip: cameraView(camera, aspect), eye: camera.eye, viewer: camera.eye, parallel: false, towards_sun: all.towardsSun, sun_share: 1,
            background, haze_distance: haze * scaleOf(camera), line_spacing: lineSpacing(scaleOf(camera)),
            world_to_shadow: product(textureFromClip, sun.worldToClip), shadow_texel: sun.texel,
        };

        this.setBodies(scene, camera, pixel);
        this.bars.set(scene.bars);
        const fromSun = {world_to_clip: sun.worldToClip, viewer: all.towardsSun, parallel: true};
        this.shadowMap.begin(sun.width, sun.height);
        programs.shadow.use(fromSun);
        this.boxes.draw();
        this.drawPolyhedra();
        programs.sphereShadow.use(fromSun);
        this.domes.forEach((dome) => dome.draw());
        programs.barShadow.use({...fromSun, least_radius: 0.5 * leastBarWidth * sun.texel, margin: 0});
        gl.disable(gl.CULL_FACE);
        this.bars.draw();
        gl.enable(gl.CULL_FACE);

        this.target.begin();
        this.shadowMap.bind();
        if (isGhost) {
            this.drawGhost(view);
            return;
        }
        gl.clearColor(...background, 0);
        gl.clear(gl.COLOR_BUFFER_BIT);
        gl.disable(gl.DEPTH_TEST);
        if (scene.ground) this.drawGround(scene, view, camera, thick);
        gl.enable(gl.DEPTH_TEST);
        gl.clear(gl.DEPTH_BUFFER_BIT);
        const below = (point, radius) => point[1] - radius < scene.ground.height;
        if (scene.ground && ([...thick, ...scene.bars].some((body) => below(body.position, body.radius)) ||
            scene.panels.some((panel) => panel.corners.some((corner) => below(corner, 0))))) {
            programs.shadow.use(view);
            gl.colorMask(false, false, false, false);
            this.groundSquare.draw();
            gl.colorMask(true, true, true, true);
        }
        programs.body.use(view);
        this.boxes.draw();
        this.drawPolyhedra();
        programs.sphere.use(view);
        this.domes.forEach((dome) => dome.draw());
        this.drawBars(scene.bars, view, pixel);
        this.drawPanels(scene.panels, view);
    }

    setBodies(scene, camera, pixel) {
        this.boxes.set(scene.boxes);
        const levels = this.domes.map(() => []);
        for (const sphere of scene.spheres) {
            const radius = sphere.bevel / (pixel * norm(minus(camera.eye, sphere.position)));
            const level = domeRadius.findIndex((largest) => radius <= largest);
            levels[level < 0 ? levels.length - 1 : level].push(sphere);
        }
        this.domes.forEach((dome, i) => dome.set(levels[i]));
        this.polyhedraShown = new Map();
        for (const body of scene.polyhedra) {
            const data = scene.meshes[body.mesh];
            if (!this.polyhedraShown.has(data)) this.polyhedraShown.set(data, []);
            this.polyhedraShown.get(data).push(body);
        }
        for (const [data, bodies] of this.polyhedraShown) {
            if (!this.polyhedra.has(data)) this.polyhedra.set(data, new Mesh(this.gl, data));
            this.polyhedra.get(data).set(bodies);
        }
    }
    drawPolyhedra() {
        for (const data of this.polyhedraShown.keys()) this.polyhedra.get(data).draw();
    }

    drawGround(scene, view, camera, thick) {
        const {gl} = this;
        const {height} = scene.ground, side = groundReach * scaleOf(camera);
        this.groundSquare.set([{position: [camera.eye[0], height, camera.eye[2]], bevel: 0, orientation: [1, 0, 0, 0],
            half: [side, 0, side], colour: [0.42, 0.425, 0.435], number: 0}]);
        this.programs.ground.use(view);
        this.groundSquare.draw();
        this.contacts.set(thick.filter((body) => Math.abs(body.position[1] - height) < 2 * body.radius));
        this.programs.contact.use({...view, ground_height: height});
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.ZERO, gl.SRC_COLOR);
        this.contacts.draw();
        gl.disable(gl.BLEND);
    }

    drawBars(bars, view, pixel) {
        const {gl} = this;
        this.bars.set([...bars].reverse());
        this.programs.bar.use({...view, least_radius: 0.5 * leastBarWidth * pixel, margin: pixel});
        gl.disable(gl.CULL_FACE);
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ZERO, gl.ZERO);
        this.bars.draw();
        gl.disable(gl.BLEND);
        gl.enable(gl.CULL_FACE);
    }

    // As panel_triangles() of renderer/picture/panels.h.
    drawPanels(panels, view) {
        if (!panels.length) return;
        const {gl} = this;
        const middle = (corners) => times(1 / corners.length, corners.reduce(add));
        const far = panels.map(({corners}) => ({corners, distance: norm(minus(middle(corners), view.eye))})).sort((a, b) => b.distance - a.distance);
        const colour = linearLight([0.6, 0.6, 0.6]), opacity = 0.3;
        const data = [];
        for (const {corners} of far) {
            let area = [0, 0, 0];
            for (let i = 2; i < corners.length; ++i) area = add(area, cross(minus(corners[i - 1], corners[0]), minus(corners[i], corners[0])));
            const normal = unit(area);
            const along = unit(cross(Math.abs(normal[1]) > 0.999 ? [0, 0, -1] : [0, 1, 0], normal));
            const across = cross(normal, along), centre = middle(corners);
            const vertex = (p, fromEdge) => data.push(...p, ...normal, ...colour, opacity, fromEdge, dot(p, along), dot(p, across));
            corners.forEach((first, i) => {
                const second = corners[(i + 1) % corners.length], length = norm(minus(second, first));
                if (length === 0) return;
                vertex(first, 0);
                vertex(second, 0);
                vertex(centre, norm(cross(minus(second, first), minus(centre, first))) / length);
            });
        }
        this.programs.panel.use(view);
        gl.bindVertexArray(this.panelArray);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.panelBuffer);
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(data), gl.STREAM_DRAW);
        gl.disable(gl.CULL_FACE);
        gl.depthMask(false);
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        gl.drawArrays(gl.TRIANGLES, 0, data.length / 13);
        gl.disable(gl.BLEND);
        gl.depthMask(true);
        gl.enable(gl.CULL_FACE);
        gl.bindVertexArray(null);
    }

    // Bodies that are mixed into what is there: first their depth, then their nearest surfaces.
    drawGhost(view) {
        const {gl, programs} = this;
        const solid = (body, sphere) => {
            body.use(view);
            this.boxes.draw();
            this.drawPolyhedra();
            sphere.use(view);
            this.domes.forEach((dome) => dome.draw());
        };
        gl.colorMask(false, false, false, false);
        solid(programs.shadow, programs.sphereShadow);
        gl.colorMask(true, true, true, true);
        gl.depthFunc(gl.LEQUAL);
        gl.enable(gl.BLEND);
        gl.blendColor(0, 0, 0, 0.4);
        gl.blendFunc(gl.CONSTANT_ALPHA, gl.ONE_MINUS_CONSTANT_ALPHA);
        solid(programs.body, programs.sphere);
        gl.disable(gl.BLEND);
        gl.depthFunc(gl.LESS);
    }

    present(area) {
        const {gl} = this;
        gl.disable(gl.DEPTH_TEST);
        gl.bindVertexArray(this.empty);
        this.stored.begin();
        gl.bindTexture(gl.TEXTURE_2D, this.target.texture);
        this.programs.bytes.use({});
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.viewport(area.x, area.y, area.width, area.height);
        gl.bindTexture(gl.TEXTURE_2D, this.stored.texture);
        this.programs.smooth.use({size: Int32Array.of(area.width, area.height), origin: Int32Array.of(area.x, area.y)});
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.bindVertexArray(null);
        gl.bindTexture(gl.TEXTURE_2D, null);
        gl.enable(gl.DEPTH_TEST);
    }

    // White, as between the panels of a picture.
    clearPage() {
        const {gl} = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.clearColor(1, 1, 1, 1);
        gl.clear(gl.COLOR_BUFFER_BIT);
    }
}
