#include "sequence/series/step_reader.h"

#include <algorithm>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace interleaf {

namespace {

/// Domains differ by at most this part of their size and area.
constexpr double same_domain = 0.01;

constexpr std::size_t max_notes = 4;

}  // namespace

bool Domain::is_about(const Domain& other) const {
    const double size = std::max(glm::distance(low, high), glm::distance(other.low, other.high));
    return glm::distance(low, other.low) <= same_domain * size &&
           glm::distance(high, other.high) <= same_domain * size &&
           std::max(area, other.area) - std::min(area, other.area) <= same_domain * area;
}

Domain domain_of(const std::vector<glm::dvec3>& points, std::span<const Triangle> triangles) {
    Domain domain;
    for (const auto& [a, b, c] : triangles) {
        domain.area += glm::length(area_vector(points[a], points[b], points[c])) / 2;
        for (const Index corner : {a, b, c}) {
            domain.low = glm::min(domain.low, points[corner]);
            domain.high = glm::max(domain.high, points[corner]);
        }
    }
    return domain;
}

InputError step_error(std::size_t step, const std::string& text) {
    return InputError(fmt::format("step {}: {}", step, text));
}

StepReader::StepReader(const Series& series, const SeriesOptions& options)
    : series_(series), is_noted_(series.step_count, false) {
    try {
        fields_ = fields_of(series.read(0), options.fields, options.displacement);
    } catch (const InputError& error) {
        throw step_error(0, error.what());
    }
    least_.assign(fields_.scalars.size(), std::numeric_limits<double>::max());
    most_.assign(fields_.scalars.size(), std::numeric_limits<double>::lowest());
}

StepMesh StepReader::read(std::size_t step) {
    try {
        std::vector<std::string> sentences;
        StepMesh mesh = clean_step(series_.read(step), fields_, sentences);
        note(step, sentences);
        for (std::size_t s = 0; s < mesh.values.size(); ++s) {
            const auto [low, high] = std::ranges::minmax(mesh.values[s]);
            least_[s] = std::min(least_[s], low);
            most_[s] = std::max(most_[s], high);
        }
        return mesh;
    } catch (const InputError& error) {
        throw step_error(step, error.what());
    }
}

void StepReader::note(std::size_t step, const std::vector<std::string>& sentences) {
    if (is_noted_[step]) return;
    is_noted_[step] = true;
    for (const std::string& sentence : sentences)
        if (++note_count_ <= max_notes) notes_.push_back(fmt::format("step {}: {}", step, sentence));
}

std::vector<double> StepReader::ranges() const {
    std::vector<double> ranges;
    ranges.reserve(least_.size());
    for (std::size_t s = 0; s < least_.size(); ++s) ranges.push_back(std::max(0.0, most_[s] - least_[s]));
    return ranges;
}

std::vector<std::string> StepReader::notes() const {
    std::vector<std::string> notes = notes_;
    if (note_count_ > max_notes)
        notes.push_back(fmt::format("and so on, {} times more", note_count_ - max_notes));
    return notes;
}

}  // namespace interleaf
