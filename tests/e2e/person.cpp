#include "e2e/person.h"

#include <algorithm>

namespace interleaf {

using State = RunningViewer::State;

namespace {

struct Part {
    float x, y, width, height;
};

Part part_of(const State& state, const char* name) {
    const State& r = state["rects"][name];
    return {r[0].get<float>(), r[1].get<float>(), r[2].get<float>(), r[3].get<float>()};
}

}  // namespace

std::filesystem::path builtin_file(const std::string& name) {
    return std::filesystem::path(INTERLEAF_BUILTIN_FAMILY) / name;
}

glm::vec2 view_middle(const State& state) {
    const Part view = part_of(state, "view");
    return {view.x + view.width / 2, view.y + view.height / 2};
}

glm::vec2 row_pixel(const State& state, std::size_t key) {
    const Part list = part_of(state, "keys");
    const float height = list.height / static_cast<float>(state["document"]["keys"].size());
    return {list.x + list.width / 2, list.y + height * (static_cast<float>(key) + 0.5F)};
}

glm::vec2 track_pixel(const State& state, double time) {
    const Part track = part_of(state, "timeline");
    const State& times = state["document"]["times"];
    const auto begin = times.front()[0].get<double>();
    const auto end = times.back()[0].get<double>();
    return {track.x + track.width * static_cast<float>((time - begin) / (end - begin)),
            track.y + track.height / 2};
}

glm::vec2 time_name_pixel(const State& state, double time) {
    const Part track = part_of(state, "timeline");
    return {track_pixel(state, time).x, track.y + track.height + 8};
}

glm::vec2 domain_pixel(const State& state, glm::vec2 point) {
    const Part box = part_of(state, "domain");
    glm::vec2 low(1e9F);
    glm::vec2 high(-1e9F);
    for (const State& vertex : state["document"]["domain"]) {
        const glm::vec2 at(vertex[0].get<float>(), vertex[1].get<float>());
        low = glm::vec2(std::min(low.x, at.x), std::min(low.y, at.y));
        high = glm::vec2(std::max(high.x, at.x), std::max(high.y, at.y));
    }
    return {box.x + box.width * (point.x - low.x) / (high.x - low.x),
            box.y + box.height * (high.y - point.y) / (high.y - low.y)};
}

State family_of(const State& state) {
    const State& document = state["document"];
    return {{"name", document["name"]},
            {"keys", document["keys"]},
            {"times", document["times"]},
            {"domain", document["domain"]}};
}

State wait_for_keys(const RunningViewer& viewer, std::size_t count) {
    return viewer.wait_for("so many keys: " + std::to_string(count),
                           [count](const State& s) { return s["document"]["keys"].size() == count; });
}

void wait_for_question(const RunningViewer& viewer) {
    viewer.wait_for("a question", [](const State& s) { return s["asking"] == true; });
}

void wait_for_no_question(const RunningViewer& viewer) {
    viewer.wait_for("no question", [](const State& s) { return s["asking"] == false; });
}

void choose_in_menu(const RunningViewer& viewer, std::size_t entry, std::size_t count) {
    const State state =
        viewer.wait_for("a menu", [](const State& s) { return !s["rects"]["popup"].is_null(); });
    const Part menu = part_of(state, "popup");
    constexpr float padding = 8;
    const float height = (menu.height - 2 * padding) / static_cast<float>(count);
    viewer.click({menu.x + menu.width / 2, menu.y + padding + height * (static_cast<float>(entry) + 0.5F)});
}

}  // namespace interleaf
