// Bytes that the page holds as text.
const bytesOf = (text) => {
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
    return bytes;
};
const inflated = async (text, format = "deflate") => {
    const stream = new Blob([bytesOf(text)]).stream().pipeThrough(new DecompressionStream(format));
    return new Uint8Array(await new Response(stream).arrayBuffer());
};

const meshesIn = (bytes) => {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    const meshes = [];
    for (let at = 0; at < bytes.length;) {
        const vertices = view.getUint32(at, true), indices = view.getUint32(at + 4, true);
        at += 8;
        const mesh = {vertices: new Float32Array(6 * vertices), indices: new Uint16Array(indices)};
        for (let i = 0; i < mesh.vertices.length; ++i, at += 4) mesh.vertices[i] = view.getFloat32(at, true);
        for (let i = 0; i < mesh.indices.length; ++i, at += 2) mesh.indices[i] = view.getUint16(at, true);
        meshes.push(mesh);
    }
    return meshes;
};
