"""Finds each library name in a file that includes no header for the name.

usage: library_includes.py SRC [FOLDER...]

The script reads the files of SRC, in which quoted includes begin, and of the other folders. The tested builds
share precompiled headers, so a file with a missing include compiles there, but not in a release.

A header counts if the file includes it, directly or through headers of the project. Headers that a library
header includes do not count. A name of std, glm or fmt that is not in the table is also a violation.
"""

import re
import sys
from functools import cache
from pathlib import Path

from include_rules import SOURCE_FILE, includes

# The names that each header gives. A name without a namespace is one of std.
GIVES = {
    "algorithm": """
        adjacent_find all_of any_of binary_search clamp copy copy_backward copy_if copy_n count count_if equal
        equal_range fill fill_n find find_end find_first_of find_if find_if_not for_each generate includes
        inplace_merge is_permutation is_sorted iter_swap lexicographical_compare lower_bound max max_element
        merge min min_element minmax minmax_element mismatch move_backward next_permutation none_of nth_element
        partial_sort partition partition_point pop_heap push_heap ranges remove remove_if replace replace_if reverse rotate sample
        search set_difference set_intersection set_union shuffle sort stable_partition stable_sort swap_ranges
        transform unique unique_copy upper_bound""",
    "array": "array to_array",
    "atomic": "atomic",
    "bit": """
        bit_cast bit_ceil bit_floor bit_width countl_one countl_zero countr_one countr_zero endian
        has_single_bit popcount rotl rotr""",
    "cassert": "assert()",
    "cctype": "isalnum isalpha isdigit isspace tolower toupper",
    "cerrno": "EEXIST EINTR EINVAL EISDIR ELOOP ENOENT EWOULDBLOCK errno",
    "charconv": "chars_format from_chars to_chars",
    "chrono": "chrono chrono_literals",
    "cmath": """
        abs acos asin atan atan2 cbrt ceil copysign cos cosh erf exp exp2 expm1 fabs floor fma fmax fmin fmod
        frexp hypot ilogb isfinite isinf isnan ldexp lerp llround log log10 log1p log2 logb lround modf
        nearbyint nextafter pow remainder rint round scalbn signbit sin sinh sqrt tan tanh trunc""",
    "compare": "compare_three_way is_eq is_lt partial_ordering strong_ordering weak_ordering",
    "concepts": """
        convertible_to derived_from floating_point integral invocable predicate regular_invocable same_as
        signed_integral unsigned_integral""",
    "condition_variable": "condition_variable condition_variable_any",
    "csignal": "SIGINT SIGKILL SIGTERM ::kill()",
    "cstddef": "byte max_align_t nullptr_t ptrdiff_t size_t to_integer",
    "cstdint": """
        int16_t int32_t int64_t int8_t intmax_t intptr_t uint16_t uint32_t uint64_t uint8_t uint_least32_t
        uintmax_t uintptr_t""",
    "cstdio": "::rename() FILE fclose fflush fopen fprintf fputs fread fwrite printf puts remove rename",
    "cstdlib": "abort abs exit free getenv malloc strtod strtol strtoul system",
    "cstring": "memcmp memcpy memmove memset strchr strcmp strerror strlen strncmp",
    "ctime": "::localtime_r() clock clock_t gmtime localtime strftime time time_t tm",
    "cwctype": "::towlower_l()",
    "deque": "deque",
    "exception": """
        current_exception exception exception_ptr make_exception_ptr rethrow_exception terminate
        uncaught_exceptions""",
    "fcntl.h": "::open() O_CLOEXEC O_CREAT O_DIRECTORY O_EXCL O_NOFOLLOW O_NONBLOCK O_RDONLY O_WRONLY",
    "filesystem": "filesystem",
    "fmt/chrono.h": "fmt::localtime",
    "fmt/core.h": """
        fmt::arg fmt::format fmt::format_string fmt::format_to fmt::make_format_args fmt::print fmt::runtime
        fmt::string_view fmt::vformat""",
    "fmt/format.h": "fmt::format_error fmt::formatter fmt::join fmt::memory_buffer fmt::to_string",
    "fstream": "ifstream ofstream",
    "functional": """
        bind_front cref equal_to function greater hash invoke less mem_fn minus multiplies not_fn plus ref
        reference_wrapper""",
    "future": "async future future_status launch packaged_task promise shared_future",
    "glm/common.hpp": """
        glm::abs glm::ceil glm::clamp glm::floor glm::fract glm::isinf glm::isnan glm::max glm::min glm::mix
        glm::mod glm::round glm::sign glm::smoothstep glm::step""",
    "glm/exponential.hpp": "glm::exp glm::inversesqrt glm::log glm::pow glm::sqrt",
    "glm/geometric.hpp": "glm::cross glm::distance glm::dot glm::faceforward glm::length glm::normalize glm::reflect",
    "glm/gtc/matrix_transform.hpp": "glm::lookAt glm::ortho glm::perspective glm::rotate glm::scale glm::translate",
    "glm/gtc/quaternion.hpp": "glm::angleAxis glm::conjugate glm::dquat glm::mat3_cast glm::quat glm::quat_cast glm::slerp",
    "glm/gtc/type_ptr.hpp": "glm::make_mat3 glm::value_ptr",
    "glm/mat2x2.hpp": "glm::dmat2 glm::mat2",
    "glm/mat3x3.hpp": "glm::dmat3 glm::mat3",
    "glm/mat4x4.hpp": "glm::dmat4 glm::mat4",
    "glm/matrix.hpp": "glm::determinant glm::inverse glm::outerProduct glm::transpose",
    "glm/trigonometric.hpp": "glm::acos glm::asin glm::atan glm::cos glm::degrees glm::radians glm::sin glm::tan",
    "glm/vec2.hpp": "glm::bvec2 glm::dvec2 glm::ivec2 glm::length_t glm::uvec2 glm::vec2",
    "glm/vec3.hpp": "glm::bvec3 glm::dvec3 glm::ivec3 glm::length_t glm::uvec3 glm::vec3",
    "glm/vec4.hpp": "glm::bvec4 glm::dvec4 glm::ivec4 glm::uvec4 glm::vec4",
    "glm/vector_relational.hpp": """
        glm::all glm::any glm::equal glm::greaterThan glm::greaterThanEqual glm::lessThan glm::lessThanEqual
        glm::notEqual glm::not_""",
    "initializer_list": "for{} initializer_list",
    "iomanip": "setfill setprecision setw",
    "ios": "dec fixed hex ios ios_base left right streamoff streamsize",
    "iostream": "cerr cin cout",
    "istream": "istream ws",
    "iterator": """
        advance back_insert_iterator back_inserter begin data distance empty end forward_iterator_tag inserter
        istream_iterator istreambuf_iterator iterator_traits make_move_iterator move_iterator next
        ostream_iterator prev rbegin rend reverse_iterator size ssize""",
    "limits": "numeric_limits",
    "list": "list",
    "locale.h": "::newlocale()",
    "map": "map multimap",
    "memory": """
        addressof align allocator construct_at default_delete destroy_at enable_shared_from_this make_shared
        make_unique shared_ptr uninitialized_copy unique_ptr weak_ptr""",
    "mutex": """
        adopt_lock call_once defer_lock lock_guard mutex once_flag recursive_mutex scoped_lock try_lock
        unique_lock""",
    "new": "::new() bad_alloc bad_array_new_length nothrow",
    "numbers": "numbers",
    "numeric": """
        accumulate adjacent_difference exclusive_scan gcd inclusive_scan inner_product iota lcm midpoint
        partial_sum reduce transform_reduce""",
    "optional": "make_optional nullopt optional",
    "ostream": "endl flush ostream",
    "queue": "priority_queue queue",
    "random": "mt19937 mt19937_64 normal_distribution random_device uniform_int_distribution uniform_real_distribution",
    "ranges": "ranges views",
    "ratio": "milli",
    "set": "multiset set",
    "shared_mutex": "shared_lock shared_mutex",
    "signal.h": "SIGINT SIGTERM SIG_IGN",
    "source_location": "source_location",
    "span": "as_bytes as_writable_bytes dynamic_extent span",
    "sstream": "istringstream ostringstream stringstream",
    "stack": "stack",
    "stdexcept": "domain_error invalid_argument length_error logic_error out_of_range overflow_error runtime_error",
    "stop_token": "stop_callback stop_source stop_token",
    "string": "basic_string char_traits getline stod stof stoi stol stoul stoull string to_string u8string wstring",
    "string_view": "basic_string_view string_view",
    "spawn.h": """
        ::posix_spawn_file_actions_adddup2() ::posix_spawn_file_actions_destroy()
        ::posix_spawn_file_actions_init() ::posix_spawnattr_destroy() ::posix_spawnattr_init()
        ::posix_spawnattr_setflags() ::posix_spawnattr_setpgroup() ::posix_spawnattr_setsigmask()
        ::posix_spawnp() POSIX_SPAWN_SETPGROUP POSIX_SPAWN_SETSIGMASK""",
    "sys/file.h": "::flock()",
    "sys/mman.h": "::madvise() ::memfd_create() ::mmap() ::mremap() ::munmap()",
    "sys/socket.h": "::send() ::socketpair()",
    "sys/stat.h": "::fchmod() ::fstat() ::lstat() ::mkdir() ::stat()",
    "sys/wait.h": "::waitid() ::waitpid()",
    "system_error": """
        errc error_category error_code error_condition generic_category make_error_code make_error_condition
        system_category system_error""",
    "thread": "jthread this_thread thread",
    "tuple": "apply forward_as_tuple ignore make_tuple tie tuple tuple_element_t tuple_size_v",
    "type_traits": """
        add_const_t common_type_t conditional_t decay_t enable_if_t false_type integral_constant invoke_result_t
        is_arithmetic_v is_base_of_v is_const_v is_constant_evaluated is_convertible_v is_enum_v
        is_floating_point_v is_integral_v is_invocable_r_v is_invocable_v is_nothrow_move_constructible_v
        is_same_v is_signed_v is_trivially_copyable_v is_unsigned_v make_signed_t make_unsigned_t remove_cv_t
        remove_cvref_t remove_reference_t true_type underlying_type_t void_t""",
    "unistd.h": """
        ::close() ::faccessat() ::fchown() ::fsync() ::geteuid() ::getpid() ::isatty() ::lseek() ::pread()
        ::read() ::unlink() ::write()""",
    "unordered_map": "erase_if unordered_map unordered_multimap",
    "unordered_set": "unordered_set",
    "utility": """
        as_const cmp_equal cmp_greater cmp_less cmp_less_equal declval exchange forward get in_place in_range
        index_sequence integer_sequence make_index_sequence make_pair move move_if_noexcept pair
        piecewise_construct swap to_underlying unreachable""",
    "variant": "get get_if holds_alternative in_place_index in_place_type monostate variant visit",
    "vector": "erase erase_if vector",
}
# Headers that are sure to include other headers of the table: their documentation says so, or their functions
# take types from these headers.
INCLUDES = {
    "algorithm": "initializer_list",
    "array": "initializer_list",
    "charconv": "system_error",
    "chrono": "ratio",
    "filesystem": "system_error",
    "fmt/chrono.h": "fmt/core.h",
    "fmt/format.h": "fmt/core.h",
    "fstream": "ios istream ostream string",
    "glm/glm.hpp": """
        glm/common.hpp glm/geometric.hpp glm/mat3x3.hpp glm/mat4x4.hpp glm/matrix.hpp glm/trigonometric.hpp
        glm/vec2.hpp glm/vec3.hpp glm/vec4.hpp glm/vector_relational.hpp""",
    "glm/gtc/matrix_transform.hpp": "glm/mat4x4.hpp glm/vec3.hpp glm/vec4.hpp",
    "iostream": "ios istream ostream",
    "istream": "ios",
    "map": "initializer_list",
    "set": "initializer_list",
    "sstream": "ios istream ostream string",
    "string": "initializer_list",
    "system_error": "cerrno",
    "thread": "stop_token",
    "tuple": "utility",
    "vector": "initializer_list",
}
# Names that every header gives, in all implementations of the standard library.
EVERYWHERE = {"size_t", "ptrdiff_t", "move", "forward", "swap", "pair", "end", "begin"}

COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"', re.DOTALL)
NAME = re.compile(r"\b(?:std|glm|fmt)::\w+|(?<![\w>])::\w+(?=\s*\()|(?<![\w:.])(?:assert(?=\()|errno\b|E[A-Z]{4,}\b"
                  r"|SIG(?:INT|TERM)\b|O_[A-Z]+\b|for \([^;]*? : (?=\{))")


def given_by():
    """For each name, the headers that give it."""
    headers = {}
    for header, names in GIVES.items():
        for name in names.split():
            headers.setdefault(name, set()).add(header)
    return headers


def spelled(name):
    """The spelling of a name in the table."""
    if name.startswith("std::"):
        return name.removeprefix("std::")
    if name.startswith("for "):
        return "for{}"  # a loop over values in braces
    return name + "()" if name.startswith("::") or name == "assert" else name


def violations(src, *folders):
    """All names in src and the other folders whose files include no header for them, as lines of text."""
    headers_of = given_by()

    @cache
    def direct(path):
        return [(quoted, header) for _, quoted, header in includes(path) if header]

    @cache
    def all_headers(path):
        """The library headers that a file includes, directly or through headers of the project."""
        found, seen, waiting = set(), {path}, [path]
        while waiting:
            file = waiting.pop()
            for quoted, header in direct(file):
                if not quoted:
                    found |= {header, *INCLUDES.get(header, "").split()}
                    continue
                for ours in {folder / header for folder in (file.parent, src, *folders)} - seen:
                    if ours.exists():
                        seen.add(ours)
                        waiting.append(ours)
        return found

    wrong = []
    paths = [path for folder in (src, *folders) for path in folder.rglob("*") if path.suffix in SOURCE_FILE]
    for path in sorted(paths):
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
                wrong.append(f"{path.relative_to(src.parent)}:{number}: {match[0]} takes {expected}")
    return wrong


def main():
    folders = [Path(word) for word in sys.argv[1:]]
    found = violations(*folders)
    print(*found, f"{len(found)} names without their header", sep="\n")
    return 1 if found or not all(any(folder.rglob("*.cpp")) for folder in folders) else 0


if __name__ == "__main__":
    sys.exit(main())
