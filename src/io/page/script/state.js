// What is shown, and the functions that change it.

const state = {
    roots: null,
    keys: [],
    unions: new Map(),
    mesh: null,
    weights: new Map(),
    time: 0,
    point: null,
    playing: false
};
const view = { azimuth: 30, elevation: 20, zoom: 1 };

// Shows a blend. The union changes only with the set of active keys.
function show(weights, point) {
    const active = [...weights.keys()].sort((a, b) => a - b),
        name = active.join();
    if (active.length === 0 || active.length > 31) throw new RangeError("expected 1 to 31 keys with weights");
    let mesh = state.unions.get(name);
    if (!mesh) {
        mesh = unite(
            state.roots,
            active.map(key => state.keys[key])
        );
        mesh.active = active;
        if (active.length <= mostShaderKeys) mesh.products = normalProducts(mesh);
        if (state.unions.size > 15) state.unions.delete(state.unions.keys().next().value);
        state.unions.set(name, mesh);
    }
    state.weights = weights;
    state.point = point;
    if (mesh !== state.mesh) {
        state.mesh = mesh;
        uploads = true;
    }
    redraw();
}

function setTime(time) {
    if (!moments) throw new RangeError("the family has no timeline");
    if (!(typeof time === "number" && !Number.isNaN(time)))
        throw new RangeError("expected a time in seconds");
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
    show(
        added(
            Object.entries(given).map(([name, value]) => {
                if (keyAt(name) < 0 || !Number.isFinite(value))
                    throw new RangeError(`there is no key "${name}", or its weight is no number`);
                return [keyAt(name), value];
            })
        ),
        null
    );
}

const weightList = () => state.mesh.active.map(key => state.weights.get(key));
// Positions of the blend in the coordinates of the keys, three numbers per vertex.
const positions = () =>
    weightedSum(state.mesh.positions, weightList()).map(
        (x, n) => x + center[n % 3] * weightList().reduce((a, b) => a + b, 0)
    );
const triangles = () =>
    Uint32Array.from(
        { length: 3 * state.mesh.leafCount },
        (_, n) => state.mesh.triangles[4 * Math.floor(n / 3) + (n % 3)]
    );
