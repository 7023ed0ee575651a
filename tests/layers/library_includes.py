"""Finds each name of a library in src/ for which its file includes no header that gives it.

The builds that are tested share precompiled headers, so that such a file compiles there and not in a release. A header
counts where the file itself includes it, or a header of ours that the file includes, however far down. What one library
header includes does not count. The table is complete: a name of std, glm or fmt that is not in it is a violation, too.
"""

import re
import sys
from functools import cache
from pathlib import Path

from include_rules import SOURCE_FILE, includes

# The names of namespace std, unless they begin otherwise, that each header gives.
GIVES = {
    "algorithm": """all_of any_of clamp copy copy_n count count_if equal fill_n find find_if lower_bound max max_element min
        minmax none_of nth_element partition ranges rotate sort stable_sort swap_ranges unique upper_bound""",
    "array": "array",
    "atomic": "atomic",
    "bit": "bit_cast bit_width countl_one countr_zero endian",
    "cassert": "assert()",
    "cerrno": "errno EEXIST EINTR ELOOP EWOULDBLOCK",
    "charconv": "from_chars",
    "chrono": "chrono chrono_literals",
    "cmath": """abs acos asin atan atan2 ceil copysign cos erf exp floor fma fmod frexp hypot ilogb isfinite isnan ldexp
        lerp llround log10 lround nearbyint nextafter pow remainder round signbit sin sqrt tan""",
    "condition_variable": "condition_variable_any",
    "csignal": "SIGINT SIGTERM",
    "cstddef": "byte ptrdiff_t size_t to_integer",
    "cstdint": "int32_t int64_t uint8_t uint32_t uint64_t uintmax_t uintptr_t",
    "cstdio": "fflush fwrite ::rename()",
    "cstdlib": "abs free getenv malloc",
    "cstring": "memcpy strerror",
    "ctime": "::localtime_r() strftime time_t tm",
    "cwctype": "::towlower_l()",
    "exception": "current_exception exception exception_ptr rethrow_exception",
    "fcntl.h": "::open() O_CLOEXEC O_CREAT O_DIRECTORY O_EXCL O_NOFOLLOW O_NONBLOCK O_RDONLY O_WRONLY",
    "filesystem": "filesystem",
    "fmt/chrono.h": "fmt::localtime",
    "fmt/core.h": "fmt::format fmt::format_string fmt::format_to fmt::print fmt::runtime",
    "fstream": "ifstream ofstream",
    "functional": "function greater mem_fn",
    "future": "async future future_status launch",
    "glm/common.hpp": "glm::abs glm::clamp glm::floor glm::max glm::min glm::mix glm::round",
    "glm/geometric.hpp": "glm::cross glm::distance glm::dot glm::length glm::normalize",
    "glm/gtc/matrix_transform.hpp": "glm::perspective glm::rotate",
    "glm/gtc/type_ptr.hpp": "glm::value_ptr",
    "glm/mat3x3.hpp": "glm::dmat3 glm::mat3",
    "glm/mat4x4.hpp": "glm::dmat4 glm::mat4",
    "glm/matrix.hpp": "glm::inverse glm::transpose",
    "glm/trigonometric.hpp": "glm::degrees glm::radians",
    "glm/vec2.hpp": "glm::dvec2 glm::ivec2 glm::length_t glm::vec2",
    "glm/vec3.hpp": "glm::dvec3 glm::ivec3 glm::length_t glm::vec3",
    "glm/vec4.hpp": "glm::vec4",
    "glm/vector_relational.hpp": "glm::all glm::any glm::greaterThan glm::greaterThanEqual glm::lessThan",
    "initializer_list": "initializer_list",
    "ios": "dec hex ios streamoff",
    "istream": "flush ws",
    "iterator": "back_inserter end istreambuf_iterator next prev",
    "limits": "numeric_limits",
    "locale.h": "::newlocale()",
    "map": "map",
    "memory": "make_shared make_unique shared_ptr unique_ptr",
    "mutex": "lock_guard mutex scoped_lock unique_lock",
    "new": "::new() bad_alloc bad_array_new_length",
    "numbers": "numbers",
    "numeric": "accumulate iota",
    "optional": "nullopt optional",
    "queue": "priority_queue",
    "ranges": "ranges views",
    "ratio": "milli",
    "set": "multiset set",
    "signal.h": "SIGINT SIGTERM",
    "span": "as_bytes as_writable_bytes span",
    "sstream": "istringstream ostringstream",
    "stdexcept": "runtime_error",
    "stop_token": "stop_token",
    "string": "getline string to_string u8string",
    "string_view": "string_view",
    "sys/file.h": "::flock()",
    "sys/mman.h": "::madvise() ::mmap() ::mremap() ::munmap()",
    "sys/stat.h": "::fchmod() ::fstat() ::lstat() ::mkdir() ::stat()",
    "system_error": "errc error_code generic_category",
    "thread": "jthread this_thread",
    "tuple": "tie",
    "type_traits": "integral_constant is_invocable_r_v is_trivially_copyable_v",
    "unistd.h": "::close() ::faccessat() ::fchown() ::fsync() ::geteuid() ::getpid() ::isatty() ::read() ::unlink() ::write()",
    "unordered_map": "unordered_map",
    "utility": "exchange forward get move pair swap",
    "variant": "get get_if variant",
    "vector": "erase erase_if vector",
}
# Headers that include others of the table, because it is said so or because their functions take what these give.
INCLUDES = {
    "array": "initializer_list", "chrono": "ratio", "filesystem": "system_error", "fmt/chrono.h": "fmt/core.h", "fmt/format.h": "fmt/core.h", "fstream": "ios istream string",
    "glm/glm.hpp": """glm/common.hpp glm/geometric.hpp glm/mat3x3.hpp glm/mat4x4.hpp glm/matrix.hpp glm/trigonometric.hpp
        glm/vec2.hpp glm/vec3.hpp glm/vec4.hpp glm/vector_relational.hpp""",
    "glm/gtc/matrix_transform.hpp": "glm/mat4x4.hpp glm/vec3.hpp glm/vec4.hpp", "iostream": "ios istream",
    "istream": "ios", "map": "initializer_list", "set": "initializer_list", "sstream": "ios istream string",
    "string": "initializer_list", "system_error": "cerrno", "thread": "stop_token", "tuple": "utility",
    "vector": "initializer_list",
}
# Every header of the standard library gives these, with each library there is.
EVERYWHERE = {"size_t", "ptrdiff_t", "move", "forward", "swap", "pair", "end", "begin"}

COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"', re.DOTALL)
NAME = re.compile(r"\b(?:std|glm|fmt)::\w+|(?<![\w>])::\w+(?=\s*\()|(?<![\w:.])(?:assert(?=\()|errno\b|E[A-Z]{4,}\b"
                  r"|SIG(?:INT|TERM)\b|O_[A-Z]+\b)")


def given_by():
    """For each name the headers that give it."""
    headers = {}
    for header, names in GIVES.items():
        for name in names.split():
            headers.setdefault(name, set()).add(header)
    return headers


def spelled(name):
    """A name as the table has it."""
    if name.startswith("std::"):
        return name.removeprefix("std::")
    return name + "()" if name.startswith("::") or name == "assert" else name


def violations(src):
    """Every name that no header gives, as lines of text."""
    headers_of = given_by()

    @cache
    def direct(path):
        return [(quoted, header) for _, quoted, header in includes(path) if header]

    @cache
    def all_headers(path):
        """The library headers of a file and of ours that it includes."""
        found, seen, waiting = set(), {path}, [path]
        while waiting:
            for quoted, header in direct(waiting.pop()):
                if not quoted:
                    found |= {header, *INCLUDES.get(header, "").split()}
                elif (ours := src / header) not in seen and ours.exists():
                    seen.add(ours)
                    waiting.append(ours)
        return found

    wrong = []
    for path in sorted(path for path in src.rglob("*") if path.suffix in SOURCE_FILE):
        text = COMMENT_OR_TEXT.sub(lambda match: "\n" * match[0].count("\n") + '""', path.read_text(encoding="utf-8"))
        told = set()
        for number, line in enumerate(text.splitlines(), start=1):
            for match in NAME.finditer(line) if not line.lstrip().startswith("#include") else ():
                name = spelled(match[0])
                if name in told or name in EVERYWHERE and any("." not in header for header in all_headers(path)):
                    continue
                headers = headers_of.get(name)
                if headers and headers & all_headers(path):
                    continue
                told.add(name)
                expected = " or ".join(f"<{header}>" for header in sorted(headers)) if headers else "a row of the table"
                wrong.append(f"{path.relative_to(src)}:{number}: {match[0]} takes {expected}")
    return wrong


def main():
    src = Path(sys.argv[1])
    found = violations(src)
    print(*found, f"{len(found)} names without their header", sep="\n")
    return 1 if found or not any(src.rglob("*.cpp")) else 0


if __name__ == "__main__":
    sys.exit(main())
