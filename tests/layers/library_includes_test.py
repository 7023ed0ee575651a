"""The check of library includes on made-up trees: it finds missing includes and unknown names."""

import tempfile
import unittest
from pathlib import Path

from library_includes import violations


def violations_in(files):
    """The violations in a tree made of {path: content}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, content in files.items():
            path = Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content, encoding="utf-8")
        return violations(Path(folder))


class LibraryIncludes(unittest.TestCase):
    def assert_only_violation(self, files, text):
        found = violations_in(files)
        self.assertEqual(len(found), 1, found)
        self.assertIn(text, found[0])

    def test_what_a_file_or_a_header_of_ours_includes_is_enough(self):
        found = violations_in({
            "hierarchy/a.h": "#include <vector>\n#include <glm/vec3.hpp>\nstd::vector<glm::vec3> a(std::size_t);\n",
            "hierarchy/b.h": '#include "hierarchy/a.h"\n',
            "io/b.cpp": '#include <cassert>\n#include "hierarchy/b.h"\nint b() { assert(std::vector<int>().empty()); }\n',
        })
        self.assertEqual(found, [])

    def test_a_missing_include_is_found(self):
        for name, header in [("std::optional<int> a;", "optional"), ("glm::vec3 a;", "glm/vec3.hpp"),
                             ("auto a = fmt::format(b);", "fmt/core.h"), ("int a = ::getpid();", "unistd.h"),
                             ("auto a = [] { assert(true); };", "cassert"), ("int a = errno;", "cerrno")]:
            with self.subTest(name=name):
                self.assert_only_violation({"io/a.cpp": f"#include <vector>\n{name}\n"}, f"takes <{header}>")

    def test_a_loop_over_values_in_braces_takes_an_include(self):
        loop = "int a() { for (const std::byte b : {c, d}) return int(b); }\n"
        self.assert_only_violation({"io/a.cpp": f"#include <cstddef>\n{loop}"}, "takes <initializer_list>")
        self.assertEqual(violations_in({"io/a.cpp": f"#include <cstddef>\n#include <array>\n{loop}"}), [])

    def test_an_include_in_a_file_that_is_not_included_does_not_count(self):
        self.assert_only_violation({"io/a.h": "#include <map>\n", "io/b.cpp": "std::map<int, int> b;\n"}, "takes <map>")

    def test_what_another_library_header_includes_does_not_count(self):
        self.assert_only_violation({"io/a.cpp": "#include <functional>\nstd::vector<int> a;\n"}, "takes <vector>")

    def test_a_name_that_is_not_in_the_table_is_found(self):
        self.assert_only_violation({"io/a.cpp": "#include <algorithm>\nstd::unheard_of a;\n"}, "a row of the table")

    def test_names_in_comments_and_texts_do_not_count(self):
        self.assertEqual(violations_in({"io/a.cpp": '// std::map\n/* std::set\n */ auto a = "std::vector";\n'}), [])


if __name__ == "__main__":
    unittest.main()
