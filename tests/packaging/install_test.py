#!/usr/bin/env python3
"""Installs a build into a temporary folder, and uses what is there: install_test.py CMAKE BUILD EXAMPLE COMPILER"""
import gzip
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

cmake, build, example, compiler = sys.argv[1:5]


def output_of(*command, **options):
    result = subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)
    if result.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, command))}: status {result.returncode}\n{result.stdout}{result.stderr}")
    return result.stdout


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = Path(cls.folder.name) / "a prefix"
        output_of(cmake, "--install", build, "--prefix", cls.prefix)
        cls.program = cls.prefix / "bin" / "interleaf"
        cls.share = cls.prefix / "share"
        help_text = output_of(cls.program, "help")
        cls.commands = re.findall(r"^  ([a-z]+) +\S", help_text.split("Subcommands:")[1].split("\n\n")[0],
                                  re.MULTILINE)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_the_program_finds_the_installed_family(self):
        self.assertGreater(len(self.commands), 10)
        shutil.rmtree(self.share / "interleaf" / "families" / "flow")
        figures = json.loads(output_of(self.program, "info", self.share / "interleaf/families/five-keys", "--json"))
        self.assertEqual(len(figures["keys"]), 5)

    def test_the_manual_page_has_all_commands_and_options(self):
        page = gzip.open(self.share / "man/man1/interleaf.1.gz", "rt").read()
        for command in self.commands:
            self.assertIn(f".SS {command}\n", page)
            help_text = output_of(self.program, "help", command)
            for option in re.findall(r"^  (?:-\w,)?(--[a-z-]+)", help_text, re.MULTILINE):
                if option != "--help":
                    self.assertIn(option.replace("-", "\\-"), page)
        if shutil.which("groff"):
            formatted = subprocess.run(["groff", "-man", "-Tutf8", "-ww"], input=page, capture_output=True, text=True)
            self.assertEqual((formatted.returncode, formatted.stderr), (0, ""))

    def test_bash_completes_commands_and_options(self):
        script = self.share / "bash-completion/completions/interleaf"

        def completions(*words):
            command = f"""source '{script}'; COMP_WORDS=({' '.join(words)}); COMP_CWORD={len(words) - 1}
                          _interleaf; echo "${{COMPREPLY[@]}}" """
            return output_of("bash", "-c", command).split()

        self.assertEqual(completions("interleaf", "rend"), ["render"])
        self.assertIn("--weights", completions("interleaf", "render", "--w"))
        self.assertNotIn("--tolerance", completions("interleaf", "render", "--t"))
        self.assertEqual(set(self.commands) - set(completions("interleaf", "''")), set())

    def test_other_shells_accept_their_scripts(self):
        for shell, script in (("zsh", "zsh/vendor-completions/_interleaf"),
                              ("fish", "fish/vendor_completions.d/interleaf.fish")):
            text = (self.share / script).read_text()
            for command in self.commands:
                self.assertIn(command, text)
            if shutil.which(shell):
                output_of(shell, "-n", self.share / script)

    def test_the_desktop_knows_the_program_and_its_files(self):
        entry = (self.share / "applications/interleaf.desktop").read_text()
        self.assertIn("\nExec=interleaf %F\n", entry)
        self.assertTrue((self.share / "icons/hicolor/scalable/apps/interleaf.svg").is_file())
        if shutil.which("desktop-file-validate"):
            output_of("desktop-file-validate", self.share / "applications/interleaf.desktop")
        if shutil.which("update-mime-database"):
            output_of("update-mime-database", self.share / "mime")
            globs = (self.share / "mime/globs2").read_text()
            self.assertIn("application/x-interleaf-hierarchy:*.ilh", globs)

    def test_the_thumbnailer_draws_a_key(self):
        entry = (self.share / "thumbnailers/interleaf.thumbnailer").read_text()
        command = re.search(r"^Exec=interleaf (.*)$", entry, re.MULTILINE)[1]
        picture = Path(self.folder.name) / "thumbnail"
        key = self.share / "interleaf/families/five-keys/star.ilh"
        words = [{"%i": str(key), "%o": str(picture)}.get(word, word.replace("%s", "128")) for word in command.split()]
        output_of(self.program, *words)
        self.assertEqual(picture.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")

    def test_another_project_uses_the_libraries(self):
        other = Path(self.folder.name) / "example"
        output_of(cmake, "-G", "Ninja", "-S", example, "-B", other, f"-DCMAKE_CXX_COMPILER={compiler}",
                  f"-DCMAKE_PREFIX_PATH={self.prefix}")
        output_of(cmake, "--build", other)
        key = Path(self.folder.name) / "between.ilh"
        output_of(other / "blend", self.share / "interleaf/families/five-keys", key)
        output_of(self.program, "check", key)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
