#include "app/window/trace.h"

#include <algorithm>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/document/shown_shading.h"
#include "app/document/viewpoint.h"
#include "hierarchy/error.h"

namespace interleaf {

namespace {

using Json = nlohmann::ordered_json;

/// Drivers that number buffers in their messages can make any number of different ones.
constexpr std::size_t max_messages = 20;

Json json_of(const Rect& rect) {
    return {rect.x, rect.y, rect.width, rect.height};
}

Json json_of(const Weights& weights, const Family& family) {
    Json json = Json::object();
    for (const Weight& weight : weights) json[family.keys[weight.key].name] = weight.value;
    return json;
}

Json json_of(const Display& display, Shading shading) {
    return {{"shading", name_of(shading)},
            {"coloring", name_of(display.coloring)},
            {"field", display.field},
            {"color_map", name_of(display.scale.map)},
            {"range", {display.scale.range.min, display.scale.range.max}},
            {"occlusion", display.occlusion},
            {"ground", display.ground},
            {"material", name_of(display.material)},
            {"wireframe", display.wireframe},
            {"refinement_edges", display.refinement_edges},
            {"root_edges", display.root_edges},
            {"vertices", display.vertices},
            {"normals", display.normals},
            {"detail", display.detail},
            {"follows_camera", display.follows_camera}};
}

Json json_of(const Session& session) {
    Json json;
    json["time"] = session.time();
    json["playing"] = session.is_playing();
    json["repeat"] = name_of(session.playback().repeat());
    json["backward"] = session.plays_back();
    json["speed"] = session.playback().speed();
    json["range"] = {session.playback().range().begin, session.playback().range().end};
    json["driver"] = name_of(session.driver());
    json["point"] = session.point() ? Json{session.point()->at.x, session.point()->at.y} : Json();
    json["weights"] = json_of(session.weights(), session.family());
    json["active"] = Json::array();
    for (const Weight& weight : session.weights())
        json["active"].push_back(session.family().keys[weight.key].name);
    json["display"] = json_of(session.display, shown_shading(session));
    return json;
}

Json json_of(const Document& document) {
    const Family& family = document.family();
    Json json;
    json["name"] = family.name;
    json["folder"] = document.folder() ? Json(document.folder()->string()) : Json();
    json["changed"] = document.is_changed();
    json["undo"] = document.undo_step() != nullptr ? Json(*document.undo_step()) : Json();
    json["redo"] = document.redo_step() != nullptr ? Json(*document.redo_step()) : Json();
    json["keys"] = Json::array();
    for (const Key& key : family.keys) json["keys"].push_back(key.name);
    json["roots"] = family.keys.front().hierarchy->roots.triangle_count();
    json["times"] = Json::array();
    if (family.timeline)
        for (const TimelineKey& key : family.timeline->keys())
            json["times"].push_back({key.time, family.keys[key.key].name});
    json["interpolation"] = family.timeline ? Json(name_of(family.timeline->interpolation().basis)) : Json();
    json["path"] = family.path ? family.path->points().size() : 0;
    json["landmarks"] = Json::array();
    for (const LandmarkDirection& landmark : family.landmarks) json["landmarks"].push_back(landmark.name);
    json["domain"] = Json::array();
    if (family.domain)
        for (const DomainVertex& vertex : family.domain->vertices())
            json["domain"].push_back({vertex.at.x, vertex.at.y, family.keys[vertex.key].name});
    return json;
}

Json json_of(const FitDialog& offer) {
    const FitChoices& choices = offer.choices();
    Json json{{"row", offer.row()},
              {"mesh", offer.selected_mesh()},
              {"by_tolerance", choices.by_tolerance},
              {"leaves", choices.leaves},
              {"tolerance", choices.tolerance},
              {"roots", choices.roots},
              {"turns", Json::array()},
              {"ups", Json::array()},
              {"match_parts", choices.match_parts},
              {"same_size", choices.same_size},
              {"same_center", choices.same_center},
              {"keep_largest", choices.keep_largest},
              {"fill_holes", choices.fill_holes},
              {"fault", offer.fault()}};
    for (const std::size_t up : choices.ups) json["ups"].push_back(std::string(1, "XYZ"[up]));
    for (const FitChoices::Turn& turn : choices.turns)
        json["turns"].push_back({std::string(1, "xyz"[turn.axis]), turn.degrees});
    return json;
}

Json json_of(const LandmarkEditing& landmarks) {
    Json json{{"points", Json::array()}, {"made", landmarks.has_blend()}};
    for (const LandmarkPoint& point : landmarks.points()) {
        Json places = Json::array();
        for (const auto& place : point.places) places.push_back(place.has_value());
        json["points"].push_back({{"name", point.name}, {"places", places}});
    }
    json["selected"] = landmarks.selected() ? Json(*landmarks.selected()) : Json();
    return json;
}

}  // namespace

Trace::Trace(const std::filesystem::path& path) : path_(path), file_(path) {
    if (!file_) throw MachineError(fmt::format("{}: cannot be written", path_.string()));
}

void Trace::record(std::size_t frame, double seconds, const ViewerState& state, const SurfaceFigures& figures,
                   const FrameRecord& record) {
    const FrameLayout& layout = record.shown.layout;
    Json json = json_of(state.session);
    json["leaves"] = figures.leaves;
    json["vertices"] = figures.vertices;
    json["rebuilds"] = figures.rebuilds;
    json["late"] = figures.is_late;
    json["detail_follows"] = record.follows_camera;
    json["eye"] = {record.eye.x, record.eye.y, record.eye.z};
    json["view"] = text_of(viewpoint_of(record.camera));
    json["document"] = json_of(state.document);
    json["inspected"] =
        state.inspected ? Json{state.inspected->root, state.inspected->level, state.inspected->path} : Json();
    json["selected"] = state.selected_key ? Json(*state.selected_key) : Json();
    json["brush"] = state.brush.is_on;
    json["edits_domain"] = state.edits_domain;
    json["domain_has_focus"] = state.domain_has_focus;
    json["help"] = state.help_shown;
    json["shown_times"] = state.shown_times ? Json{state.shown_times->begin, state.shown_times->end} : Json();
    json["asking"] = record.is_asking;
    json["takes_text"] = record.takes_text;
    json["browsed"] = record.browsed ? Json(record.browsed->string()) : Json();
    json["picture_row"] = record.picture_row;
    json["comparing"] = state.is_comparing;
    json["compared"] = state.compared ? Json(state.compared->mesh_name) : Json();
    json["offer"] = record.offer != nullptr ? json_of(*record.offer) : Json();
    json["landmarks"] = record.landmarks != nullptr ? json_of(*record.landmarks) : Json();
    json["message"] = state.message.text;
    json["notice"] = !state.message.empty() && !state.message.is_fault();
    json["window"] = {layout.window.x, layout.window.y};
    json["pointer"] = {record.pointer.x, record.pointer.y};
    json["rests"] = record.rests;
    json["button_down"] = record.button_down;
    json["rects"] = {{"view", json_of(layout.view)},
                     {"keys", json_of(layout.keys)},
                     {"domain", layout.domain ? json_of(*layout.domain) : Json()},
                     {"timeline", layout.timeline ? json_of(*layout.timeline) : Json()},
                     {"popup", record.popup ? json_of(*record.popup) : Json()}};
    json["panels"] = {{"weights", json_of(record.shown.weights, *record.shown.family)},
                      {"legend", record.shown.legend_keys}};
    for (const std::string& message : record.opengl_messages)
        if (opengl_messages_.size() < max_messages &&
            std::ranges::find(opengl_messages_, message) == opengl_messages_.end())
            opengl_messages_.push_back(message);
    json["opengl_messages"] = opengl_messages_;
    std::string members = json.dump(-1, ' ', false, Json::error_handler_t::replace).substr(1);
    if (members == last_) return;
    last_ = std::move(members);
    file_ << fmt::format("{{\"frame\":{},\"seconds\":{:.4f},{}\n", frame, seconds, last_) << std::flush;
    if (!file_) throw MachineError(fmt::format("{}: cannot be written", path_.string()));
}

}  // namespace interleaf
