"""The include rules on made-up trees: a sound tree passes, and each rule fails on a tree that breaks it."""

import tempfile
import unittest
from pathlib import Path

from include_rules import LAYERS, ROOMS, rooms_of, violations


def violations_in(files):
    """The violations in a tree made of {path: content}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, content in files.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, encoding="utf-8")
        return violations(Path(folder))


def a_file(layer, room):
    return f"{layer}/{room}/a.cpp" if room else f"{layer}/a.cpp"


class IncludeRules(unittest.TestCase):
    def assert_only_violation(self, files, text):
        found = violations_in(files)
        self.assertEqual(len(found), 1, found)
        self.assertIn(text, found[0])

    def test_sound_tree_passes(self):
        found = violations_in({
            "hierarchy/triangle.h": "#pragma once\n#include <array>\n",
            "hierarchy/marking.cpp": '#include <boost/version.hpp>\n#include "hierarchy/triangle.h"\n',
            "family/family.cpp": '#include "hierarchy/triangle.h"\n// #include "app/main.h"\n',
            "render/renderer.cpp": '#include <glad/gl.h>\n#include "family/family.h"\n',
            "ui/panels/panel.cpp": '#include <imgui.h>\n#include "render/renderer.h"\n#include "ui/widgets/style.h"\n',
            "app/main.cpp": '#include "ui/panels/panel.h"\n#include <CLI/CLI.hpp>\n#include <GLFW/glfw3.h>\n',
        })
        self.assertEqual(found, [])

    def test_every_forbidden_pair_of_layers_is_found(self):
        for layer, allowed in LAYERS.items():
            for other in LAYERS.keys() - allowed - {layer}:
                with self.subTest(layer=layer, includes=other):
                    file = a_file(layer, sorted(rooms_of(layer))[0])
                    tree = {file: f'\n  #  include "{other}/b.h"\n'}
                    self.assert_only_violation(tree, f"{file}:2: ")

    def test_every_forbidden_pair_of_rooms_is_found_and_no_other(self):
        for layer, rooms in ROOMS.items():
            for room, allowed in rooms.items():
                for other in rooms:
                    with self.subTest(layer=layer, room=room, includes=other):
                        file = a_file(layer, room)
                        tree = {file: f'#include "{a_file(layer, other)}"\n'}
                        if other == room or other in allowed:
                            self.assertEqual(violations_in(tree), [])
                        else:
                            self.assert_only_violation(tree, f"{file}:1: the room {layer}/{room} may not")

    def test_tables_of_rooms_have_no_cycle(self):
        for layer, rooms in ROOMS.items():
            reached = set()
            while reached != rooms.keys():
                free = {room for room in rooms.keys() - reached if rooms[room] <= reached}
                self.assertTrue(free, f"a cycle among {rooms.keys() - reached} of {layer}")
                reached |= free

    def test_room_outside_the_table_is_found(self):
        for file in ["io/attic/a.h", "app/attic/a.h", "io/text/deep/a.h", "family/attic/a.h"]:
            with self.subTest(file=file):
                self.assert_only_violation({file: "#pragma once\n"}, "is not in the table of rooms")

    def test_table_has_no_cycle(self):
        reached = set()
        while reached != LAYERS.keys():
            free = {layer for layer in LAYERS.keys() - reached if LAYERS[layer] <= reached}
            self.assertTrue(free, f"a cycle among {LAYERS.keys() - reached}")
            reached |= free

    def test_layer_that_does_not_draw_may_not_include_graphics(self):
        headers = ["GL/gl.h", "GLFW/glfw3.h", "EGL/egl.h", "glad/gl.h", "imgui.h", "X11/Xlib.h"]
        for header in headers:
            for layer in ["hierarchy", "family", "shapes", "io/text"]:
                with self.subTest(layer=layer, header=header):
                    self.assert_only_violation({f"{layer}/a.h": f"#include <{header}>\n"}, header)

    def test_folder_outside_the_table_is_found(self):
        self.assert_only_violation({"utils/a.h": "#pragma once\n"}, "utils is not in the table")

    def test_one_library_in_two_files_is_found(self):
        tree = {"app/a.cpp": "#include <CLI/CLI.hpp>\n", "app/b.h": "#include <CLI/App.hpp>\n"}
        self.assert_only_violation(tree, "CLI11")

    def test_include_that_hides_its_layer_is_found(self):
        for directive in ['"../app/main.h"', '"main.h"', "<app/main.h>", "MAIN_HEADER"]:
            with self.subTest(directive=directive):
                self.assert_only_violation({"hierarchy/a.h": f"#include {directive}\n"}, "hierarchy/a.h:1: ")


if __name__ == "__main__":
    unittest.main()
