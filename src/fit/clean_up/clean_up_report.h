// Reports what the clean-up did to a mesh, and which of these changes need the user's consent.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace interleaf {

/// A component that was not kept.
struct DroppedPart {
    std::size_t triangles = 0;
    double area = 0;  ///< as a fraction of the area of all components
};

/// A hole that was filled.
struct MadeFilling {
    std::size_t edges = 0;  ///< of the hole's rim
    std::size_t triangles = 0;
    double area = 0;  ///< of the triangles, as a fraction of the area of the surrounding surface
};

/// Counts of what was done.
struct CleanUpReport {
    std::size_t welded_vertices = 0;         ///< used vertices that were merged into an equal one
    std::size_t nearly_equal_vertices = 0;   ///< along seams, merged into one close by (near_welding.h)
    std::size_t degenerate_triangles = 0;    ///< triangles that used a point twice
    std::size_t duplicate_triangles = 0;     ///< triangles with the same three points as another
    std::size_t crowded_edges = 0;           ///< edges at which more than two triangles met
    std::vector<DroppedPart> dropped_parts;  ///< largest first
    double dropped_area = 0;                 ///< as a fraction of the area of all parts
    std::size_t split_vertices = 0;          ///< added where the surface touches itself at a point
    std::size_t split_edges = 0;             ///< second edges between the same vertices, given a midpoint
    std::size_t turned_triangles = 0;        ///< triangles that disagreed with their neighbors
    std::vector<MadeFilling> fillings;       ///< of holes, largest first
    double made_area = 0;                    ///< of fillings, as a fraction of the area of what they close
    bool turned_outward = false;             ///< whether the whole surface looked inward before

    std::size_t dropped_triangles() const;
    std::size_t filling_triangles() const;

    /// One sentence per thing that was done; none for a clean mesh.
    std::vector<std::string> sentences() const;
};

/// How much clean_up() may change a surface without the user's consent.
struct CleanUpLimits {
    double dropped_area = 0.02;  ///< as a fraction of the whole area
    double made_area = 0.05;     ///< as a fraction of the kept area
};

/// The options that the user must set before the changes in \p report are acceptable: "--keep-largest" where
/// more area is dropped than \p limits allow, with the parts; "--fill-holes" where more area is added, with
/// the holes. One sentence per option that is needed and that \p keep_largest or \p fill_holes does not set.
std::vector<std::string> unwanted_changes(const CleanUpReport& report, bool keep_largest, bool fill_holes,
                                          const CleanUpLimits& limits = {});

}  // namespace interleaf
