// Draws the union in WebGL 2.

const canvas = element("surface");
const gl = canvas.getContext("webgl2", { antialias: true, alpha: false, preserveDrawingBuffer: true });
const columns = 2048;
let program = null,
    uniforms = {},
    textures = {},
    uploads = true,
    waits = false;

function complain(text) {
    element("message").textContent = text;
    element("message").hidden = false;
}

const hex = code => [16, 8, 0].map(shift => linear(((code >> shift) & 255) / 255));
const viridis = [
    0x440154, 0x481f70, 0x443983, 0x3b528b, 0x31688e, 0x287c8e, 0x21918c, 0x20a486, 0x35b779, 0x5ec962,
    0x90d743, 0xc8e020, 0xfde725
];

function makeProgram() {
    program = gl.createProgram();
    for (const [kind, id] of [
        [gl.VERTEX_SHADER, "vertex-shader"],
        [gl.FRAGMENT_SHADER, "fragment-shader"]
    ]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, element(id).textContent.trim());
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost())
            throw new Error(gl.getShaderInfoLog(shader));
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    uniforms = new Proxy(
        {},
        { get: (found, name) => (found[name] ??= gl.getUniformLocation(program, name)) }
    );
    ["leaves", "positions", "products", "fields"].forEach((name, slot) => {
        textures[name] = { slot, texture: gl.createTexture() };
        gl.uniform1i(uniforms[name], slot);
    });
    gl.uniform3fv(uniforms.colors, viridis.flatMap(hex));
    gl.enable(gl.DEPTH_TEST);
    uploads = true;
}

// Puts rows of four numbers into a texture of 2048 columns.
function upload(name, count, isInteger, fill) {
    const rows = Math.max(1, Math.ceil(count / columns));
    if (rows > gl.getParameter(gl.MAX_TEXTURE_SIZE))
        return complain("The surface is too large for this graphics card.");
    const data = isInteger ? new Uint32Array(4 * columns * rows) : new Float32Array(4 * columns * rows);
    fill(data);
    gl.activeTexture(gl.TEXTURE0 + textures[name].slot);
    gl.bindTexture(gl.TEXTURE_2D, textures[name].texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    if (isInteger)
        gl.texImage2D(
            gl.TEXTURE_2D,
            0,
            gl.RGBA32UI,
            columns,
            rows,
            0,
            gl.RGBA_INTEGER,
            gl.UNSIGNED_INT,
            data
        );
    else gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, columns, rows, 0, gl.RGBA, gl.FLOAT, data);
}

const uploadStreams = (name, streams, width) =>
    upload(
        name,
        streams.reduce((sum, s) => sum + s.length / width, 0),
        false,
        data => {
            let at = 0;
            for (const stream of streams)
                for (let n = 0; n < stream.length; n += width, at += 4)
                    for (let c = 0; c < width; ++c) data[at + c] = stream[n + c];
        }
    );

const chosenField = () => family.fields.findIndex(field => "field " + field.name === element("color").value);

function uploadMesh() {
    const mesh = state.mesh,
        f = chosenField();
    if (uploads) upload("leaves", mesh.leafCount, true, data => data.set(mesh.triangles));
    uploads = false;
    const width = f >= 0 && family.fields[f].kind === "color" ? 3 : 1;
    if (mesh.products) {
        uploadStreams("positions", mesh.positions, 3);
        uploadStreams("products", mesh.products, 3);
        if (f >= 0) uploadStreams("fields", mesh.fields[f], width);
        return;
    }
    // Many keys are blended here, and the shader sees one key. Their products would take too much memory.
    const weights = weightList(),
        sum = weightedSum(mesh.positions, weights),
        normals = new Float32Array(sum.length);
    sumProducts(mesh, sum, sum, 0.5, normals);
    interpolateElsewhere(
        mesh,
        weights.reduce((owners, weight, q) => (weight === 0 ? owners : owners | (1 << q)), 0),
        normals
    );
    uploadStreams("positions", [sum], 3);
    uploadStreams("products", [normals], 3);
    if (f >= 0) uploadStreams("fields", [weightedSum(mesh.fields[f], weights)], width);
}

function matrices(width, height) {
    const [a, e] = [view.azimuth, view.elevation].map(degrees => (degrees * Math.PI) / 180),
        f = 1 / Math.tan((17.5 * Math.PI) / 180);
    const distance =
        (radius * Math.max(1, height / width) * 1.05) / Math.sin((17.5 * Math.PI) / 180) / view.zoom;
    const x = [Math.cos(a), 0, -Math.sin(a)],
        z = [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
    const y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
    const near = Math.max(distance - 2 * radius, distance / 100),
        far = distance + 2 * radius;
    return {
        view: [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, 0, 0, -distance, 1],
        projection: [
            (f * height) / width,
            0,
            0,
            0,
            0,
            f,
            0,
            0,
            0,
            0,
            (far + near) / (near - far),
            -1,
            0,
            0,
            (2 * far * near) / (near - far),
            0
        ]
    };
}

// The range of colors: of levels or of a scalar.
function colorRange(coloring, field) {
    if (coloring === 2) return [field.min, field.max];
    if (coloring !== 1) return [0, 1];
    let [least, most] = [127, 0];
    const { triangles, leafCount } = state.mesh;
    for (let t = 3; t < 4 * leafCount; t += 4) {
        least = Math.min(least, triangles[t] & 127);
        most = Math.max(most, triangles[t] & 127);
    }
    return [least, most];
}

function draw() {
    waits = false;
    if (!state.mesh || gl.isContextLost()) return;
    const ratio = Math.min(devicePixelRatio || 1, 2),
        width = Math.max(1, Math.round(canvas.clientWidth * ratio)),
        height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    if (uploads || !state.mesh.products) uploadMesh();
    const f = chosenField(),
        field = family.fields[f],
        mesh = state.mesh;
    const coloring = element("color").value === "level" ? 1 : f < 0 ? 0 : field.kind === "color" ? 3 : 2,
        range = colorRange(coloring, field);
    const weights = mesh.products ? weightList() : [1];
    gl.viewport(0, 0, width, height);
    const back = getComputedStyle(document.body)
        .backgroundColor.match(/\d+/g)
        .map(n => n / 255);
    gl.clearColor(back[0], back[1], back[2], 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const { view: seen, projection } = matrices(width, height);
    gl.uniformMatrix4fv(uniforms.view, false, seen);
    gl.uniformMatrix4fv(uniforms.projection, false, projection);
    gl.uniform1i(uniforms.key_count, weights.length);
    gl.uniform1i(uniforms.vertex_count, mesh.vertexCount);
    gl.uniform1fv(uniforms.weights, weights);
    gl.uniform1i(uniforms.has_field, f >= 0);
    gl.uniform1i(uniforms.coloring, coloring);
    gl.uniform2fv(uniforms.range, range);
    gl.uniform3i(
        uniforms.edges,
        element("refinement").checked,
        element("wireframe").checked,
        element("roots").checked
    );
    gl.uniform1f(uniforms.line_width, 0.75 * ratio);
    gl.drawArrays(gl.TRIANGLES, 0, 3 * mesh.leafCount);
    drawPanel(coloring, range, coloring === 2 ? field : {});
}

// Draws before the next picture of the screen.
function redraw() {
    if (!waits) requestAnimationFrame(draw);
    waits = true;
}
