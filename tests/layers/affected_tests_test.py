"""The choice of ./dev check on made-up tests: tests of the changed layer, then quick affected tests."""

import unittest

from affected_tests import Test, choose

TESTS = [
    Test("hierarchy", 12, {"hierarchy"}, {"src/hierarchy/a.h", "src/hierarchy/a.cpp", "tests/hierarchy/a_test.cpp"}),
    Test("fit", 43, {"fit"}, {"src/hierarchy/a.h", "src/hierarchy/a.cpp", "src/fit/b.cpp"}),
    Test("io", 26, {"io"}, {"src/hierarchy/a.h", "src/io/c.cpp", "tests/io/samples.h"}),
    Test("app", 1, {"app"}, {"src/hierarchy/a.h", "src/io/c.cpp", "tests/io/samples.h"}),
    Test("cli", 65, {"cli"}, {"src/hierarchy/a.h", "src/app/cli/d.cpp"}),
    Test("layers.includes", 1, {"layers"}, None),
]


def names(changed, seconds=1000):
    return [test.name for test in choose(TESTS, changed, seconds, 1)[0]]


class AffectedTests(unittest.TestCase):
    def test_every_program_that_a_file_is_part_of_is_chosen_and_no_other(self):
        self.assertEqual(names(["src/fit/b.cpp"]), ["fit", "layers.includes"])
        self.assertEqual(names(["src/hierarchy/a.cpp"]), ["hierarchy", "layers.includes", "fit"])
        self.assertEqual(names(["tests/io/samples.h"]), ["io", "app", "layers.includes"])

    def test_the_quick_come_first_and_the_rest_is_left_out(self):
        chosen, left_out = choose(TESTS, ["src/hierarchy/a.h"], 40, 1)
        self.assertEqual([test.name for test in chosen], ["hierarchy", "app", "layers.includes", "io"])
        self.assertEqual([test.name for test in left_out], ["fit", "cli"])

    def test_the_tests_of_the_changed_layer_are_never_left_out(self):
        self.assertIn("fit", names(["src/fit/b.cpp"], seconds=0))
        self.assertIn("cli", names(["src/app/cli/d.cpp"], seconds=0))

    def test_data_reaches_the_tests_that_read_it(self):
        self.assertEqual(names(["tests/data/bad/a.obj"]), ["layers.includes", "cli"])
        self.assertEqual(names(["tests/io/CMakeLists.txt"]), ["io", "layers.includes"])
        self.assertEqual(names(["docs/fit.md"]), ["layers.includes"])

    def test_a_file_of_the_build_reaches_all(self):
        self.assertEqual(len(names(["cmake/targets.cmake"])), len(TESTS))


if __name__ == "__main__":
    unittest.main()
