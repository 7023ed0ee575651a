"""Reads the includes of all files of src/, and names each include that breaks the order of layers or rooms.

A folder of src/ is a layer, and a folder in a layer is a room. The tables below state which layers and rooms
each may include; includes go one way only. Only the layers that draw may include OpenGL, windows and Dear
ImGui. CLI11 and Boost are slow to compile, so only one place may include each.
"""

import re
import sys
from pathlib import Path

# The layers that each layer may include besides itself.
LAYERS = {
    "text": set(),
    "hierarchy": {"text"},
    "family": {"text", "hierarchy"},
    "shapes": {"text", "hierarchy"},
    "fit": {"text", "hierarchy"},
    "sequence": {"text", "hierarchy", "family"},
    "io": {"text", "hierarchy", "family"},
    "render": {"text", "hierarchy", "family"},
    "ui": {"text", "hierarchy", "family", "render"},
    "app": {"text", "hierarchy", "family", "shapes", "fit", "sequence", "io", "render", "ui"},
}
# The other rooms of its layer that each room may include; "" stands for the files beside the rooms. Layers
# that are not in this table have no rooms.
ROOMS = {
    "hierarchy": {"": set(), "matching": {""}, "detail": {""}, "nodes": {""}},
    "fit": {
        "mesh": set(),
        "clean_up": {"mesh"},
        "sphere_map": {"mesh"},
        "landmarks": {"mesh", "sphere_map"},
        "sampling": {"mesh", "sphere_map"},
        "correspondence": {"mesh", "sphere_map", "landmarks", "sampling"},
        "": {"mesh", "clean_up", "sphere_map", "landmarks", "sampling", "correspondence"},
    },
    "sequence": {"": set(), "series": set()},
    "io": {
        "text": set(),
        "file": {"text"},
        "film": {"file"},
        "hierarchy": {"text", "file"},
        "mesh": {"text", "file"},
        "landmarks": {"text", "file"},
        "family": {"text", "file", "hierarchy", "landmarks"},
        "export": {"text", "file", "hierarchy", "mesh"},
        "gltf": {"text", "file", "hierarchy", "mesh", "family", "export"},
        "page": {"text", "file", "hierarchy", "mesh", "family", "export"},
        "vtk": {"text", "file", "mesh"},
        "": {"text", "file", "film", "hierarchy", "mesh", "landmarks", "family", "export", "gltf", "page", "vtk"},
    },
    "ui": {
        "widgets": set(),
        "dialogs": {"widgets"},
        "browser": {"widgets", "dialogs"},
        "panels": {"widgets"},
        "timeline": {"widgets", "panels"},
        "": {"widgets"},
    },
    "app": {
        "work": set(),
        "importing": {"work"},
        "document": {"importing"},
        "landmarks": set(),
        "fitting": {"document", "landmarks", "work"},
        "storage": {"document", "fitting", "importing", "work"},
        "pictures": {"document"},
        "brushing": {"document"},
        "window": {"document", "landmarks", "fitting", "storage", "pictures", "brushing"},
        "cli": {"document", "fitting", "importing", "storage", "pictures", "window"},
        "": {"cli"},
    },
}
DRAWING_LAYERS = {"render", "ui", "app"}
DRAWING_HEADER = re.compile(r"(GL|GLES\d?|GLFW|EGL|KHR|X11|glad)/|imgui")
# Libraries that only one file, or one header and its source, may include.
IN_ONE_PLACE = {"CLI11": re.compile(r"CLI/"), "Boost": re.compile(r"boost/")}

SOURCE_FILE = {".h", ".hpp", ".cpp", ".c", ".inl"}
DIRECTIVE = re.compile(r"^\s*#\s*include\b\s*(.*)")
OPERAND = re.compile(r'([<"])([^">]+)[">]')


def includes(path):
    """Yields (line number, quoted or not, header) for each include; header is None if a macro makes it."""
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        directive = DIRECTIVE.match(line)
        if directive:
            operand = OPERAND.match(directive[1])
            yield (number, operand[1] == '"', operand[2]) if operand else (number, False, None)


def rooms_of(layer):
    return ROOMS.get(layer, {"": set()})


def room_of(parts):
    """The room of a file: the folder between its layer and its name, "" if there is none."""
    return "/".join(parts[1:-1])


def fault(layer, room, quoted, header):
    """The fault of this include in this room of this layer, or None."""
    if header is None:
        return "an include is spelled out, not made by a macro"
    folder = header.split("/")[0]
    if folder in LAYERS:
        if not quoted:
            return f"<{header}> is ours: include it in quotes"
        if folder != layer and folder not in LAYERS[layer]:
            return f'{layer} may not include "{header}"'
        other = room_of(header.split("/"))
        if folder == layer and other != room and other not in rooms_of(layer)[room]:
            return f'the room {layer}/{room} may not include "{header}"'
    elif quoted:
        return f'"{header}" does not begin with a layer; what is not ours goes in angle brackets'
    elif DRAWING_HEADER.match(header) and layer not in DRAWING_LAYERS:
        return f"{layer} may not include <{header}>: only {', '.join(sorted(DRAWING_LAYERS))} draw"
    return None


def violations(src):
    """All violations below the folder src, as lines of text."""
    found = []
    places = {library: set() for library in IN_ONE_PLACE}
    for path in sorted(path for path in src.rglob("*") if path.suffix in SOURCE_FILE):
        name = path.relative_to(src)
        layer = name.parts[0]
        if layer not in LAYERS:
            found.append(f"{name}: {layer} is not in the table of layers")
            continue
        room = room_of(name.parts)
        if room not in rooms_of(layer):
            found.append(f"{name}: {layer}/{room} is not in the table of rooms")
            continue
        for number, quoted, header in includes(path):
            wrong = fault(layer, room, quoted, header)
            if wrong:
                found.append(f"{name}:{number}: {wrong}")
            for library, pattern in IN_ONE_PLACE.items():
                if header and pattern.match(header):
                    places[library].add(str(name.with_suffix("")))
    for library, names in places.items():
        if len(names) > 1:
            found.append(f"{library} is included in more than one place: {', '.join(sorted(names))}")
    return found


def main():
    src = Path(sys.argv[1])
    checked = sum(path.suffix in SOURCE_FILE for path in src.rglob("*"))
    found = violations(src)
    print(*found, f"{checked} files of {src}, {len(found)} violations", sep="\n")
    return 1 if found or not checked else 0


if __name__ == "__main__":
    sys.exit(main())
