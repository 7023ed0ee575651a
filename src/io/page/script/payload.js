// The family as the page holds it. docs/file-formats.md describes the data.

const element = id => document.getElementById(id);
const family = JSON.parse(element("family").textContent);
const keyNames = family.keys.map(key => key.name);
const keyAt = name => keyNames.indexOf(name);
const [low, high, unit] = [family.box[0], family.box[1], family.unit];
const center = low.map((x, c) => (x + high[c]) / 2);
let radius = 1; // of the sphere around the center that holds all keys
const mostShaderKeys = 4;

async function inflated(base64) {
    const bytes = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Reads numbers stored as three planes of bytes, lowest first, each with its sign in the lowest bit.
function planes(bytes, at, count) {
    const numbers = new Int32Array(count);
    for (let i = 0; i < count; ++i) {
        const n = bytes[at + i] | (bytes[at + count + i] << 8) | (bytes[at + 2 * count + i] << 16);
        numbers[i] = (n >>> 1) ^ -(n & 1);
    }
    return numbers;
}

function summed(numbers) {
    for (let i = 1; i < numbers.length; ++i) numbers[i] += numbers[i - 1];
    return numbers;
}

const linear = c => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);

// Walks the forest of one key; visit(midpoint, b, c) for each bisected node.
function walk(roots, bits, midpoints, visit) {
    let node = 0,
        bisected = 0;
    const stack = [];
    for (let r = 0; r < roots.length; r += 3) {
        stack.push(roots[r], roots[r + 1], roots[r + 2]);
        while (stack.length > 0) {
            const k = stack.pop(),
                j = stack.pop(),
                i = stack.pop();
            const isBisected = (bits[node >> 3] >> (node & 7)) & 1;
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
    const take = count => {
        const numbers = planes(bytes, at, count);
        at += 3 * count;
        return numbers;
    };
    const roots = summed(take(3 * family.roots));
    const keys = family.keys.map(({ vertices, bisections }) => {
        const bits = bytes.subarray(at, (at += (family.roots + 2 * bisections + 7) >> 3));
        const midpoints = summed(take(bisections));
        const widths = [3, ...family.fields.map(field => (field.kind === "color" ? 3 : 1))];
        const parts = widths.map(width => take(width * vertices)); // component after component
        const seen = new Uint8Array(vertices).fill(1, 0, family.rootVertices);
        walk(roots, bits, midpoints, (l, b, c) => {
            if (seen[l]) return;
            seen[l] = 1;
            widths.forEach((width, p) => {
                for (let v = 0; v < width; ++v)
                    parts[p][v * vertices + l] +=
                        (parts[p][v * vertices + b] + parts[p][v * vertices + c]) >> 1;
            });
        });
        const placed = (part, width, number) => {
            const values = new Float32Array(width * vertices);
            for (let v = 0; v < vertices; ++v)
                for (let c = 0; c < width; ++c) values[width * v + c] = number(part[c * vertices + v], c);
            return values;
        };
        const fields = family.fields.map((field, f) =>
            field.kind === "color"
                ? placed(parts[f + 1], 3, n => linear(n / 255))
                : placed(parts[f + 1], 1, n => field.min + (n * (field.max - field.min)) / 65535)
        );
        return {
            vertices,
            bits,
            midpoints,
            fields,
            positions: placed(parts[0], 3, (n, c) => n * unit + low[c] - center[c])
        };
    });
    return { roots, keys };
}
