"""Finds each name of the project in a file that includes no header that declares the name.

usage: own_includes.py SRC

The tested builds compile several files at once, so a file with a missing include may compile there, but not
in a release. A header counts if the file includes it, directly or through other headers of the project. The
names are the types, functions and constants that headers declare at the beginning of a line. A use of a
function is a call, unless the file declares the name itself.
"""

import re
import sys
from functools import cache
from pathlib import Path

from include_rules import SOURCE_FILE, fault, includes, room_of
from library_includes import COMMENT_OR_TEXT

TYPE = re.compile(r"^(?:class|struct|union|enum(?: class| struct)?)\s+(\w+)[^;{]*\{|^using\s+(\w+)\s*=", re.MULTILINE)
CONSTANT = re.compile(r"^(?:inline |static )*constexpr\s[^(;{=]*?\b(\w+)(?:\[\w*\])?\s*[={]|^extern\s[^;(]*?\b(\w+)(?:\[\w*\])?;", re.MULTILINE)
FUNCTION = re.compile(r"^(?!using|return|class|struct|enum|namespace|#|template\s*<.*>\s*$)[A-Za-z_][\w:<>,&*\[\] ]*?[\s&*](\w+)\(", re.MULTILINE)

# Members, parameters and variables that a file declares. They hide a name of the project.
LOCAL = re.compile(r"^[ \t]+(?!return|else|throw|new|delete|case)[A-Za-z_][\w:<>,&*\[\] ]*?[\s&*](\w+)\("
                   r"|\b(?:auto|class|struct|enum class|using)[&* ]+(\w+)\b|\b[A-Z]\w*[&*]? [&*]?(\w+)[,)]", re.MULTILINE)


def text_of(path):
    return COMMENT_OR_TEXT.sub('""', path.read_text(encoding="utf-8"))


def declared(text):
    """Names of types and constants, and names of functions."""
    names = {name for pattern in (TYPE, CONSTANT) for groups in pattern.findall(text) for name in groups if name}
    return names, {name for name in FUNCTION.findall(text)} - {"operator", "if", "for", "while", "switch"}


def used(text, functions):
    """The words of a text that may be names of the project, and the functions that it calls."""
    words = {word for word in re.findall(r"(?<![\w.>:])(?:interleaf::|testing::)?([A-Za-z_]\w*)", text)}
    calls = set(re.findall(r"(?<![\w.>:])(?:interleaf::|testing::)?([A-Za-z_]\w*)\(", text))
    return words, calls & functions


class Tree:
    def __init__(self, src):
        self.src = src
        self.text = {path: text_of(path) for path in src.rglob("*") if path.suffix in SOURCE_FILE}
        self.places, self.functions = {}, set()
        for path, text in self.text.items():
            if path.suffix == ".h":
                names, functions = declared(text)
                for name in names | functions:
                    self.places.setdefault(name, set()).add(path)
                self.functions |= functions - names
        # Constants of one word, such as `text`, have the same names as variables in many files.
        for name in [name for name in self.places if name not in self.functions and re.fullmatch("[a-z]+", name)]:
            del self.places[name]

    @cache
    def direct(self, path):
        return {self.src / header for _, quoted, header in includes(path) if quoted and header}

    def reach(self, path, without=None):
        found, waiting = {path}, [path]
        while waiting:
            file = waiting.pop()
            for other in self.direct(file) if file in self.text else ():
                if other not in found and not (file == path and other == without):
                    found.add(other)
                    waiting.append(other)
        return found

    def missing(self, path, without=None):
        """Pairs of a missing name and the headers that declare it, among those that the layers allow."""
        text = self.text[path]
        words, calls = used(text, self.functions)
        names_here, functions_here = declared(text)
        own_header = self.text.get(path.with_suffix(".h"), "")  # declares the members
        local = names_here | functions_here | {name for names in LOCAL.findall(own_header + text) for name in names}
        parts = path.relative_to(self.src).parts
        reach = self.reach(path, without)
        result = []
        header = path.with_suffix(".h")
        if path.suffix == ".cpp" and header in self.text and header not in reach:
            result.append(("what it defines", {header}))
        for name in sorted((words - self.functions) | calls):
            places = {place for place in self.places.get(name, ())
                      if not fault(parts[0], room_of(parts), True, str(place.relative_to(self.src)))}
            if not places or places & reach or name in local:
                continue
            if re.search(rf"^\s*(?:class|struct|enum class) {name};", text, re.MULTILINE):
                continue
            result.append((name, places))
        return result


def violations(src):
    tree = Tree(src)
    return [f"{path.relative_to(src)}: {name} is declared in {', '.join(sorted(str(p.relative_to(src)) for p in places))}"
            for path in sorted(tree.text) for name, places in tree.missing(path)]


def main():
    src = Path(sys.argv[1])
    found = violations(src)
    print(*found, f"{len(found)} names without their header", sep="\n")
    return 1 if found or not any(src.rglob("*.cpp")) else 0


if __name__ == "__main__":
    sys.exit(main())
