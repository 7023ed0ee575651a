// Reads and cleans the steps of a series, and keeps what has to be known of all of them.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/error.h"
#include "sequence/series/series.h"
#include "sequence/series/step_mesh.h"

namespace interleaf {

/// The part of space that a surface covers.
struct Domain {
    glm::dvec3 low{std::numeric_limits<double>::max()};
    glm::dvec3 high{std::numeric_limits<double>::lowest()};
    double area = 0;

    /// Whether both are about the same, up to roundings of a curved boundary.
    bool is_about(const Domain& other) const;
};

Domain domain_of(const std::vector<glm::dvec3>& points, std::span<const Triangle> triangles);

/// An InputError about step \p step, or about a place in it: "step 3: ".
InputError step_error(std::size_t step, const std::string& text);

class StepReader {
  public:
    /// Reads the first step to know the fields.
    /// \param series, options  must outlive the reader
    StepReader(const Series& series, const SeriesOptions& options);

    /// \throw InputError  naming the step
    StepMesh read(std::size_t step);

    const SeriesFields& fields() const { return fields_; }

    /// Per scalar, the range over all steps that were read.
    std::vector<double> ranges() const;

    /// Sentences about what was decided, at most a few.
    std::vector<std::string> notes() const;

  private:
    void note(std::size_t step, const std::vector<std::string>& sentences);

    const Series& series_;
    SeriesFields fields_;
    std::vector<double> least_;  ///< per scalar
    std::vector<double> most_;
    std::vector<std::string> notes_;
    std::vector<bool> is_noted_;  ///< per step
    std::size_t note_count_ = 0;
};

}  // namespace interleaf
