#include "fuzz/mutation.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace interleaf::fuzz {

namespace {

std::size_t below(std::size_t limit, std::mt19937& random) {
    return limit == 0 ? 0 : random() % limit;
}

/// The length of a piece to change: mostly short, so that its surroundings remain unchanged.
std::size_t length(std::size_t most, std::mt19937& random) {
    return below((random() % 4 == 0 ? most : std::min<std::size_t>(most, 16)) + 1, random);
}

void cut(Bytes& bytes, std::mt19937& random) {
    const std::size_t begin = below(bytes.size() + 1, random);
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
    bytes.erase(first, first + static_cast<std::ptrdiff_t>(length(bytes.size() - begin, random)));
}

/// Repeats a piece of the file, or inserts random bytes.
void grow(Bytes& bytes, std::mt19937& random) {
    const std::size_t begin = below(bytes.size() + 1, random);
    Bytes piece(bytes.begin() + static_cast<std::ptrdiff_t>(begin), bytes.end());
    piece.resize(length(std::max<std::size_t>(piece.size(), 64), random));
    if (random() % 2 == 0) std::ranges::generate(piece, [&] { return static_cast<std::byte>(random()); });
    const auto place = static_cast<std::ptrdiff_t>(below(bytes.size() + 1, random));
    bytes.insert(bytes.begin() + place, piece.begin(), piece.end());
}

void flip(Bytes& bytes, std::mt19937& random) {
    if (!bytes.empty()) bytes[below(bytes.size(), random)] ^= static_cast<std::byte>(1U << random() % 8);
}

void swap_pieces(Bytes& bytes, std::mt19937& random) {
    const std::size_t size = length(bytes.size() / 2, random);
    const std::size_t first = below(bytes.size() - 2 * size + 1, random);
    const std::size_t second = first + size + below(bytes.size() - first - 2 * size + 1, random);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(first);
    std::swap_ranges(begin, begin + static_cast<std::ptrdiff_t>(size),
                     bytes.begin() + static_cast<std::ptrdiff_t>(second));
}

/// Sets four bytes at a multiple of four, where files have numbers, to a number that readers may not expect.
void set_number(Bytes& bytes, std::mt19937& random) {
    constexpr std::array<std::uint32_t, 9> numbers = {
        0,         1, 2, 0x7fffffff, 0x80000000, 0xfffffffe, 0xffffffff, 0x7fc00000 /* not a number */,
        0x7f800000 /* infinite */};
    if (bytes.size() < 4) return;
    std::byte* const place = bytes.data() + 4 * below(bytes.size() / 4, random);
    std::uint32_t number = 0;
    std::memcpy(&number, place, 4);
    number = random() % 2 == 0 ? numbers[random() % numbers.size()]
                               : number + static_cast<std::uint32_t>(random() % 5) - 2;
    std::memcpy(place, &number, 4);
}

void change(Bytes& bytes, std::mt19937& random) {
    constexpr std::array changes = {cut, grow, flip, flip, swap_pieces, set_number, set_number};
    for (auto times = 1 + random() % 3; times > 0; --times) changes[random() % changes.size()](bytes, random);
}

}  // namespace

Bytes mutated(ByteSpan file, std::mt19937& random) {
    std::vector<Bytes> parts = target.parts(file);
    if (parts.empty() || random() % 8 == 0) {
        Bytes whole(file.begin(), file.end());
        change(whole, random);
        return whole;
    }
    change(parts[random() % parts.size()], random);
    return target.file(std::move(parts), random() % 4 == 0);
}

}  // namespace interleaf::fuzz
