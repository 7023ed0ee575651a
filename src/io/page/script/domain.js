// Weights of a point of the parameter domain, as parameter_domain.h.

const corners = triangle => triangle.map(v => family.domain.vertices[v].at);

// Barycentric coordinates of the point of a triangle that is nearest to p, and the distance to it.
function nearest(p, [a, b, c]) {
    const cross = (u, v, w) => (v[0] - u[0]) * (w[1] - u[1]) - (v[1] - u[1]) * (w[0] - u[0]);
    const area = cross(a, b, c),
        inside = [cross(p, b, c) / area, cross(a, p, c) / area, cross(a, b, p) / area];
    if (Math.min(...inside) >= 0) return { coordinates: inside, distance: 0 };
    const triangle = [a, b, c],
        found = { distance: Infinity };
    for (let side = 0; side < 3; ++side) {
        const from = triangle[side],
            to = triangle[(side + 1) % 3],
            d = [to[0] - from[0], to[1] - from[1]];
        const s = Math.min(
            1,
            Math.max(0, ((p[0] - from[0]) * d[0] + (p[1] - from[1]) * d[1]) / (d[0] ** 2 + d[1] ** 2))
        );
        const distance = Math.hypot(from[0] + s * d[0] - p[0], from[1] + s * d[1] - p[1]);
        if (distance >= found.distance) continue;
        found.distance = distance;
        found.coordinates = [0, 0, 0];
        found.coordinates[side] = 1 - s;
        found.coordinates[(side + 1) % 3] = s;
    }
    return found;
}

let currentTriangle = -1; // preferred where triangles meet, so that dragging changes no union needlessly

// The weights of the point of the domain that is nearest to p, and that point.
function domainPlace(p, prefersCurrent) {
    const triangles = family.domain.triangles;
    let best = null;
    triangles.forEach((triangle, number) => {
        const { coordinates, distance } = nearest(p, corners(triangle));
        const wins =
            best === null ||
            distance < best.distance ||
            (prefersCurrent && distance === best.distance && number === currentTriangle);
        if (wins) best = { coordinates, distance, number };
    });
    currentTriangle = best.number;
    const triangle = triangles[best.number],
        at = corners(triangle);
    return {
        weights: added(triangle.map((v, c) => [keyAt(family.domain.vertices[v].key), best.coordinates[c]])),
        point: [0, 1].map(c => at.reduce((sum, corner, n) => sum + best.coordinates[n] * corner[c], 0))
    };
}

// The point of the domain with the given weights; null where it is not unique.
function pointOf(weights) {
    const vertices = family.domain.vertices,
        at = [0, 0];
    const places = [...weights].map(([key, value]) => {
        const found = vertices.flatMap((vertex, v) => (keyAt(vertex.key) === key ? [v] : []));
        return { vertex: found.length === 1 ? found[0] : -1, value };
    });
    const share = family.domain.triangles.some(triangle =>
        places.every(({ vertex }) => triangle.includes(vertex))
    );
    if (!share || places.some(({ value }) => value < 0)) return null;
    for (const { vertex, value } of places)
        vertices[vertex].at.forEach((x, c) => {
            at[c] += value * x;
        });
    return at;
}
