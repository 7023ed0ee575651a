#include "fit/clean_up/clean_up_report.h"

#include <algorithm>
#include <string_view>

#include <fmt/core.h>

namespace interleaf {

namespace {

std::string triangles_text(std::size_t count) {
    return count == 1 ? "1 triangle" : fmt::format("{} triangles", count);
}

/// For instance "0.03 %" or "14 %".
std::string percent(double part) {
    return fmt::format("{:.2g} %", 100 * part);
}

/// For instance "7.2 %, 3.1 % and 4 more", largest first.
template <typename Thing>
std::string areas_text(const std::vector<Thing>& things) {
    constexpr std::size_t most = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(things.size(), most); ++i)
        text += fmt::format("{}{} ({})", i == 0 ? "" : ", ", percent(things[i].area),
                            triangles_text(things[i].triangles));
    if (things.size() > most) text += fmt::format(" and {} more", things.size() - most);
    return text;
}

}  // namespace

std::size_t CleanUpReport::dropped_triangles() const {
    std::size_t sum = 0;
    for (const DroppedPart& part : dropped_parts) sum += part.triangles;
    return sum;
}

std::size_t CleanUpReport::filling_triangles() const {
    std::size_t sum = 0;
    for (const MadeFilling& filling : fillings) sum += filling.triangles;
    return sum;
}

std::vector<std::string> unwanted_changes(const CleanUpReport& report, bool keep_largest, bool fill_holes,
                                          const CleanUpLimits& limits) {
    std::vector<std::string> unwanted;
    if (!keep_largest && report.dropped_area > limits.dropped_area)
        unwanted.push_back(fmt::format(
            "the mesh has {} parts, and a key is made of one: without the smaller ones {} of the area would "
            "be lost, {}; "
            "--keep-largest keeps the largest part alone",
            report.dropped_parts.size() + 1, percent(report.dropped_area), areas_text(report.dropped_parts)));
    if (!fill_holes && report.made_area > limits.made_area)
        unwanted.push_back(fmt::format(
            "the surface has {}, and a key is closed: to fill {} would add {} to its area, {}; --fill-holes "
            "fills them",
            report.fillings.size() == 1 ? "1 hole" : fmt::format("{} holes", report.fillings.size()),
            report.fillings.size() == 1 ? "it" : "them", percent(report.made_area),
            areas_text(report.fillings)));
    return unwanted;
}

std::vector<std::string> CleanUpReport::sentences() const {
    std::vector<std::string> said;
    const auto say = [&](std::size_t count, std::string_view one, std::string_view several) {
        if (count == 1)
            said.push_back(fmt::format("1 {}.", one));
        else if (count > 1)
            said.push_back(fmt::format("{} {}.", count, several));
    };
    say(welded_vertices, "vertex was welded to an equal one", "vertices were welded to equal ones");
    say(nearly_equal_vertices, "vertex was welded to one that is equal but for rounding",
        "vertices were welded to ones that are equal but for rounding");
    say(degenerate_triangles, "triangle named a point twice and was removed",
        "triangles named a point twice and were removed");
    say(duplicate_triangles, "triangle had the same points as another and was removed",
        "triangles had the same points as others and were removed");
    say(crowded_edges, "edge had more than two triangles, which were parted",
        "edges had more than two triangles, which were parted");
    if (!dropped_parts.empty())
        said.push_back(fmt::format("{} smaller {} of {} {} dropped, {} of the area.", dropped_parts.size(),
                                   dropped_parts.size() == 1 ? "component" : "components",
                                   triangles_text(dropped_triangles()),
                                   dropped_parts.size() == 1 ? "was" : "were", percent(dropped_area)));
    say(turned_triangles, "triangle was turned to agree with its neighbors",
        "triangles were turned to agree with their neighbors");
    say(split_vertices, "vertex was added where the surface touches itself",
        "vertices were added where the surface touches itself");
    say(split_edges, "edge that joined the same vertices as another got a midpoint",
        "edges that joined the same vertices as others got midpoints");
    if (!fillings.empty())
        said.push_back(
            fmt::format("{} filled with {}, {} of the area around.",
                        fillings.size() == 1 ? "1 hole was" : fmt::format("{} holes were", fillings.size()),
                        triangles_text(filling_triangles()), percent(made_area)));
    if (turned_outward) said.emplace_back("The surface looked inward and was turned over.");
    return said;
}

}  // namespace interleaf
