// What cleaning up did to a mesh, and what of it nobody would want unasked.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace interleaf {

/// A component that was not kept.
struct DroppedPart {
    std::size_t triangles = 0;
    double area = 0;  ///< as a part of the area of all components
};

/// A hole that was filled.
struct MadeFilling {
    std::size_t edges = 0;  ///< of its rim
    std::size_t triangles = 0;
    double area = 0;  ///< of the triangles, as a part of the area of the surface around
};

/// What was done, in counts.
struct CleanUpReport {
    std::size_t welded_vertices = 0;         ///< in use, that went into an equal one
    std::size_t nearly_equal_vertices = 0;   ///< along a seam, that went into one close by (near_welding.h)
    std::size_t degenerate_triangles = 0;    ///< that named a point twice
    std::size_t duplicate_triangles = 0;     ///< of the same three points as another
    std::size_t crowded_edges = 0;           ///< at which more than two triangles met
    std::vector<DroppedPart> dropped_parts;  ///< the largest first
    double dropped_area = 0;                 ///< of all parts' area, the part that was dropped
    std::size_t split_vertices = 0;          ///< added where the surface touches itself at a point
    std::size_t split_edges = 0;             ///< of two that joined the same vertices, given a midpoint
    std::size_t turned_triangles = 0;        ///< that disagreed with their neighbors
    std::vector<MadeFilling> fillings;       ///< of holes, the largest first
    double made_area = 0;                    ///< of fillings, as a part of the area of what they close
    bool turned_outward = false;             ///< the whole surface looked inward

    std::size_t dropped_triangles() const;
    std::size_t filling_triangles() const;

    /// A sentence for each thing that was done; none for a clean mesh.
    std::vector<std::string> sentences() const;
};

/// What clean_up() may change of a surface without being told to.
struct CleanUpLimits {
    double dropped_area = 0.02;  ///< of all
    double made_area = 0.05;     ///< of what is kept
};

/// What to be told to do before the surface is as good as \p report says: "--keep-largest" where more is
/// dropped than \p limits allow, with the parts; "--fill-holes" where more is made, with the holes. A
/// sentence for each that \p keep_largest and \p fill_holes do not allow.
std::vector<std::string> unwanted_changes(const CleanUpReport& report, bool keep_largest, bool fill_holes,
                                          const CleanUpLimits& limits = {});

}  // namespace interleaf
