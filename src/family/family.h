// A family: named keys over one root complex, with a timeline and a parameter domain (paper, sections 3.2 and
// 4).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "family/parameter_domain.h"
#include "family/shared_hierarchy.h"
#include "family/timeline.h"
#include "family/weights.h"
#include "hierarchy/union_mesh.h"

namespace interleaf {

struct Key {
    std::string name;  ///< unique in its family
    SharedHierarchy hierarchy;
};

struct Family {
    std::string name;
    std::vector<Key> keys;
    std::optional<Timeline> timeline;
    std::optional<ParameterDomain> domain;
    glm::dvec3 origin{0};  ///< that was subtracted from all positions (origin.h)
};

/// Index of the key called \p name; none when there is no such key.
std::optional<std::size_t> find_key(const Family& family, std::string_view name);

/// Every violation of what a family promises, one sentence each: at least one key; names that are printable
/// (text/characters.h), those of keys unique and not empty; the same root complex (constraints (B), naming
/// the keys); timeline and domain naming keys that exist.
std::vector<std::string> check(const Family& family);

/// The union of the active keys of \p weights, one position stream a weight, in their order.
UnionMesh unite(const Family& family, const Weights& weights);

/// The same into the buffers of \p mesh.
void unite(const Family& family, const Weights& weights, UnionMesh& mesh);

}  // namespace interleaf
