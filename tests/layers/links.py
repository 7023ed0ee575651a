"""Checks whether a program needs a graphics or window library, by the libraries it loads.

usage: links.py (free-of-graphics | uses-graphics) PROGRAM
"""

import re
import subprocess
import sys

GRAPHICS = re.compile(r"lib(GL|OpenGL|GLX|GLdispatch|EGL|glfw|X11|xcb|wayland-client)\b[^ ]*")


def main():
    expected, program = sys.argv[1:]
    loaded = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    if "libc.so" not in loaded:
        sys.exit(f"ldd does not know {program}:\n{loaded}")
    graphics = sorted({match[0] for match in GRAPHICS.finditer(loaded)})
    print(f"{program}: {', '.join(graphics) or 'no graphics library'}")
    return 0 if bool(graphics) == (expected == "uses-graphics") else 1


if __name__ == "__main__":
    sys.exit(main())
