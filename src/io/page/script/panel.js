// Draws the panel: figures, legend, parameter domain.

// A value with as many digits as its range needs.
function shown(x, span) {
    const more = span && x ? Math.floor(Math.log10(Math.abs(x))) - Math.floor(Math.log10(span)) : 0;
    return Number(x.toPrecision(Math.min(15, 4 + Math.max(0, more)))).toString();
}
const timeUnit = followsPath
    ? "s"
    : (family.timeline?.unit_name ?? (family.timeline?.unit === "steps" ? "" : "s"));

// `field` has the offset and the unit of a scalar.
function drawPanel(coloring, range, field) {
    const names = state.mesh.active.map(key => keyNames[key]).join(", ");
    element("figures").textContent = `${state.mesh.leafCount.toLocaleString("en")} leaves, ${names}`;
    element("legend").hidden = coloring !== 1 && coloring !== 2;
    [element("least").textContent, element("most").textContent] = range.map(
        x => `${shown(x + (field.offset ?? 0), range[1] - range[0])} ${field.unit ?? ""}`
    );
    if (moments) {
        element("time").value = state.time;
        element("seconds").textContent = `${state.time.toFixed(2)} ${timeUnit}`;
    }
    if (family.domain) drawDomain();
}

const domainBox =
    family.domain &&
    [0, 1].map(c => {
        const all = family.domain.vertices.map(vertex => vertex.at[c]);
        return [Math.min(...all), Math.max(...all)];
    });
const domainSize = family.domain && (Math.max(...domainBox.map(([a, b]) => b - a)) || 1);
const margin = 0.1;
// From the domain to the unit square of its canvas, and back.
const toCanvas = p => [
    0.5 + ((1 - 2 * margin) * (p[0] - (domainBox[0][0] + domainBox[0][1]) / 2)) / domainSize,
    0.5 - ((1 - 2 * margin) * (p[1] - (domainBox[1][0] + domainBox[1][1]) / 2)) / domainSize
];
const fromCanvas = p => [
    ((p[0] - 0.5) / (1 - 2 * margin)) * domainSize + (domainBox[0][0] + domainBox[0][1]) / 2,
    ((0.5 - p[1]) / (1 - 2 * margin)) * domainSize + (domainBox[1][0] + domainBox[1][1]) / 2
];

function drawDomain() {
    const plot = element("domain"),
        size = Math.max(1, Math.round(plot.clientWidth * (devicePixelRatio || 1))),
        pen = plot.getContext("2d");
    if (plot.width !== size) plot.width = plot.height = size;
    const style = getComputedStyle(document.documentElement),
        color = name => style.getPropertyValue(name);
    const scaled = p => toCanvas(p).map(x => x * size),
        dot = (p, radius) => {
            pen.beginPath();
            pen.arc(...scaled(p), radius * size, 0, 7);
            pen.fill();
        };
    const line = points => {
        pen.beginPath();
        points.forEach(p => pen.lineTo(...scaled(p)));
    };
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
        const [x, y] = scaled(vertex.at),
            half = pen.measureText(vertex.key).width / 2 + 2;
        pen.fillText(
            vertex.key,
            Math.min(size - half, Math.max(half, x)),
            y > size / 2 ? y + size / 13 : y - size / 30,
            size
        );
    }
    if (!state.point) return;
    pen.fillStyle = color("--mark");
    dot(state.point, 0.03);
}
