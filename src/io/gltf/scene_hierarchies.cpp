#include "io/gltf/scene_hierarchies.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "hierarchy/error.h"
#include "io/family/composition.h"
#include "io/gltf/gltf_constants.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/text/base64.h"

namespace interleaf {

namespace {

constexpr std::string_view hierarchy_member = "hierarchy";

/// The member \p name of \p place, if \p place is an object.
std::optional<JsonPlace> member_of(const std::optional<JsonPlace>& place, std::string_view name) {
    return place && place->is_object() ? place->optional_member(name) : std::nullopt;
}

}  // namespace

nlohmann::ordered_json scene_extras(const Family& family) {
    nlohmann::ordered_json own = nlohmann::ordered_json::parse(composition_text(family));
    for (std::size_t key = 0; key < family.keys.size(); ++key) {
        const auto bytes = serialize_hierarchy(*family.keys[key].hierarchy, {.compressed = true});
        own["keys"][key][hierarchy_member] =
            to_base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
    return own;
}

std::optional<JsonPlace> own_scene_extras(const GltfFile& file) {
    // A program that keeps extras, but has changed the meshes, leaves keys there that the meshes no longer show.
    const auto generator = member_of(file.root().optional_member("asset"), "generator");
    if (!generator || generator->string() != gltf::generator) return std::nullopt;
    const std::size_t scenes = file.count("scenes");
    if (scenes == 0) return std::nullopt;
    const auto shown = file.root().optional_member("scene");
    const JsonPlace scene = file.element("scenes", shown ? shown->index_below(scenes) : 0);
    auto own = member_of(member_of(scene, "extras"), gltf::extras_member);
    return member_of(own, "keys") ? own : std::nullopt;
}

FileKeys read_scene_keys(const JsonPlace& own) {
    FileKeys read;
    const JsonPlace keys = own.member("keys");
    if (keys.size() == 0) keys.fail_expecting("an array of at least one key");
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const JsonPlace place = keys.element(i).member(hierarchy_member);
        const auto bytes = from_base64(place.string());
        if (!bytes) place.fail_expecting("base64");
        try {
            read.keys.push_back(parse_hierarchy(std::as_bytes(std::span(*bytes)), "the key"));
        } catch (const InputError& error) {
            place.fail(error.what());
        }
        read.sources.push_back({keys.element(i).member("name").string(), 0});
    }
    return read;
}

}  // namespace interleaf
