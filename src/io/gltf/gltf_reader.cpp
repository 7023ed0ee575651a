#include "io/gltf/gltf_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "family/origin.h"
#include "hierarchy/color.h"
#include "hierarchy/error.h"
#include "io/family/composition.h"
#include "io/family/family_file.h"
#include "io/family/family_format.h"
#include "io/family/family_scales.h"
#include "io/file/input_file.h"
#include "io/gltf/gltf_constants.h"
#include "io/gltf/gltf_file.h"
#include "io/gltf/gltf_mesh.h"
#include "io/gltf/gltf_scene.h"
#include "io/gltf/scene_hierarchies.h"
#include "io/gltf/vertex_welding.h"
#include "io/gltf/weight_timeline.h"
#include "io/mesh/polygon_mesh.h"
#include "text/characters.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t max_gltf_size = std::uint64_t{1} << 30;

fs::path folder_of_buffers(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

GltfFile parse_named(std::string_view bytes, const fs::path& file) {
    return parse_gltf_file(bytes, file.string(), folder_of_buffers(file));
}

/// What export_glb() wrote into the extras of mesh \p mesh; none in files of other programs.
std::optional<JsonPlace> own_extras(const GltfFile& file, std::size_t mesh) {
    const auto extras = file.element("meshes", mesh).optional_member("extras");
    const auto own =
        extras && extras->is_object() ? extras->optional_member(gltf::extras_member) : std::nullopt;
    return own && own->is_object() && own->optional_member("base") ? own : std::nullopt;
}

/// The meshes that count: the first with targets or, without any, all.
std::vector<MeshInstance> chosen_instances(const GltfFile& file, std::vector<std::string>& remarks) {
    std::vector<MeshInstance> instances = mesh_instances(file);
    const auto has_targets = [&file](const MeshInstance& instance) {
        return target_count(file, instance.mesh) > 0;
    };
    const auto found = std::ranges::find_if(instances, has_targets);
    if (found == instances.end()) return instances;
    if (instances.size() > 1)
        remarks.push_back(
            fmt::format("Of {} meshes, only the first with morph targets was read.", instances.size()));
    return {*found};
}

void remark_on_ignored(const GltfFile& file, std::vector<std::string>& remarks) {
    for (const auto& [member, name] : {std::pair{"skins", "Skins"}, {"cameras", "Cameras"}})
        if (file.count(member) > 0) remarks.push_back(fmt::format("{} were passed over.", name));
}

/// The names of the base and of the targets of a mesh.
std::vector<std::string> key_names(const GltfFile& file, const MeshInstance& instance, std::size_t targets) {
    const JsonPlace mesh = file.element("meshes", instance.mesh);
    const auto own = own_extras(file, instance.mesh);
    const auto extras = mesh.optional_member("extras");
    const auto given = extras && extras->is_object() ? extras->optional_member("targetNames") : std::nullopt;
    std::vector<std::string> names;
    names.push_back(own ? own->member("base").string() : "base");
    for (std::size_t t = 0; t < targets; ++t)
        names.push_back(given && t < given->size() ? given->element(t).string()
                                                   : fmt::format("target {}", t + 1));
    return names;
}

/// The names of fields by attribute.
std::map<std::string, std::string> field_names(const std::optional<JsonPlace>& own) {
    std::map<std::string, std::string> names;
    const auto fields = own ? own->optional_member("fields") : std::nullopt;
    for (std::size_t i = 0; fields && i < fields->size(); ++i)
        names[fields->element(i).member("attribute").string()] = fields->element(i).member("name").string();
    return names;
}

/// The name of the field that an attribute becomes; empty if there is none.
std::string field_name(const GltfAttribute& attribute, const std::map<std::string, std::string>& given) {
    const auto found = given.find(attribute.name);
    std::string name = found != given.end()                 ? found->second
                       : attribute.name == gltf::color      ? "color"
                       : attribute.kind == FieldKind::color ? attribute.name
                                                            : attribute.name.substr(1);
    return is_field_name(name) ? name : std::string();
}

/// The values of key \p key, of which 0 is the base.
Buffer<float> values_of_key(const GltfAttribute& attribute, std::size_t key) {
    Buffer<float> values(attribute.values.begin(), attribute.values.end());
    if (key > 0)
        for (std::size_t n = 0; n < values.size(); ++n) values[n] += attribute.deltas[key - 1][n];
    if (attribute.kind == FieldKind::scalar) return values;
    for (std::size_t n = 0; n < values.size(); n += 3) {
        glm::vec3 light;
        for (glm::length_t c = 0; c < 3; ++c)
            light[c] = std::clamp(values[n + static_cast<std::size_t>(c)], 0.0F, 1.0F);
        const glm::vec3 color = encoded(light);
        for (glm::length_t c = 0; c < 3; ++c)
            values[n + static_cast<std::size_t>(c)] = std::clamp(color[c], 0.0F, 1.0F);
    }
    return values;
}

std::vector<Field> fields_of_key(const GltfMesh& mesh, const std::map<std::string, std::string>& names,
                                 std::size_t key) {
    std::vector<Field> fields;
    for (const GltfAttribute& attribute : mesh.attributes) {
        Field field{field_name(attribute, names), attribute.kind, {}};
        const bool is_taken = std::ranges::find(fields, field.name, &Field::name) != fields.end();
        if (field.name.empty() || is_taken) continue;
        field.values = values_of_key(attribute, key);
        if (std::ranges::all_of(field.values, [](float value) { return std::isfinite(value); }))
            fields.push_back(std::move(field));
    }
    return fields;
}

/// The roots of \p mesh, welded unless the file is \p own. A surface that welding makes no manifold stays as
/// it is.
std::variant<RootComplex, Misfit> roots_of_mesh(GltfMesh& mesh, bool is_own, const std::string& name,
                                                std::vector<std::string>& remarks) {
    std::string fault;
    GltfMesh welded = mesh;
    const std::size_t dropped = is_own ? 0 : weld_vertices(welded);
    for (GltfMesh* const each : {&welded, &mesh}) {
        drop_unused_vertices(*each);
        try {
            if (each->triangles.empty()) throw InputError("no triangle has three different corners");
            RootComplex roots(static_cast<Index>(each->positions.size()), each->triangles);
            if (each == &welded) {
                mesh = std::move(welded);
                if (dropped > 0)
                    remarks.push_back(fmt::format("{} triangles without area were dropped.", dropped));
            } else {
                remarks.emplace_back("Welded vertices would make no manifold, so none were welded.");
            }
            return roots;
        } catch (const InputError& error) {
            if (fault.empty()) fault = error.what();
        }
    }
    return Misfit{fmt::format("{}: mesh, after welding: {}; `interleaf fit` makes a key of it", name, fault)};
}

/// Positions relative to \p origin; none if they are beyond the range of floats.
std::optional<std::vector<glm::vec3>> local_positions(const GltfMesh& mesh, std::size_t key,
                                                      const glm::dvec3& origin) {
    std::vector<glm::vec3> positions;
    positions.reserve(mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const glm::dvec3 delta = key == 0 ? glm::dvec3(0) : glm::dvec3(mesh.deltas[key - 1][v]);
        const glm::dvec3 position = mesh.positions[v] + delta - origin;
        if (!is_place(position)) return std::nullopt;
        positions.emplace_back(position);
    }
    return positions;
}

Misfit too_far(const std::string& file, std::size_t key) {
    return {fmt::format("{}: a vertex of key {} is too far from the origin", file, key)};
}

/// The origin that positions of a file of export_glb() are relative to.
glm::dvec3 origin_of(const std::optional<JsonPlace>& own) {
    glm::dvec3 origin(0);
    const auto place = own ? own->optional_member("origin") : std::nullopt;
    if (!place) return origin;
    if (place->size() != 3) place->fail_expecting("three numbers");
    for (glm::length_t c = 0; c < 3; ++c) origin[c] = place->element(static_cast<std::size_t>(c)).number();
    return origin;
}

/// The meshes that a file shows, as one mesh.
struct ShownMesh {
    std::vector<MeshInstance> instances;  ///< at least one
    GltfMesh mesh;                        ///< without remarks
    std::optional<JsonPlace> own;         ///< what export_glb() has written beside it
};

/// \param remarks  receives sentences about everything that is left out or changed
ShownMesh read_shown_mesh(const GltfFile& file, std::vector<std::string>& remarks) {
    ShownMesh shown{.instances = chosen_instances(file, remarks), .mesh = {}, .own = {}};
    if (shown.instances.empty()) file.root().fail("shows no mesh");
    remark_on_ignored(file, remarks);
    shown.mesh = read_meshes(file, shown.instances);
    std::ranges::move(std::exchange(shown.mesh.remarks, {}), std::back_inserter(remarks));
    shown.own = own_extras(file, shown.instances.front().mesh);
    return shown;
}

/// The offsets and units of the fields of a file of export_glb().
std::vector<FieldScale> scales_of(const std::optional<JsonPlace>& own) {
    const auto scales = own ? own->optional_member("scales") : std::nullopt;
    return scales ? scales_at(*scales) : std::vector<FieldScale>();
}

/// The keys of a file of segments.
std::variant<FileKeys, Misfit> keys_of_scene(const JsonPlace& own, const std::string& name,
                                             const std::optional<glm::dvec3>& origin) {
    FileKeys read = read_scene_keys(own);
    read.scales = scales_of(own);
    const glm::dvec3 own_origin = origin_of(own);
    read.origin = origin.value_or(own_origin);
    for (std::size_t key = 0; key < read.keys.size(); ++key)
        for (glm::vec3& position : read.keys[key].positions) {
            const glm::dvec3 moved = glm::dvec3(position) + own_origin - *read.origin;
            if (!is_place(moved)) return too_far(name, key);
            position = glm::vec3(moved);
        }
    return read;
}

/// The keys of one file.
std::variant<FileKeys, Misfit> keys_of_file(const GltfFile& file, std::optional<glm::dvec3> origin) {
    if (const auto own = own_scene_extras(file)) return keys_of_scene(*own, file.name, origin);
    FileKeys read;
    auto [instances, mesh, own] = read_shown_mesh(file, read.remarks);
    read.scales = scales_of(own);
    const glm::dvec3 own_origin = origin_of(own);
    read.origin = origin ? *origin : own ? own_origin : origin_for(mesh.positions, mesh.triangles);
    auto roots = roots_of_mesh(mesh, own.has_value(), file.name, read.remarks);
    if (auto* misfit = std::get_if<Misfit>(&roots)) return std::move(*misfit);

    const auto names = field_names(own);
    const std::size_t key_count = mesh.deltas.size() + 1;
    for (std::size_t key = 0; key < key_count; ++key) {
        const auto positions = local_positions(mesh, key, *read.origin - own_origin);
        if (!positions) return too_far(file.name, key);
        read.keys.push_back(unrefined(std::get<RootComplex>(roots), *positions));
        read.keys.back().fields = fields_of_key(mesh, names, key);
    }
    if (key_count > 1)
        for (std::string& name : key_names(file, instances.front(), key_count - 1))
            read.sources.push_back({std::move(name), 0});
    for (std::string& remark : read.remarks) remark = fmt::format("{}: {}", file.name, remark);
    return read;
}

/// Puts keys into the order of the extras, and takes timeline, domain and origin from there.
void compose(const JsonPlace& own, Family& family) {
    const JsonPlace order = own.member("keys");
    std::vector<Key> keys;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const JsonPlace name = order.element(i).member("name");
        const auto key = find_key(family, name.string());
        if (!key || std::ranges::find(keys, name.string(), &Key::name) != keys.end())
            name.fail_expecting("the name of a target or of the base, each once");
        keys.push_back(family.keys[*key]);
    }
    if (keys.size() != family.keys.size())
        order.fail(fmt::format("has {} keys, expected {}", keys.size(), family.keys.size()));
    Family composed{.name = family.name, .keys = std::move(keys), .timeline = {}, .domain = {}};
    composed.origin = family.origin;
    if (const auto name = own.optional_member("name"); name && is_printable(name->string()))
        composed.name = name->string();
    read_composition(own, composed);
    family = std::move(composed);
}

/// Takes the timeline from the animation of another program, if there is one.
void take_animation(const GltfFile& file, std::size_t mesh, Family& family,
                    std::vector<std::string>* changes) {
    if (family.keys.size() < 2) return;
    std::vector<std::string> remarks;
    if (auto timeline = weight_timeline(file, mesh, family.keys.size() - 1, remarks))
        family.timeline = std::move(timeline);
    if (changes == nullptr) return;
    for (const std::string& remark : remarks) changes->push_back(fmt::format("{}: {}", file.name, remark));
}

}  // namespace

Family read_gltf_family(const fs::path& path, std::vector<std::string>* changes) {
    const GltfFile file = parse_named(read_text(path, max_gltf_size), path);
    auto read = keys_of_file(file, std::nullopt);
    if (const auto* misfit = std::get_if<Misfit>(&read)) throw InputError(misfit->reason);
    Family family = family_of_files(std::span(&path, 1), std::get<FileKeys>(std::move(read)), changes);
    auto own = own_scene_extras(file);
    if (!own) {
        std::vector<std::string> known;  // remarks that were made before
        const std::size_t mesh = chosen_instances(file, known).front().mesh;
        own = own_extras(file, mesh);
        if (!own) take_animation(file, mesh, family, changes);
    }
    if (!own || family.keys.size() < 2) return family;
    try {
        compose(*own, family);
    } catch (const InputError& error) {
        if (changes != nullptr)
            changes->push_back(fmt::format("{}; timeline and domain are new", error.what()));
    }
    return family;
}

std::variant<FileKeys, Misfit> read_gltf_keys(std::span<const fs::path> files,
                                              std::optional<glm::dvec3> origin) {
    FileKeys all;
    all.origin = origin;
    std::size_t number = 0;
    for (const fs::path& path : files) {
        auto read = keys_of_file(parse_named(read_text(path, max_gltf_size), path), all.origin);
        if (auto* misfit = std::get_if<Misfit>(&read)) return std::move(*misfit);
        append_keys(all, std::get<FileKeys>(std::move(read)),
                    {family_format::utf8_of(path.stem()), number++});
    }
    return all;
}

SurfaceFile parse_gltf(std::string_view bytes, std::string_view name) {
    const GltfFile file = parse_named(bytes, fs::path(name));
    SurfaceFile surface;
    auto [instances, mesh, own] = read_shown_mesh(file, surface.remarks);
    const glm::dvec3 origin = origin_of(own);
    for (const GltfAttribute& attribute : mesh.attributes) {
        if (attribute.name != gltf::color) continue;
        const Buffer<float> values = values_of_key(attribute, 0);
        for (std::size_t n = 0; n < values.size(); n += 3)
            surface.colors.emplace_back(values[n], values[n + 1], values[n + 2]);
    }
    for (const Field& field : fields_of_key(mesh, field_names(own), 0))
        if (field.kind == FieldKind::scalar)
            surface.scalars.push_back({field.name, 1, {field.values.begin(), field.values.end()}});
    surface.positions = std::move(mesh.positions);
    surface.triangles = std::move(mesh.triangles);
    for (glm::dvec3& position : surface.positions) {
        position += origin;
        if (!is_place(position)) file.root().fail("puts a vertex beyond the range of floats");
    }
    if (surface.triangles.empty()) file.root().fail("has no triangles");
    return surface;
}

}  // namespace interleaf
