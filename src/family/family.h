// A family: named keys over one root complex, with a timeline and a parameter domain (paper, sections 3.2 and
// 4).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "family/blend_kind.h"
#include "family/domain_path.h"
#include "family/field_scale.h"
#include "family/parameter_domain.h"
#include "family/shared_hierarchy.h"
#include "family/timeline.h"
#include "family/weights.h"
#include "hierarchy/landmark.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

struct Key {
    std::string name;  ///< unique in its family
    SharedHierarchy hierarchy;
};

/// What drives the blend over time.
enum class TimeSource : std::uint8_t {
    keys,  ///< the keys of the timeline
    path,  ///< the path through the parameter domain
};

struct Family {
    std::string name;
    std::vector<Key> keys;
    std::optional<Timeline> timeline;
    std::optional<ParameterDomain> domain;
    std::optional<DomainPath> path{};  ///< through the domain

    /// The choice between a timeline and a path; source_of_time() (family_time.h) also knows families that
    /// have only one of them.
    TimeSource time_source = TimeSource::keys;

    BlendKind blend = BlendKind::straight;

    /// Named points on the sphere of the roots, at which all keys have the same part of their bodies. Names are
    /// unique and not empty.
    std::vector<LandmarkDirection> landmarks{};

    glm::dvec3 origin{0};  ///< the point that was subtracted from all positions (origin.h)

    std::vector<FieldScale> field_scales{};  ///< offsets and units; at most one per field

    /// The unit of the timeline's times as people write it, "ms"; empty for seconds or steps (TimeUnit).
    std::string time_unit{};
};

/// Index of the key called \p name; none if there is no such key.
std::optional<std::size_t> find_key(const Family& family, std::string_view name);

/// Every violation of a family's invariants, one sentence per violation. There is at least one key. Names are
/// unique and not empty. All keys have the same root complex (constraints (B); the violation names the keys).
/// Landmarks have unique names and unit vectors. Scales have fields of their own, finite offsets and units. Timeline
/// and domain refer to existing keys. A path goes through a domain, and drives only where there is one.
std::vector<std::string> check(const Family& family);

/// The union of the active keys of \p weights, with one position stream per weight, in their order. It blends
/// straight, unless set_blend() lets it blend as the family does.
UnionMesh unite(const Family& family, const Weights& weights);

/// As above, but reuses the memory of \p mesh.
void unite(const Family& family, const Weights& weights, UnionMesh& mesh);

}  // namespace interleaf
