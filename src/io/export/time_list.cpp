#include "io/export/time_list.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/file/input_file.h"
#include "io/text/json_place.h"
#include "io/text/words.h"

namespace interleaf {

std::vector<double> read_times(const std::filesystem::path& file) {
    constexpr std::uint64_t max_size = std::uint64_t{16} << 20U;
    const std::string text = read_text(file, max_size);
    std::vector<double> times;
    std::string_view rest = text;
    for (std::size_t number = 1; !rest.empty(); ++number) {
        std::string line(take_line(rest));
        line = line.substr(0, line.find('#'));
        for (char& c : line)
            if (c == ',') c = ' ';
        Words words(line);
        for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
            const std::optional<double> time = parse_double(word);
            if (!time)
                throw InputError(
                    fmt::format("{}: line {}: {}, expected a time", file.string(), number, in_quotes(word)));
            if (!times.empty() && !(*time > times.back()))
                throw InputError(fmt::format("{}: line {}: time {} after {}, expected a later one",
                                             file.string(), number, *time, times.back()));
            times.push_back(*time);
        }
    }
    if (times.empty()) throw InputError(fmt::format("{}: has no times", file.string()));
    return times;
}

}  // namespace interleaf
