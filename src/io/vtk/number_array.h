// An array of a VTK file, as the numbers of one type, and what it is turned into. Numbers in words become
// numbers of the type as well, so that a file in words gives the same mesh as a binary file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hierarchy/triangle.h"
#include "io/text/words.h"
#include "io/vtk/data_type.h"

namespace interleaf {

/// What an array holds, and where it is: for messages, and for the number of its values.
struct ArrayPlace {
    std::string file;
    std::string name;               ///< "point field 'u'"
    std::string element = "value";  ///< what one tuple belongs to: "point"
    std::size_t tuples = 0;         ///< number of points, of cells, ...
    std::size_t components = 1;     ///< values per tuple

    /// \throw InputError if the number is beyond what any file can hold
    std::size_t values() const;

    /// Throws an InputError "FILE: NAME: WHAT".
    [[noreturn]] void fail(std::string_view what) const;

    /// Throws an InputError "FILE: NAME: ELEMENT N (counted from 0): WHAT" for a value, counted from 0.
    [[noreturn]] void fail_at(std::size_t value, std::string_view what) const;
};

struct NumberArray {
    DataType type = DataType::float64;
    std::vector<std::byte> bytes;  ///< of all numbers, in the byte order of this machine
};

/// Reverses the bytes of each number.
void swap_byte_order(NumberArray& array);

/// Reads the numbers of \p place as words. Words such as "nan" and "-inf" give NaN.
/// \throw InputError naming \p place, if a word is not a number of \p type, or if there are too few words
NumberArray read_words(Words& words, DataType type, const ArrayPlace& place);

/// The numbers, of which some may not be finite.
std::vector<double> doubles_of(const NumberArray& array);

/// \throw InputError naming \p place and the first number that is not finite
std::vector<double> finite_numbers(const NumberArray& array, const ArrayPlace& place);

/// \throw InputError naming \p place and the first number that is not whole, or not in [0, \p limit)
std::vector<Index> indices_below(const NumberArray& array, std::uint64_t limit, const ArrayPlace& place);

/// \throw InputError naming \p place and the first number that is not whole, or not in [0, 255]
std::vector<std::uint8_t> small_numbers(const NumberArray& array, const ArrayPlace& place);

}  // namespace interleaf
