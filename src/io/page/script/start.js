// Prepares the page, and gives window.interleaf, which docs/user-guide.md describes.

function preparePanel() {
    element("name").textContent = family.name;
    const choices = [
        ["plain", "Plain"],
        ["level", "Level"],
        ...family.fields.map(field => ["field " + field.name, field.name])
    ];
    for (const [value, text] of choices) element("color").append(new Option(text, value));
    element("color").addEventListener("change", () => {
        uploads = true;
        redraw();
    });
    for (const id of ["refinement", "wireframe", "roots"]) element(id).addEventListener("change", redraw);
    const pen = element("scale").getContext("2d"),
        gradient = pen.createLinearGradient(0, 0, 256, 0);
    viridis.forEach((code, n) =>
        gradient.addColorStop(n / (viridis.length - 1), "#" + code.toString(16).padStart(6, "0"))
    );
    pen.fillStyle = gradient;
    pen.fillRect(0, 0, 256, 1);
    element("panel").open = innerWidth > 640 || innerHeight > 640;
    element("panel").addEventListener("toggle", redraw);
    if (moments) {
        element("timeline").hidden = false;
        [element("time").min, element("time").max] = [moments[0].time, moments.at(-1).time];
        element("time").addEventListener("input", event => {
            stop();
            setTime(Number(event.target.value));
        });
        element("play").addEventListener("click", () => (state.playing ? stop() : play()));
    }
    element("domain").hidden = !family.domain;
    addEventListener("resize", redraw);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
}

// The blend that the address asks for, such as #time=1.5&show=wireframe,roots&color=level; otherwise the
// first one.
function showFirst() {
    const asked = new URLSearchParams(location.hash.slice(1)),
        point = (asked.get("at") ?? "").split(",").map(Number);
    for (const id of (asked.get("show") ?? "").split(","))
        if (["refinement", "wireframe", "roots"].includes(id)) element(id).checked = true;
    if ([...element("color").options].some(option => option.value === asked.get("color")))
        element("color").value = asked.get("color");
    if (asked.has("at") && family.domain) return setPoint(...point);
    if (moments) return setTime(asked.has("time") ? Number(asked.get("time")) : 0);
    if (family.domain) return setPoint(...family.domain.vertices[0].at);
    show(new Map([[0, 1]]), null);
}

async function start() {
    if (!gl) throw new Error("This page needs WebGL 2.");
    makeProgram();
    Object.assign(state, decoded(await inflated(element("data").textContent.trim())));
    const squares = state.keys.map(({ positions: p }) =>
        p.reduce(
            (most, _, n) => (n % 3 ? most : Math.max(most, p[n] ** 2 + p[n + 1] ** 2 + p[n + 2] ** 2)),
            0
        )
    );
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
