"""The check of the project's includes on made-up trees: it finds a missing include for each kind of name."""

import tempfile
import unittest
from pathlib import Path

from own_includes import violations

HEADER = """namespace interleaf {
struct Weight { int key; };
using Weights = Weight*;
enum class Easing { linear };
constexpr int key_limit = 64;
Weights sorted_weights(Weights weights);
}
"""


def violations_in(user, header=HEADER):
    with tempfile.TemporaryDirectory() as folder:
        for name, content in {"hierarchy/weight.h": header, "family/user.cpp": user}.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, encoding="utf-8")
        return violations(Path(folder))


class OwnIncludes(unittest.TestCase):
    def test_each_kind_of_name_takes_its_header(self):
        for use in ["Weight a;", "Weights a;", "auto a = Easing::linear;", "int a[key_limit];", "auto a = sorted_weights({});",
                    "auto a = interleaf::sorted_weights({});"]:
            with self.subTest(use=use):
                found = violations_in(use + "\n")
                self.assertEqual(len(found), 1, found)
                self.assertIn("hierarchy/weight.h", found[0])
                self.assertEqual(violations_in('#include "hierarchy/weight.h"\n' + use + "\n"), [])

    def test_names_that_the_file_declares_itself_and_members_do_not_count(self):
        for use in ["struct Weight { int a; };\nWeight b;", "struct Weight;\nWeight* a;", "int a = b.sorted_weights(1);",
                    "static int sorted_weights(int a) { return a; }\nint b = sorted_weights(1);", "// Weight\n",
                    "int a = other::Weight::b;"]:
            with self.subTest(use=use):
                self.assertEqual(violations_in(use + "\n"), [])

    def test_a_header_that_the_layer_may_not_include_is_not_asked_for(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, content in {"app/window/weight.h": HEADER, "family/user.cpp": "Weight a;\n"}.items():
                path = Path(folder, name)
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(content, encoding="utf-8")
            self.assertEqual(violations(Path(folder)), [])

    def test_a_source_includes_its_header(self):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "io").mkdir()
            Path(folder, "io", "a.h").write_text("int b();\n", encoding="utf-8")
            Path(folder, "io", "a.cpp").write_text("int b() { return 1; }\n", encoding="utf-8")
            self.assertEqual(len(violations(Path(folder))), 1)


if __name__ == "__main__":
    unittest.main()
