// The union of keys (paper, theorem 2) and the products of its normals, as union_mesh.h and vertex_normals.h.

// The tags of a triangle's children: bits 0-6 the level, 7-9 sides on root edges, then the exponents of the
// corner weights, 7 bits each.
function childTags(tag) {
    const common = ((tag & 127) + 1) | (((tag & 127) + 1) << 10);
    const [i, j, k] = [(tag >>> 10) & 127, (tag >>> 17) & 127, (tag >>> 24) & 127];
    return [
        common | ((tag >>> 1) & 128) | ((tag << 2) & 512) | ((k + 1) << 17) | (i << 24),
        common | ((tag >>> 2) & 128) | ((tag << 1) & 256) | (i << 17) | ((j + 1) << 24)
    ];
}

function unite(roots, keys) {
    const capacity = keys.reduce((sum, key) => sum + key.vertices, 0);
    const leafCapacity = keys.reduce((sum, key) => sum + key.midpoints.length, roots.length / 3);
    const triangles = new Uint32Array(4 * leafCapacity); // three vertices and the tag
    const edges = new Uint32Array(2 * capacity),
        owners = new Uint32Array(capacity);
    const streams = list => keys.map(() => list.map(width => new Float32Array(width * capacity)));
    const widths = [3, ...family.fields.map(field => (field.kind === "color" ? 3 : 1))];
    const values = streams(widths);
    const own = keys.map(key => [key.positions, ...key.fields]);
    const numbers = keys.map(key => new Int32Array(key.vertices).fill(-1));
    const nodes = new Uint32Array(keys.length),
        bisected = new Uint32Array(keys.length);
    const all = 2 ** keys.length - 1;
    let vertexCount = family.rootVertices,
        leafCount = 0;
    const place = (q, v, m) => {
        numbers[q][v] = m;
        owners[m] |= 1 << q;
        widths.forEach((width, p) => {
            for (let c = 0; c < width; ++c) values[q][p][width * m + c] = own[q][p][width * v + c];
        });
    };
    for (let v = 0; v < family.rootVertices; ++v) keys.forEach((_, q) => place(q, v, v));
    const stack = [],
        midpoints = new Int32Array(keys.length);
    for (let r = 0; r < roots.length; r += 3) {
        stack.push(roots[r], roots[r + 1], roots[r + 2], 7 << 7, all);
        while (stack.length > 0) {
            const active = stack.pop(),
                tag = stack.pop(),
                k = stack.pop(),
                j = stack.pop(),
                i = stack.pop();
            let here = 0,
                m = -1;
            for (let q = 0; q < keys.length; ++q) {
                if (!((active >> q) & 1)) continue;
                const node = nodes[q]++;
                if (!((keys[q].bits[node >> 3] >> (node & 7)) & 1)) continue;
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
                    if ((here >> q) & 1) continue;
                    widths.forEach((width, p) => {
                        const to = values[q][p];
                        for (let c = 0; c < width; ++c)
                            to[width * m + c] = 0.5 * (to[width * j + c] + to[width * k + c]);
                    });
                }
            }
            for (let q = 0; q < keys.length; ++q)
                if ((here >> q) & 1 && numbers[q][midpoints[q]] < 0) place(q, midpoints[q], m);
            const [first, second] = childTags(tag);
            stack.push(m, i, j, second, here, m, k, i, first, here);
        }
    }
    const cut = (array, width) => array.subarray(0, width * vertexCount);
    return {
        keyCount: keys.length,
        vertexCount,
        leafCount,
        triangles: triangles.subarray(0, 4 * leafCount),
        edges,
        owners,
        positions: values.map(parts => cut(parts[0], 3)),
        fields: family.fields.map((_, f) => values.map(parts => cut(parts[f + 1], widths[f + 1])))
    };
}

// Adds weight * (e x f' + e' x f) of every leaf to its corners, for the edges e, f of the positions a and
// e', f' of the positions b.
function sumProducts(mesh, a, b, factor, sums) {
    const { triangles, leafCount } = mesh,
        normal = [0, 0, 0];
    for (let t = 0; t < 4 * leafCount; t += 4) {
        const i = 3 * triangles[t],
            j = 3 * triangles[t + 1],
            k = 3 * triangles[t + 2],
            tag = triangles[t + 3];
        for (let c = 0; c < 3; ++c) {
            const d = (c + 1) % 3,
                e = (c + 2) % 3;
            normal[c] =
                (a[j + d] - a[i + d]) * (b[k + e] - b[i + e]) -
                (a[j + e] - a[i + e]) * (b[k + d] - b[i + d]) +
                (b[j + d] - b[i + d]) * (a[k + e] - a[i + e]) -
                (b[j + e] - b[i + e]) * (a[k + d] - a[i + d]);
        }
        for (let corner = 0; corner < 3; ++corner) {
            const weight = factor * 2 ** ((tag >>> (10 + 7 * corner)) & 127),
                v = 3 * triangles[t + corner];
            for (let c = 0; c < 3; ++c) sums[v + c] += weight * normal[c];
        }
    }
}

// At vertices that none of the keys owns: the mean of the ends of the edge, which come first.
function interpolateElsewhere(mesh, owners, sums) {
    for (let v = family.rootVertices; v < mesh.vertexCount; ++v) {
        if (mesh.owners[v] & owners) continue;
        const a = 3 * mesh.edges[2 * v],
            b = 3 * mesh.edges[2 * v + 1];
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
            interpolateElsewhere(mesh, (1 << i) | (1 << j), sums);
            products.push(sums);
        }
    return products;
}

function weightedSum(streams, weights) {
    const sum = new Float32Array(streams[0].length);
    streams.forEach((stream, q) => {
        for (let n = 0; n < sum.length; ++n) sum[n] += weights[q] * stream[n];
    });
    return sum;
}
