#include "app/document/picture_command.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "app/document/family_extent.h"
#include "app/document/shown_field.h"
#include "family/family.h"
#include "family/family_fields.h"
#include "family/family_time.h"
#include "io/text/joined_text.h"
#include "text/shell_word.h"

namespace interleaf {
namespace {

std::string coloring_name(const Display& display) {
    if (display.coloring != Coloring::field) return std::string(name_of(display.coloring));
    // A field may be called like a coloring.
    return coloring_named(display.field) || display.field.starts_with("field:") ? "field:" + display.field
                                                                                : display.field;
}

/// \p end as it is shown, with the offset.
std::string end_of_range(const ColorScale& scale, float end) {
    return scale.offset == 0 ? fmt::format("{}", end) : fmt::format("{}", double{end} + scale.offset);
}

std::vector<std::string> color_options(const Display& display) {
    if (display.coloring == Coloring::plain) return {};
    std::vector<std::string> options{"--color=" + coloring_name(display)};
    if (const auto kept = display.kept_range())
        options.push_back(fmt::format("--range={},{}", kept->min, kept->max));
    if (display.coloring != Coloring::field) return options;
    if (display.scale.map != ColorMap::viridis)
        options.push_back(fmt::format("--color-map={}", name_of(display.scale.map)));
    if (display.range_locked)
        options.push_back(fmt::format("--range={},{}", end_of_range(display.scale, display.scale.range.min),
                                      end_of_range(display.scale, display.scale.range.max)));
    if (display.scale.is_logarithmic) options.emplace_back("--log-scale");
    return options;
}

/// \p name of a scalar as --arrows takes it: there, commas separate names.
std::string escaped(const std::string& name) {
    std::string text;
    for (const char c : name) {
        if (c == ',' || c == '\\') text += '\\';
        text += c;
    }
    return text;
}

std::vector<std::string> shown_edge_names(const Display& display) {
    std::vector<std::string> edges;
    if (display.wireframe) edges.emplace_back("wireframe");
    if (display.refinement_edges) edges.emplace_back("refinement-edges");
    if (display.root_edges) edges.emplace_back("root-edges");
    if (display.vertices) edges.emplace_back("vertices");
    if (display.normals) edges.emplace_back("normals");
    return edges;
}

/// What the time belongs to, if that can be either the keys or the path.
std::optional<std::string> along_option(const Session& session) {
    const Family& family = session.family();
    const bool has_choice = has_source(family, TimeSource::keys) && has_source(family, TimeSource::path);
    const std::optional<TimeSource> source = source_of_time(family);
    if (session.driver() != Driver::timeline || !has_choice || !source) return std::nullopt;
    return fmt::format("--along={}", name_of(*source));
}

}  // namespace

std::vector<std::string> display_options(const Display& display) {
    std::vector<std::string> options;
    if (const auto edges = shown_edge_names(display); !edges.empty())
        options.push_back("--show=" + joined(edges, ","));
    if (display.line_width != Display{}.line_width)
        options.push_back(fmt::format("--line-width={}", display.line_width));
    if (display.shading) options.push_back(fmt::format("--shading={}", name_of(*display.shading)));
    if (!display.occlusion) options.emplace_back("--no-occlusion");
    if (display.ground) options.emplace_back("--ground");
    if (display.material != Material::clay)
        options.push_back(fmt::format("--material={}", name_of(display.material)));
    if (display.light_background) options.emplace_back("--theme=light");
    std::ranges::move(color_options(display), std::back_inserter(options));
    if (display.legend) options.emplace_back("--legend");
    return options;
}

std::vector<std::string> field_options(const Session& session, const Display& display) {
    const Family& family = session.family();
    const std::vector<FamilyField> fields = fields_of(family);
    std::vector<std::string> options;
    if (display.height > 0)
        if (const auto warp = warp_of(display, fields, extent(family).box))
            options.push_back(fmt::format("--height={},{}", warp->field, display.height));
    if (const auto vector = shown_vector(display, fields)) {
        const auto& [x, y, z] = vector->parts;
        options.push_back(
            fmt::format("--arrows={},{}{}{}", escaped(x), escaped(y), z.empty() ? "" : ",", escaped(z)));
    }
    return options;
}

std::string blend_option(const Session& session) {
    if (session.driver() == Driver::timeline && session.has_time())
        return fmt::format("--time={}", session.time());
    if (session.driver() == Driver::point && session.point())
        return fmt::format("--at={},{}", session.point()->at.x, session.point()->at.y);
    std::vector<std::string> weights;
    weights.reserve(session.weights().size());
    for (const Weight& weight : session.weights())
        weights.push_back(fmt::format("{}={}", session.family().keys[weight.key].name, weight.value));
    return "--weights=" + joined(weights, ",");
}

std::string command_word(std::string_view text) {
    const auto is_plain = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-_./,:=+@%").find(c) != std::string_view::npos;
    };
    if (!text.empty() && std::ranges::all_of(text, is_plain)) return std::string(text);
    return quoted_shell_word(text);
}

std::string picture_command(std::span<const std::filesystem::path> files, const Session& session,
                            const Display& display, const Viewpoint& viewpoint, glm::ivec2 size) {
    std::vector<std::string> words{"interleaf", "render"};
    for (const std::filesystem::path& file : files) words.push_back(command_word(file.native()));
    words.push_back(command_word(blend_option(session)));
    if (const auto along = along_option(session)) words.push_back(*along);
    for (const std::string& option : display_options(display)) words.push_back(command_word(option));
    for (const std::string& option : field_options(session, display)) words.push_back(command_word(option));
    words.push_back(command_word("--camera=" + text_of(viewpoint)));
    words.push_back(fmt::format("--size={}x{}", size.x, size.y));
    words.emplace_back("-o");
    words.emplace_back("picture.png");
    return joined(words, " ");
}

}  // namespace interleaf
