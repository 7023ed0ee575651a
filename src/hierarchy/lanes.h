// Vectors of three floats in one register of four, whose last lane means nothing: where the same sums are
// taken for many vertices, this is three times as fast as one float after the other.
#pragma once

#include <cstring>

#include <glm/vec3.hpp>

namespace interleaf {

/// x, y, z and one more. Arithmetic works lane by lane (a vector type of g++ and clang).
using Lanes = float __attribute__((vector_size(16)));

/// Reads 16 bytes, of which \p vector is the first 12: those behind it must be readable (as in a Buffer).
inline Lanes load(const glm::vec3& vector) {
    Lanes lanes;
    std::memcpy(&lanes, &vector, sizeof(lanes));
    return lanes;
}

/// Writes 16 bytes: what is stored behind \p vector must be written later.
inline void store(float* vector, Lanes lanes) {
    std::memcpy(vector, &lanes, sizeof(lanes));
}

inline Lanes yzx(Lanes v) {
    return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}

/// The cross product, its lanes turned by one: yzx() of it is in order. Sums may be taken before.
inline Lanes turned_cross(Lanes a, Lanes b) {
    return a * yzx(b) - yzx(a) * b;
}

}  // namespace interleaf
