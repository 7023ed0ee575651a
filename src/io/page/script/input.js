// Mouse, touch and keys.

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
        const [begin, end] = [moments[0].time, moments.at(-1).time],
            time = state.time + (now - last) / 1000;
        last = now;
        setTime(time > end ? begin + ((time - begin) % (end - begin || 1)) : time);
        requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
}

const turn = (x, y) => {
    view.azimuth -= 0.4 * x;
    view.elevation = Math.max(-89.9, Math.min(89.9, view.elevation + 0.4 * y));
    redraw();
};
const zoom = factor => {
    view.zoom = Math.max(0.2, Math.min(50, view.zoom * factor));
    redraw();
};
const frame = () => {
    Object.assign(view, { azimuth: 30, elevation: 20, zoom: 1 });
    redraw();
};

function listenToSurface() {
    const pointers = new Map();
    const spread = () => {
        const [a, b] = [...pointers.values()];
        return Math.hypot(a[0] - b[0], a[1] - b[1]) || 1;
    };
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
    for (const end of ["pointerup", "pointercancel"])
        canvas.addEventListener(end, event => pointers.delete(event.pointerId));
    canvas.addEventListener(
        "wheel",
        event => {
            event.preventDefault();
            zoom(Math.exp(-0.001 * event.deltaY));
        },
        { passive: false }
    );
    canvas.addEventListener("dblclick", frame);
    canvas.addEventListener("webglcontextlost", event => event.preventDefault());
    canvas.addEventListener("webglcontextrestored", () => {
        makeProgram();
        redraw();
    });
}

function listenToDomain() {
    const plot = element("domain");
    const drag = event => {
        if (event.type === "pointermove" && !event.buttons) return;
        const box = plot.getBoundingClientRect();
        plot.setPointerCapture(event.pointerId);
        stop();
        dragPoint(
            fromCanvas([(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height])
        );
    };
    plot.addEventListener("pointerdown", drag);
    plot.addEventListener("pointermove", drag);
    plot.addEventListener("keydown", event => {
        const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[
            event.key
        ];
        if (!step) return;
        event.preventDefault();
        event.stopPropagation();
        stop();
        const from = state.point ?? fromCanvas([0.5, 0.5]);
        dragPoint([from[0] + (step[0] * domainSize) / 50, from[1] + (step[1] * domainSize) / 50]);
    });
}

function listenToKeys() {
    const step = direction => {
        stop();
        setTime(state.time + (direction * (moments.at(-1).time - moments[0].time)) / 100);
    };
    const toggle = id => {
        element(id).checked = !element(id).checked;
        redraw();
    };
    const commands = {
        e: () => toggle("refinement"),
        w: () => toggle("wireframe"),
        r: () => toggle("roots"),
        f: frame,
        "+": () => zoom(1.1),
        "-": () => zoom(1 / 1.1)
    };
    if (moments)
        Object.assign(commands, {
            " ": () => element("play").click(),
            ArrowLeft: () => step(-1),
            ArrowRight: () => step(1),
            Home: () => {
                stop();
                setTime(moments[0].time);
            },
            End: () => {
                stop();
                setTime(moments.at(-1).time);
            }
        });
    addEventListener("keydown", event => {
        const command = commands[event.key.length === 1 ? event.key.toLowerCase() : event.key];
        if (
            !command ||
            event.ctrlKey ||
            event.metaKey ||
            event.altKey ||
            /^(INPUT|SELECT|BUTTON|SUMMARY)$/.test(event.target.tagName)
        )
            return;
        event.preventDefault();
        command();
    });
}
