"""Drawing and encoding of a film, together and each alone, on two cores."""
import os
import resource
import shutil
import statistics
import subprocess
import tempfile
import time

FRAMES = 300
SIZE = "1280x720"
CORES = 2

# In the place of ffmpeg, so that drawing is measured alone: takes the frames, and keeps nothing.
NOTHING = "#!/bin/sh\nexec cat >/dev/null\n"
# Keeps the frames and the arguments, so that encoding is measured alone.
KEEPER = '#!/bin/sh\nprintf "%s\\n" "$@" >"$FILM_FOLDER/arguments"\nexec cat >"$FILM_FOLDER/frames"\n'


def put_program(folder, text):
    os.mkdir(folder)
    path = os.path.join(folder, "ffmpeg")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    os.chmod(path, 0o755)
    return folder


def timed(command, **options):
    """Wall and processor seconds of a process with its children."""
    before, started = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL, **options)
    wall, after = time.monotonic() - started, resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def measured(interleaf, rounds):
    """The medians of wall and processor seconds for "film", "drawing", "encoding", and of the ratio of the film to
    the sum of the other two. They take turns, so that other work on the machine meets all three alike."""
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, sorted(before)[:CORES])
    try:
        with tempfile.TemporaryDirectory() as folder:
            return measured_in(folder, interleaf, rounds)
    finally:
        os.sched_setaffinity(0, before)


def measured_in(folder, interleaf, rounds):
    film = os.path.join(folder, "film.mp4")
    render = [interleaf, "render", "-o", film, "--size", SIZE, "--frames", f"0:{FRAMES - 1}"]
    environment = os.environ | {"FILM_FOLDER": folder}

    def with_program(place):
        return environment | {"PATH": f"{place}:{environment['PATH']}"}

    keeper = put_program(os.path.join(folder, "keeper"), KEEPER)
    nothing = put_program(os.path.join(folder, "nothing"), NOTHING)
    subprocess.run(render, check=True, env=with_program(keeper))
    with open(os.path.join(folder, "arguments"), encoding="utf-8") as file:
        arguments = file.read().splitlines()
    encode = [shutil.which("ffmpeg"), *arguments[:-1], os.path.join(folder, "alone.mp4")]
    runs = {"film": [], "drawing": [], "encoding": []}
    for _ in range(rounds):
        runs["film"].append(timed(render))
        runs["drawing"].append(timed(render, env=with_program(nothing)))
        with open(os.path.join(folder, "frames"), "rb") as frames:
            runs["encoding"].append(timed(encode, stdin=frames))
    figures = {name: tuple(map(statistics.median, zip(*each))) for name, each in runs.items()}
    walls = zip(*([wall for wall, _ in each] for each in runs.values()))
    return figures, statistics.median(film / (drawing + encoding) for film, drawing, encoding in walls)
