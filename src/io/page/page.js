// Shows a family of triangle hierarchies as the program does: unites the hierarchies of the active keys, makes
// the normal products and morphs in WebGL 2. docs/file-formats.md describes the data, docs/user-guide.md the API.
"use strict";
(() => {

const element = id => document.getElementById(id);
const family = JSON.parse(element("family").textContent);
const keyNames = family.keys.map(key => key.name);
const keyAt = name => keyNames.indexOf(name);
const [low, high, unit] = [family.box[0], family.box[1], family.unit];
const center = low.map((x, c) => (x + high[c]) / 2);
let radius = 1;  // of the sphere around the center that holds all keys
const mostShaderKeys = 4;

// ---- The payload

async function inflated(base64) {
    const bytes = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Reads numbers stored as three planes of bytes, lowest first, each with its sign in the lowest bit.
function planes(bytes, at, count) {
    const numbers = new Int32Array(count);
    for (let i = 0; i < count; ++i) {
        const n = bytes[at + i] | bytes[at + count + i] << 8 | bytes[at + 2 * count + i] << 16;
        numbers[i] = n >>> 1 ^ -(n & 1);
    }
    return numbers;
}

function summed(numbers) {
    for (let i = 1; i < numbers.length; ++i) numbers[i] += numbers[i - 1];
    return numbers;
}

const linear = c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;

// Walks the forest of one key; visit(midpoint, b, c) for each bisected node.
function walk(roots, bits, midpoints, visit) {
    let node = 0, bisected = 0;
    const stack = [];
    for (let r = 0; r < roots.length; r += 3) {
        stack.push(roots[r], roots[r + 1], roots[r + 2]);
        while (stack.length > 0) {
            const k = stack.pop(), j = stack.pop(), i = stack.pop();
            const isBisected = bits[node >> 3] >> (node & 7) & 1;
            ++node;
            if (!isBisected) continue;
            const l = midpoints[bisected++];
            visit(l, j, k);
            stack.push(l, i, j, l, k, i);
        }
    }
}

// The arrays of all keys. Positions are relative to the center of the box of all keys.
function decoded(bytes) {
    let at = 0;
    const take = count => { const numbers = planes(bytes, at, count); at += 3 * count; return numbers; };
    const roots = summed(take(3 * family.roots));
    const keys = family.keys.map(({ vertices, bisections }) => {
        const bits = bytes.subarray(at, at += family.roots + 2 * bisections + 7 >> 3);
        const midpoints = summed(take(bisections));
        const widths = [3, ...family.fields.map(field => field.kind === "color" ? 3 : 1)];
        const parts = widths.map(width => take(width * vertices));  // component after component
        const seen = new Uint8Array(vertices).fill(1, 0, family.rootVertices);
        walk(roots, bits, midpoints, (l, b, c) => {
            if (seen[l]) return;
            seen[l] = 1;
            widths.forEach((width, p) => {
                for (let v = 0; v < width; ++v) parts[p][v * vertices + l] += parts[p][v * vertices + b] + parts[p][v * vertices + c] >> 1;
            });
        });
        const placed = (part, width, number) => {
            const values = new Float32Array(width * vertices);
            for (let v = 0; v < vertices; ++v)
                for (let c = 0; c < width; ++c) values[width * v + c] = number(part[c * vertices + v], c);
            return values;
        };
        const fields = family.fields.map((field, f) => field.kind === "color"
            ? placed(parts[f + 1], 3, n => linear(n / 255))
            : placed(parts[f + 1], 1, n => field.min + n * (field.max - field.min) / 65535));
        return { vertices, bits, midpoints, fields, positions: placed(parts[0], 3, (n, c) => n * unit + low[c] - center[c]) };
    });
    return { roots, keys };
}

// ---- The union (paper, theorem 2): one synchronous walk over the keys' forests

// The tags of a triangle's children: bits 0-6 the level, 7-9 sides on root edges, then the exponents of the corner
// weights, 7 bits each.
function childTags(tag) {
    const common = (tag & 127) + 1 | (tag & 127) + 1 << 10;
    const [i, j, k] = [tag >>> 10 & 127, tag >>> 17 & 127, tag >>> 24 & 127];
    return [common | tag >>> 1 & 128 | tag << 2 & 512 | k + 1 << 17 | i << 24,
        common | tag >>> 2 & 128 | tag << 1 & 256 | i << 17 | j + 1 << 24];
}

function unite(roots, keys) {
    const capacity = keys.reduce((sum, key) => sum + key.vertices, 0);
    const leafCapacity = keys.reduce((sum, key) => sum + key.midpoints.length, roots.length / 3);
    const triangles = new Uint32Array(4 * leafCapacity);  // three vertices and the tag
    const edges = new Uint32Array(2 * capacity), owners = new Uint32Array(capacity);
    const streams = list => keys.map(() => list.map(width => new Float32Array(width * capacity)));
    const widths = [3, ...family.fields.map(field => field.kind === "color" ? 3 : 1)];
    const values = streams(widths);
    const own = keys.map(key => [key.positions, ...key.fields]);
    const numbers = keys.map(key => new Int32Array(key.vertices).fill(-1));
    const nodes = new Uint32Array(keys.length), bisected = new Uint32Array(keys.length);
    const all = 2 ** keys.length - 1;
    let vertexCount = family.rootVertices, leafCount = 0;
    const place = (q, v, m) => {
        numbers[q][v] = m;
        owners[m] |= 1 << q;
        widths.forEach((width, p) => { for (let c = 0; c < width; ++c) values[q][p][width * m + c] = own[q][p][width * v + c]; });
    };
    for (let v = 0; v < family.rootVertices; ++v) keys.forEach((_, q) => place(q, v, v));
    const stack = [], midpoints = new Int32Array(keys.length);
    for (let r = 0; r < roots.length; r += 3) {
        stack.push(roots[r], roots[r + 1], roots[r + 2], 7 << 7, all);
        while (stack.length > 0) {
            const active = stack.pop(), tag = stack.pop(), k = stack.pop(), j = stack.pop(), i = stack.pop();
            let here = 0, m = -1;
            for (let q = 0; q < keys.length; ++q) {
                if (!(active >> q & 1)) continue;
                const node = nodes[q]++;
                if (!(keys[q].bits[node >> 3] >> (node & 7) & 1)) continue;
                here |= 1 << q;
                midpoints[q] = keys[q].midpoints[bisected[q]++];
                if (numbers[q][midpoints[q]] >= 0) m = numbers[q][midpoints[q]];
            }
            if (here === 0) {
                triangles.set([i, j, k, tag], 4 * leafCount++);
                continue;
            }
            if (m < 0) {
                m = vertexCount++;
                edges[2 * m] = j;
                edges[2 * m + 1] = k;
                for (let q = 0; q < keys.length; ++q) {
                    if (here >> q & 1) continue;
                    widths.forEach((width, p) => {
                        const to = values[q][p];
                        for (let c = 0; c < width; ++c) to[width * m + c] = 0.5 * (to[width * j + c] + to[width * k + c]);
                    });
                }
            }
            for (let q = 0; q < keys.length; ++q)
                if (here >> q & 1 && numbers[q][midpoints[q]] < 0) place(q, midpoints[q], m);
            const [first, second] = childTags(tag);
            stack.push(m, i, j, second, here, m, k, i, first, here);
        }
    }
    const cut = (array, width) => array.subarray(0, width * vertexCount);
    return {
        keyCount: keys.length, vertexCount, leafCount, triangles: triangles.subarray(0, 4 * leafCount), edges, owners,
        positions: values.map(parts => cut(parts[0], 3)),
        fields: family.fields.map((_, f) => values.map(parts => cut(parts[f + 1], widths[f + 1]))),
    };
}

// Adds weight * (e x f' + e' x f) of every leaf to its corners, for the edges e, f of the positions a and those of b.
function sumProducts(mesh, a, b, factor, sums) {
    const { triangles, leafCount } = mesh, normal = [0, 0, 0];
    for (let t = 0; t < 4 * leafCount; t += 4) {
        const i = 3 * triangles[t], j = 3 * triangles[t + 1], k = 3 * triangles[t + 2], tag = triangles[t + 3];
        for (let c = 0; c < 3; ++c) {
            const d = (c + 1) % 3, e = (c + 2) % 3;
            normal[c] = (a[j + d] - a[i + d]) * (b[k + e] - b[i + e]) - (a[j + e] - a[i + e]) * (b[k + d] - b[i + d])
                + (b[j + d] - b[i + d]) * (a[k + e] - a[i + e]) - (b[j + e] - b[i + e]) * (a[k + d] - a[i + d]);
        }
        for (let corner = 0; corner < 3; ++corner) {
            const weight = factor * 2 ** (tag >>> 10 + 7 * corner & 127), v = 3 * triangles[t + corner];
            for (let c = 0; c < 3; ++c) sums[v + c] += weight * normal[c];
        }
    }
}

// At vertices that none of the keys owns: the mean of the ends of the edge, which come first.
function interpolateElsewhere(mesh, owners, sums) {
    for (let v = family.rootVertices; v < mesh.vertexCount; ++v) {
        if (mesh.owners[v] & owners) continue;
        const a = 3 * mesh.edges[2 * v], b = 3 * mesh.edges[2 * v + 1];
        for (let c = 0; c < 3; ++c) sums[3 * v + c] = 0.5 * (sums[a + c] + sums[b + c]);
    }
}

// The normal products: N(b) = sum of b_i b_j N_ij over i <= j.
function normalProducts(mesh) {
    const products = [];
    for (let j = 0; j < mesh.keyCount; ++j)
        for (let i = 0; i <= j; ++i) {
            const sums = new Float32Array(3 * mesh.vertexCount);
            sumProducts(mesh, mesh.positions[i], mesh.positions[j], i === j ? 0.5 : 1, sums);
            interpolateElsewhere(mesh, 1 << i | 1 << j, sums);
            products.push(sums);
        }
    return products;
}

function weightedSum(streams, weights) {
    const sum = new Float32Array(streams[0].length);
    streams.forEach((stream, q) => { for (let n = 0; n < sum.length; ++n) sum[n] += weights[q] * stream[n]; });
    return sum;
}

// ---- Weights: of a time, and of a point of the parameter domain

// Weights are a Map from the index of a key to its weight.
function added(entries) {
    const weights = new Map();
    for (const [key, value] of entries) weights.set(key, (weights.get(key) ?? 0) + value);
    return weights;
}

function intervalAt(times, time) {
    let i = 0;
    while (i + 2 < times.length && times[i + 1] <= time) ++i;
    return i;
}

function bernstein(times, time) {
    const s = (time - times[0]) / (times.at(-1) - times[0]);
    let values = [1];
    for (let degree = 1; degree < times.length; ++degree)
        values = Array.from({ length: degree + 1 }, (_, i) => (values[i] ?? 0) * (1 - s) + (values[i - 1] ?? 0) * s);
    return values.map((value, i) => [i, value]);
}

function bernsteinPieces(times, time) {
    const degree = family.timeline.degree ?? 0;
    if (degree === 0 || degree >= times.length) return bernstein(times, time);
    const first = Math.floor(intervalAt(times, time) / degree) * degree;
    return bernstein(times.slice(first, first + degree + 1), time).map(([i, value]) => [first + i, value]);
}

function catmullRom(times, time) {
    const i = intervalAt(times, time), length = times[i + 1] - times[i];
    const after = (times[i + 1] - time) / length, before = (time - times[i]) / length;
    const entries = [[i, after * after * (1 + 2 * before)], [i + 1, before * before * (1 + 2 * after)]];
    const slope = (from, part) => entries.push([from, -part / (times[from + 1] - times[from])], [from + 1, part / (times[from + 1] - times[from])]);
    const tangent = (at, factor) => {
        if (at === 0) return slope(0, factor);
        if (at + 1 === times.length) return slope(at - 1, factor);
        const both = times[at + 1] - times[at - 1];
        slope(at - 1, factor * (times[at + 1] - times[at]) / both);
        slope(at, factor * (times[at] - times[at - 1]) / both);
    };
    tangent(i, length * before * after * after);
    tangent(i + 1, -length * before * before * after);
    return entries;
}

function bSpline(times, time) {
    const degree = Math.min(3, times.length - 1), inner = degree === 3 ? times.slice(2, -2) : [];
    const ends = time => Array(degree + 1).fill(time), knots = [...ends(times[0]), ...inner, ...ends(times.at(-1))];
    const first = intervalAt(knots.slice(degree, knots.length - degree), time), span = first + degree, values = [1];
    for (let d = 1; d <= degree; ++d) {
        let carried = 0;
        for (let r = 0; r < d; ++r) {
            const right = knots[span + r + 1] - time, left = time - knots[span + 1 + r - d], part = values[r] / (right + left);
            values[r] = carried + right * part;
            carried = left * part;
        }
        values[d] = carried;
    }
    return values.map((value, r) => [first + r, value]);
}

// What each value of a natural cubic spline contributes to its second derivative at one place.
function secondDerivativeRow(times, at) {
    const count = times.length, row = Array(count).fill(0), z = Array(count).fill(0), upper = Array(count).fill(0);
    if (at === 0 || at + 1 >= count) return row;
    const step = i => times[i + 1] - times[i];
    z[at] = 1;
    for (let i = 1; i + 1 < count; ++i) {
        const lower = i > 1 ? step(i - 1) / 6 : 0, pivot = (step(i - 1) + step(i)) / 3 - lower * upper[i - 1];
        upper[i] = step(i) / 6 / pivot;
        z[i] = (z[i] - lower * z[i - 1]) / pivot;
    }
    for (let i = count - 2; i > 0; --i) z[i] -= upper[i] * z[i + 1];
    for (let i = 1; i + 1 < count; ++i) {
        const left = z[i] / step(i - 1), right = z[i] / step(i);
        row[i - 1] += left;
        row[i] -= left + right;
        row[i + 1] += right;
    }
    return row;
}

function spline(times, time) {
    const i = intervalAt(times, time), length = times[i + 1] - times[i];
    const after = (times[i + 1] - time) / length, before = (time - times[i]) / length;
    const left = secondDerivativeRow(times, i), right = secondDerivativeRow(times, i + 1), square = length * length;
    const most = square / (9 * Math.sqrt(3)), entries = [];
    let sum = 0;
    for (let at = 0; at < times.length; ++at) {
        if (at !== i && at !== i + 1 && most * (Math.abs(left[at]) + Math.abs(right[at])) < 1e-7) continue;
        const value = square / 6 * (after * (after * after - 1) * left[at] + before * (before * before - 1) * right[at])
            + (at === i ? after : at === i + 1 ? before : 0);
        entries.push([at, value]);
        sum += value;
    }
    return entries.map(([at, value]) => [at, value / sum]);
}

const bases = {
    "linear": (times, time) => {
        const i = intervalAt(times, time), s = (time - times[i]) / (times[i + 1] - times[i]);
        return [[i, 1 - s], [i + 1, s]];
    },
    "hold": (times, time) => [[time === times.at(-1) ? times.length - 1 : intervalAt(times, time), 1]],
    "bernstein": bernsteinPieces, "catmull-rom": catmullRom, "b-spline": bSpline, "spline": spline,
};

function timelineWeights(time) {
    const entries = family.timeline.keys, times = entries.map(entry => entry.time);
    const places = times.length === 1 ? [[0, 1]] : bases[family.timeline.interpolation](times, time);
    return added(places.map(([place, value]) => [keyAt(entries[place].key), value]));
}

const path = family.domain?.path;
const followsPath = path !== undefined && (family.domain.path_drives || !family.timeline);
const moments = followsPath ? path : family.timeline?.keys;

function pathPoint(time) {
    if (path.length === 1) return path[0].at;
    const i = intervalAt(path.map(point => point.time), time), s = (time - path[i].time) / (path[i + 1].time - path[i].time);
    return [0, 1].map(c => (1 - s) * path[i].at[c] + s * path[i + 1].at[c]);
}

const corners = triangle => triangle.map(v => family.domain.vertices[v].at);

// Barycentric coordinates of the point of a triangle that is nearest to p, and the distance to it.
function nearest(p, [a, b, c]) {
    const cross = (u, v, w) => (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0]);
    const area = cross(a, b, c), inside = [cross(p, b, c) / area, cross(a, p, c) / area, cross(a, b, p) / area];
    if (Math.min(...inside) >= 0) return { coordinates: inside, distance: 0 };
    const triangle = [a, b, c], found = { distance: Infinity };
    for (let side = 0; side < 3; ++side) {
        const from = triangle[side], to = triangle[(side + 1) % 3], d = [to[0] - from[0], to[1] - from[1]];
        const s = Math.min(1, Math.max(0, ((p[0] - from[0]) * d[0] + (p[1] - from[1]) * d[1]) / (d[0] ** 2 + d[1] ** 2)));
        const distance = Math.hypot(from[0] + s * d[0] - p[0], from[1] + s * d[1] - p[1]);
        if (distance >= found.distance) continue;
        found.distance = distance;
        found.coordinates = [0, 0, 0];
        found.coordinates[side] = 1 - s;
        found.coordinates[(side + 1) % 3] = s;
    }
    return found;
}

let currentTriangle = -1;  // preferred where triangles meet, so that dragging changes no union needlessly

// The weights of the point of the domain that is nearest to p, and that point.
function domainPlace(p, prefersCurrent) {
    const triangles = family.domain.triangles;
    let best = null;
    triangles.forEach((triangle, number) => {
        const { coordinates, distance } = nearest(p, corners(triangle));
        const wins = best === null || distance < best.distance || (prefersCurrent && distance === best.distance && number === currentTriangle);
        if (wins) best = { coordinates, distance, number };
    });
    currentTriangle = best.number;
    const triangle = triangles[best.number], at = corners(triangle);
    return {
        weights: added(triangle.map((v, c) => [keyAt(family.domain.vertices[v].key), best.coordinates[c]])),
        point: [0, 1].map(c => at.reduce((sum, corner, n) => sum + best.coordinates[n] * corner[c], 0)),
    };
}

// The point of the domain with the given weights; null where it is not unique.
function pointOf(weights) {
    const vertices = family.domain.vertices, at = [0, 0];
    const places = [...weights].map(([key, value]) => {
        const found = vertices.flatMap((vertex, v) => keyAt(vertex.key) === key ? [v] : []);
        return { vertex: found.length === 1 ? found[0] : -1, value };
    });
    const share = family.domain.triangles.some(triangle => places.every(({ vertex }) => triangle.includes(vertex)));
    if (!share || places.some(({ value }) => value < 0)) return null;
    for (const { vertex, value } of places) vertices[vertex].at.forEach((x, c) => { at[c] += value * x; });
    return at;
}

// ---- The state

const state = { roots: null, keys: [], unions: new Map(), mesh: null, weights: new Map(), time: 0, point: null, playing: false };
const view = { azimuth: 30, elevation: 20, zoom: 1 };

// Shows a blend. The union changes only with the set of active keys.
function show(weights, point) {
    const active = [...weights.keys()].sort((a, b) => a - b), name = active.join();
    if (active.length === 0 || active.length > 31) throw new RangeError("expected 1 to 31 keys with weights");
    let mesh = state.unions.get(name);
    if (!mesh) {
        mesh = unite(state.roots, active.map(key => state.keys[key]));
        mesh.active = active;
        if (active.length <= mostShaderKeys) mesh.products = normalProducts(mesh);
        if (state.unions.size > 15) state.unions.delete(state.unions.keys().next().value);
        state.unions.set(name, mesh);
    }
    state.weights = weights;
    state.point = point;
    if (mesh !== state.mesh) { state.mesh = mesh; uploads = true; }
    redraw();
}

function setTime(time) {
    if (!moments) throw new RangeError("the family has no timeline");
    if (!(typeof time === "number" && !Number.isNaN(time))) throw new RangeError("expected a time in seconds");
    state.time = Math.min(Math.max(time, moments[0].time), moments.at(-1).time);
    if (followsPath) {
        const { weights, point } = domainPlace(pathPoint(state.time), false);
        return show(weights, point);
    }
    const weights = timelineWeights(state.time);
    show(weights, family.domain ? pointOf(weights) : null);
}

function setPoint(u, v) {
    if (!family.domain) throw new RangeError("the family has no parameter domain");
    if (!Number.isFinite(u) || !Number.isFinite(v)) throw new RangeError("expected two numbers");
    const { weights, point } = domainPlace([u, v], false);
    show(weights, point);
}

function dragPoint(p) {
    const { weights, point } = domainPlace(p, true);
    show(weights, point);
}

function setWeights(given) {
    show(added(Object.entries(given).map(([name, value]) => {
        if (keyAt(name) < 0 || !Number.isFinite(value)) throw new RangeError(`there is no key "${name}", or its weight is no number`);
        return [keyAt(name), value];
    })), null);
}

const weightList = () => state.mesh.active.map(key => state.weights.get(key));
// Positions of the blend in the coordinates of the keys, three numbers per vertex.
const positions = () => weightedSum(state.mesh.positions, weightList()).map((x, n) => x + center[n % 3] * weightList().reduce((a, b) => a + b, 0));
const triangles = () => Uint32Array.from({ length: 3 * state.mesh.leafCount }, (_, n) => state.mesh.triangles[4 * Math.floor(n / 3) + n % 3]);

// ---- Drawing

const canvas = element("surface");
const gl = canvas.getContext("webgl2", { antialias: true, alpha: false, preserveDrawingBuffer: true });
const columns = 2048;
let program = null, uniforms = {}, textures = {}, uploads = true, waits = false;

function complain(text) {
    element("message").textContent = text;
    element("message").hidden = false;
}

const hex = code => [16, 8, 0].map(shift => linear((code >> shift & 255) / 255));
const viridis = [0x440154, 0x481f70, 0x443983, 0x3b528b, 0x31688e, 0x287c8e, 0x21918c, 0x20a486, 0x35b779, 0x5ec962, 0x90d743, 0xc8e020, 0xfde725];

function makeProgram() {
    program = gl.createProgram();
    for (const [kind, id] of [[gl.VERTEX_SHADER, "vertex-shader"], [gl.FRAGMENT_SHADER, "fragment-shader"]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, element(id).textContent.trim());
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) throw new Error(gl.getShaderInfoLog(shader));
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    uniforms = new Proxy({}, { get: (found, name) => found[name] ??= gl.getUniformLocation(program, name) });
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
    if (rows > gl.getParameter(gl.MAX_TEXTURE_SIZE)) return complain("The surface is too large for this graphics card.");
    const data = isInteger ? new Uint32Array(4 * columns * rows) : new Float32Array(4 * columns * rows);
    fill(data);
    gl.activeTexture(gl.TEXTURE0 + textures[name].slot);
    gl.bindTexture(gl.TEXTURE_2D, textures[name].texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    if (isInteger) gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32UI, columns, rows, 0, gl.RGBA_INTEGER, gl.UNSIGNED_INT, data);
    else gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, columns, rows, 0, gl.RGBA, gl.FLOAT, data);
}

const uploadStreams = (name, streams, width) => upload(name, streams.reduce((sum, s) => sum + s.length / width, 0), false, data => {
    let at = 0;
    for (const stream of streams)
        for (let n = 0; n < stream.length; n += width, at += 4)
            for (let c = 0; c < width; ++c) data[at + c] = stream[n + c];
});

const chosenField = () => family.fields.findIndex(field => "field " + field.name === element("color").value);

function uploadMesh() {
    const mesh = state.mesh, f = chosenField();
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
    const weights = weightList(), sum = weightedSum(mesh.positions, weights), normals = new Float32Array(sum.length);
    sumProducts(mesh, sum, sum, 0.5, normals);
    interpolateElsewhere(mesh, weights.reduce((owners, weight, q) => weight === 0 ? owners : owners | 1 << q, 0), normals);
    uploadStreams("positions", [sum], 3);
    uploadStreams("products", [normals], 3);
    if (f >= 0) uploadStreams("fields", [weightedSum(mesh.fields[f], weights)], width);
}

function matrices(width, height) {
    const [a, e] = [view.azimuth, view.elevation].map(degrees => degrees * Math.PI / 180), f = 1 / Math.tan(17.5 * Math.PI / 180);
    const distance = radius * Math.max(1, height / width) * 1.05 / Math.sin(17.5 * Math.PI / 180) / view.zoom;
    const x = [Math.cos(a), 0, -Math.sin(a)], z = [Math.cos(e) * Math.sin(a), Math.sin(e), Math.cos(e) * Math.cos(a)];
    const y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
    const near = Math.max(distance - 2 * radius, distance / 100), far = distance + 2 * radius;
    return {
        view: [x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, 0, 0, -distance, 1],
        projection: [f * height / width, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0],
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
    const ratio = Math.min(devicePixelRatio || 1, 2), width = Math.max(1, Math.round(canvas.clientWidth * ratio)), height = Math.max(1, Math.round(canvas.clientHeight * ratio));
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    if (uploads || !state.mesh.products) uploadMesh();
    const f = chosenField(), field = family.fields[f], mesh = state.mesh;
    const coloring = element("color").value === "level" ? 1 : f < 0 ? 0 : field.kind === "color" ? 3 : 2, range = colorRange(coloring, field);
    const weights = mesh.products ? weightList() : [1];
    gl.viewport(0, 0, width, height);
    const back = getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(n => n / 255);
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
    gl.uniform3i(uniforms.edges, element("refinement").checked, element("wireframe").checked, element("roots").checked);
    gl.uniform1f(uniforms.line_width, 0.75 * ratio);
    gl.drawArrays(gl.TRIANGLES, 0, 3 * mesh.leafCount);
    drawPanel(coloring, range);
}

// Draws before the next picture of the screen.
function redraw() {
    if (!waits) requestAnimationFrame(draw);
    waits = true;
}

// ---- The panel

const shown = x => Number(x.toPrecision(4)).toString();

function drawPanel(coloring, range) {
    element("figures").textContent = `${state.mesh.leafCount.toLocaleString("en")} leaves, ${state.mesh.active.map(key => keyNames[key]).join(", ")}`;
    element("legend").hidden = coloring !== 1 && coloring !== 2;
    [element("least").textContent, element("most").textContent] = range.map(shown);
    if (moments) {
        element("time").value = state.time;
        element("seconds").textContent = `${state.time.toFixed(2)} s`;
    }
    if (family.domain) drawDomain();
}

const domainBox = family.domain && [0, 1].map(c => { const all = family.domain.vertices.map(vertex => vertex.at[c]); return [Math.min(...all), Math.max(...all)]; });
const domainSize = family.domain && (Math.max(...domainBox.map(([a, b]) => b - a)) || 1);
const margin = 0.1;
// From the domain to the unit square of its canvas, and back.
const toCanvas = p => [0.5 + (1 - 2 * margin) * (p[0] - (domainBox[0][0] + domainBox[0][1]) / 2) / domainSize, 0.5 - (1 - 2 * margin) * (p[1] - (domainBox[1][0] + domainBox[1][1]) / 2) / domainSize];
const fromCanvas = p => [(p[0] - 0.5) / (1 - 2 * margin) * domainSize + (domainBox[0][0] + domainBox[0][1]) / 2, (0.5 - p[1]) / (1 - 2 * margin) * domainSize + (domainBox[1][0] + domainBox[1][1]) / 2];

function drawDomain() {
    const plot = element("domain"), size = Math.max(1, Math.round(plot.clientWidth * (devicePixelRatio || 1))), pen = plot.getContext("2d");
    if (plot.width !== size) plot.width = plot.height = size;
    const style = getComputedStyle(document.documentElement), color = name => style.getPropertyValue(name);
    const scaled = p => toCanvas(p).map(x => x * size), dot = (p, radius) => { pen.beginPath(); pen.arc(...scaled(p), radius * size, 0, 7); pen.fill(); };
    const line = points => { pen.beginPath(); points.forEach(p => pen.lineTo(...scaled(p))); };
    pen.clearRect(0, 0, size, size);
    pen.lineWidth = size / 200;
    pen.strokeStyle = pen.fillStyle = color("--pale");
    for (const triangle of family.domain.triangles) {
        line(corners(triangle));
        pen.closePath();
        pen.stroke();
    }
    if (path) {
        pen.strokeStyle = color("--mark");
        line(path.map(point => point.at));
        pen.stroke();
    }
    pen.font = `${size / 17}px system-ui, sans-serif`;
    pen.textAlign = "center";
    for (const vertex of family.domain.vertices) {
        pen.fillStyle = color(state.weights.has(keyAt(vertex.key)) ? "--front" : "--pale");
        dot(vertex.at, 0.016);
        const [x, y] = scaled(vertex.at), half = pen.measureText(vertex.key).width / 2 + 2;
        pen.fillText(vertex.key, Math.min(size - half, Math.max(half, x)), y > size / 2 ? y + size / 13 : y - size / 30, size);
    }
    if (!state.point) return;
    pen.fillStyle = color("--mark");
    dot(state.point, 0.03);
}

// ---- Input

function stop() {
    state.playing = false;
    element("play").textContent = "Play";
}

function play() {
    state.playing = true;
    element("play").textContent = "Pause";
    let last = performance.now();
    const step = now => {
        if (!state.playing) return;
        const [begin, end] = [moments[0].time, moments.at(-1).time], time = state.time + (now - last) / 1000;
        last = now;
        setTime(time > end ? begin + (time - begin) % (end - begin || 1) : time);
        requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
}

const turn = (x, y) => {
    view.azimuth -= 0.4 * x;
    view.elevation = Math.max(-89.9, Math.min(89.9, view.elevation + 0.4 * y));
    redraw();
};
const zoom = factor => { view.zoom = Math.max(0.2, Math.min(50, view.zoom * factor)); redraw(); };
const frame = () => { Object.assign(view, { azimuth: 30, elevation: 20, zoom: 1 }); redraw(); };

function listenToSurface() {
    const pointers = new Map();
    const spread = () => { const [a, b] = [...pointers.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]) || 1; };
    canvas.addEventListener("pointerdown", event => {
        pointers.set(event.pointerId, [event.clientX, event.clientY]);
        canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", event => {
        const before = pointers.get(event.pointerId);
        if (!before) return;
        const spreadBefore = pointers.size === 2 && spread();
        pointers.set(event.pointerId, [event.clientX, event.clientY]);
        if (pointers.size === 1) turn(event.clientX - before[0], event.clientY - before[1]);
        if (spreadBefore) zoom(spread() / spreadBefore);
    });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, event => pointers.delete(event.pointerId));
    canvas.addEventListener("wheel", event => { event.preventDefault(); zoom(Math.exp(-0.001 * event.deltaY)); }, { passive: false });
    canvas.addEventListener("dblclick", frame);
    canvas.addEventListener("webglcontextlost", event => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => { makeProgram(); redraw(); });
}

function listenToDomain() {
    const plot = element("domain");
    const drag = event => {
        if (event.type === "pointermove" && !event.buttons) return;
        const box = plot.getBoundingClientRect();
        plot.setPointerCapture(event.pointerId);
        stop();
        dragPoint(fromCanvas([(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height]));
    };
    plot.addEventListener("pointerdown", drag);
    plot.addEventListener("pointermove", drag);
    plot.addEventListener("keydown", event => {
        const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
        if (!step) return;
        event.preventDefault();
        event.stopPropagation();
        stop();
        const from = state.point ?? fromCanvas([0.5, 0.5]);
        dragPoint([from[0] + step[0] * domainSize / 50, from[1] + step[1] * domainSize / 50]);
    });
}

function listenToKeys() {
    const step = direction => { stop(); setTime(state.time + direction * (moments.at(-1).time - moments[0].time) / 100); };
    const toggle = id => { element(id).checked = !element(id).checked; redraw(); };
    const commands = {
        e: () => toggle("refinement"), w: () => toggle("wireframe"), r: () => toggle("roots"), f: frame,
        "+": () => zoom(1.1), "-": () => zoom(1 / 1.1),
    };
    if (moments) Object.assign(commands, {
        " ": () => element("play").click(), ArrowLeft: () => step(-1), ArrowRight: () => step(1),
        Home: () => { stop(); setTime(moments[0].time); }, End: () => { stop(); setTime(moments.at(-1).time); },
    });
    addEventListener("keydown", event => {
        const command = commands[event.key.length === 1 ? event.key.toLowerCase() : event.key];
        if (!command || event.ctrlKey || event.metaKey || event.altKey || /^(INPUT|SELECT|BUTTON|SUMMARY)$/.test(event.target.tagName)) return;
        event.preventDefault();
        command();
    });
}

function preparePanel() {
    element("name").textContent = family.name;
    const choices = [["plain", "Plain"], ["level", "Level"], ...family.fields.map(field => ["field " + field.name, field.name])];
    for (const [value, text] of choices) element("color").append(new Option(text, value));
    element("color").addEventListener("change", () => { uploads = true; redraw(); });
    for (const id of ["refinement", "wireframe", "roots"]) element(id).addEventListener("change", redraw);
    const pen = element("scale").getContext("2d"), gradient = pen.createLinearGradient(0, 0, 256, 0);
    viridis.forEach((code, n) => gradient.addColorStop(n / (viridis.length - 1), "#" + code.toString(16).padStart(6, "0")));
    pen.fillStyle = gradient;
    pen.fillRect(0, 0, 256, 1);
    element("panel").open = innerWidth > 640 || innerHeight > 640;
    element("panel").addEventListener("toggle", redraw);
    if (moments) {
        element("timeline").hidden = false;
        [element("time").min, element("time").max] = [moments[0].time, moments.at(-1).time];
        element("time").addEventListener("input", event => { stop(); setTime(Number(event.target.value)); });
        element("play").addEventListener("click", () => state.playing ? stop() : play());
    }
    element("domain").hidden = !family.domain;
    addEventListener("resize", redraw);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
}

// The blend that the address asks for, such as #time=1.5&show=wireframe,roots&color=level; otherwise the first one.
function showFirst() {
    const asked = new URLSearchParams(location.hash.slice(1)), point = (asked.get("at") ?? "").split(",").map(Number);
    for (const id of (asked.get("show") ?? "").split(",")) if (["refinement", "wireframe", "roots"].includes(id)) element(id).checked = true;
    if ([...element("color").options].some(option => option.value === asked.get("color"))) element("color").value = asked.get("color");
    if (asked.has("at") && family.domain) return setPoint(...point);
    if (moments) return setTime(asked.has("time") ? Number(asked.get("time")) : 0);
    if (family.domain) return setPoint(...family.domain.vertices[0].at);
    show(new Map([[0, 1]]), null);
}

async function start() {
    if (!gl) throw new Error("This page needs WebGL 2.");
    makeProgram();
    Object.assign(state, decoded(await inflated(element("data").textContent.trim())));
    const squares = state.keys.map(({ positions: p }) => p.reduce((most, _, n) => n % 3 ? most : Math.max(most, p[n] ** 2 + p[n + 1] ** 2 + p[n + 2] ** 2), 0));
    radius = Math.sqrt(Math.max(...squares)) || 1;
    preparePanel();
    listenToSurface();
    listenToKeys();
    if (family.domain) listenToDomain();
    showFirst();
}

const ready = start();
ready.catch(error => complain(error.message));
window.interleaf = { ready, setTime, setPoint, setWeights, positions, triangles };

})();
