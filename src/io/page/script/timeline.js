// Weights of a time: the bases of timelines once more, as interpolation.cpp and spline_weights.cpp have them. A test
// of the library compares the names in the table `bases`, and tests/peers the surfaces.

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
        values = Array.from(
            { length: degree + 1 },
            (_, i) => (values[i] ?? 0) * (1 - s) + (values[i - 1] ?? 0) * s
        );
    return values.map((value, i) => [i, value]);
}

function bernsteinPieces(times, time) {
    const degree = family.timeline.degree ?? 0;
    if (degree === 0 || degree >= times.length) return bernstein(times, time);
    const first = Math.floor(intervalAt(times, time) / degree) * degree;
    return bernstein(times.slice(first, first + degree + 1), time).map(([i, value]) => [first + i, value]);
}

function catmullRom(times, time) {
    const i = intervalAt(times, time),
        length = times[i + 1] - times[i];
    const after = (times[i + 1] - time) / length,
        before = (time - times[i]) / length;
    const entries = [
        [i, after * after * (1 + 2 * before)],
        [i + 1, before * before * (1 + 2 * after)]
    ];
    const slope = (from, part) =>
        entries.push(
            [from, -part / (times[from + 1] - times[from])],
            [from + 1, part / (times[from + 1] - times[from])]
        );
    const tangent = (at, factor) => {
        if (at === 0) return slope(0, factor);
        if (at + 1 === times.length) return slope(at - 1, factor);
        const both = times[at + 1] - times[at - 1];
        slope(at - 1, (factor * (times[at + 1] - times[at])) / both);
        slope(at, (factor * (times[at] - times[at - 1])) / both);
    };
    tangent(i, length * before * after * after);
    tangent(i + 1, -length * before * before * after);
    return entries;
}

function bSpline(times, time) {
    const degree = Math.min(3, times.length - 1),
        inner = degree === 3 ? times.slice(2, -2) : [];
    const ends = time => Array(degree + 1).fill(time),
        knots = [...ends(times[0]), ...inner, ...ends(times.at(-1))];
    const first = intervalAt(knots.slice(degree, knots.length - degree), time),
        span = first + degree,
        values = [1];
    for (let d = 1; d <= degree; ++d) {
        let carried = 0;
        for (let r = 0; r < d; ++r) {
            const right = knots[span + r + 1] - time,
                left = time - knots[span + 1 + r - d],
                part = values[r] / (right + left);
            values[r] = carried + right * part;
            carried = left * part;
        }
        values[d] = carried;
    }
    return values.map((value, r) => [first + r, value]);
}

// What each value of a natural cubic spline contributes to its second derivative at one place.
function secondDerivativeRow(times, at) {
    const count = times.length,
        row = Array(count).fill(0),
        z = Array(count).fill(0),
        upper = Array(count).fill(0);
    if (at === 0 || at + 1 >= count) return row;
    const step = i => times[i + 1] - times[i];
    z[at] = 1;
    for (let i = 1; i + 1 < count; ++i) {
        const lower = i > 1 ? step(i - 1) / 6 : 0,
            pivot = (step(i - 1) + step(i)) / 3 - lower * upper[i - 1];
        upper[i] = step(i) / 6 / pivot;
        z[i] = (z[i] - lower * z[i - 1]) / pivot;
    }
    for (let i = count - 2; i > 0; --i) z[i] -= upper[i] * z[i + 1];
    for (let i = 1; i + 1 < count; ++i) {
        const left = z[i] / step(i - 1),
            right = z[i] / step(i);
        row[i - 1] += left;
        row[i] -= left + right;
        row[i + 1] += right;
    }
    return row;
}

function spline(times, time) {
    const i = intervalAt(times, time),
        length = times[i + 1] - times[i];
    const after = (times[i + 1] - time) / length,
        before = (time - times[i]) / length;
    const left = secondDerivativeRow(times, i),
        right = secondDerivativeRow(times, i + 1),
        square = length * length;
    const most = square / (9 * Math.sqrt(3)),
        entries = [];
    let sum = 0;
    for (let at = 0; at < times.length; ++at) {
        if (at !== i && at !== i + 1 && most * (Math.abs(left[at]) + Math.abs(right[at])) < 1e-7) continue;
        const value =
            (square / 6) *
                (after * (after * after - 1) * left[at] + before * (before * before - 1) * right[at]) +
            (at === i ? after : at === i + 1 ? before : 0);
        entries.push([at, value]);
        sum += value;
    }
    return entries.map(([at, value]) => [at, value / sum]);
}

const bases = {
    linear: (times, time) => {
        const i = intervalAt(times, time),
            s = (time - times[i]) / (times[i + 1] - times[i]);
        return [
            [i, 1 - s],
            [i + 1, s]
        ];
    },
    hold: (times, time) => [[time === times.at(-1) ? times.length - 1 : intervalAt(times, time), 1]],
    bernstein: bernsteinPieces,
    "catmull-rom": catmullRom,
    "b-spline": bSpline,
    spline: spline
};

function timelineWeights(time) {
    const entries = family.timeline.keys,
        times = entries.map(entry => entry.time),
        basis = bases[family.timeline.interpolation];
    if (!basis) throw new RangeError(`this page does not know the interpolation ${family.timeline.interpolation}`);
    const places = times.length === 1 ? [[0, 1]] : basis(times, time);
    return added(places.map(([place, value]) => [keyAt(entries[place].key), value]));
}

const path = family.domain?.path;
const followsPath = path !== undefined && (family.domain.path_drives || !family.timeline);
const moments = followsPath ? path : family.timeline?.keys;

function pathPoint(time) {
    if (path.length === 1) return path[0].at;
    const i = intervalAt(
            path.map(point => point.time),
            time
        ),
        s = (time - path[i].time) / (path[i + 1].time - path[i].time);
    return [0, 1].map(c => (1 - s) * path[i].at[c] + s * path[i + 1].at[c]);
}
