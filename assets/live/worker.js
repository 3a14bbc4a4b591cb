// The program in a worker: it answers {id, name, args} with {id, answer} or {id, error}.
let program = null;

const call = (name, ...args) => JSON.parse(program.ccall(name, "string", args.map((arg) => typeof arg), args));
// A copy: the memory of the program moves when it grows.
const bytesAt = ({at, size}) => program.HEAPU8.slice(at, at + size);
const numbersAt = ({at, size}) => program.HEAPF64.slice(at / 8, at / 8 + size);

const calls = {
    start: async (compressed) => {
        const stream = new Blob([compressed]).stream().pipeThrough(new DecompressionStream("gzip"));
        program = await Program({wasmBinary: await new Response(stream).arrayBuffer()});
        return {...call("live_menu"), meshes: bytesAt(call("live_meshes"))};
    },
    keep: (name, text) => call("live_keep", name, text),
    open: (slot, scene, options) => {
        const about = call("live_open", slot, JSON.stringify({scene, options}));
        if (!about.meshes) return about;
        about.meshes = bytesAt(about.meshes);
        return {...about, now: calls.advance([[slot, 0]])[0]};
    },
    close: (slot) => program.ccall("live_close", null, ["number"], [slot]),
    // Pairs of slot and steps.
    advance: (wishes) => wishes.map(([slot, steps]) => {
        const begin = performance.now();
        const state = call("live_advance", slot, steps);
        if (state.size === undefined) return state;
        return {hash: state.hash, command: state.command, numbers: numbersAt(state), milliseconds: performance.now() - begin};
    }),
    microscope: (slot) => call("live_microscope", slot),
};

onmessage = async ({data: {id, name, args}}) => {
    try {
        postMessage({id, answer: await calls[name](...args)});
    } catch (error) {
        postMessage({id, error: error.message || String(error)});
    }
};
