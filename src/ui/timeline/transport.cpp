#include "ui/timeline/transport.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <fmt/core.h>
#include <imgui.h>

#include "ui/widgets/command_keys.h"
#include "ui/widgets/glyphs.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

/// The place of a symbol on its button.
struct Symbol {
    ImDrawList& list;
    glm::vec2 middle;
    float size;  ///< half the height of the symbol
    ImU32 color;

    /// A triangle that points to the right, or for a negative \p direction to the left.
    void triangle(float offset, float direction, float scale = 1) const {
        const float x = middle.x + offset * size;
        const float half = size * scale;
        list.AddTriangleFilled({x - direction * half * 0.8F, middle.y - half},
                               {x - direction * half * 0.8F, middle.y + half},
                               {x + direction * half * 0.9F, middle.y}, color);
    }
    void bar(float offset, float width = 0.35F) const {
        const float x = middle.x + offset * size;
        list.AddRectFilled({x - width * size / 2, middle.y - size}, {x + width * size / 2, middle.y + size},
                           color);
    }
    /// A diamond, as keys are marked.
    void diamond(float offset) const {
        const float x = middle.x + offset * size;
        const float half = size * 0.75F;
        list.AddQuadFilled({x - half, middle.y}, {x, middle.y - half}, {x + half, middle.y},
                           {x, middle.y + half}, color);
    }
};

void draw_symbol(TransportButton button, bool is_on, const Symbol& symbol) {
    switch (button) {
        case TransportButton::first_key:
            symbol.bar(-1.1F);
            symbol.triangle(0.2F, -1);
            break;
        case TransportButton::last_key:
            symbol.bar(1.1F);
            symbol.triangle(-0.2F, 1);
            break;
        case TransportButton::previous_key:
            symbol.triangle(-0.6F, -1, 0.8F);
            symbol.diamond(0.7F);
            break;
        case TransportButton::next_key:
            symbol.triangle(0.6F, 1, 0.8F);
            symbol.diamond(-0.7F);
            break;
        case TransportButton::step_back:
            symbol.triangle(-0.4F, -1, 0.8F);
            symbol.bar(0.8F, 0.3F);
            break;
        case TransportButton::step_forward:
            symbol.triangle(0.4F, 1, 0.8F);
            symbol.bar(-0.8F, 0.3F);
            break;
        case TransportButton::play_backward:
        case TransportButton::play:
            if (is_on) {
                symbol.bar(-0.5F, 0.6F);
                symbol.bar(0.5F, 0.6F);
            } else {
                symbol.triangle(0, button == TransportButton::play ? 1.0F : -1.0F);
            }
            break;
        default:
            break;
    }
}

struct ButtonRow {
    TransportButton button;
    const char* name;
    const char* tooltip;
    const char* command;
};

constexpr std::array buttons{
    ButtonRow{TransportButton::first_key, "##first", "First key", "Go to start"},
    ButtonRow{TransportButton::previous_key, "##previous", "Previous key", "Go to previous key"},
    ButtonRow{TransportButton::step_back, "##back", "One frame back", "Step back"},
    ButtonRow{TransportButton::play_backward, "##backward", "Play backward", "Play backward"},
    ButtonRow{TransportButton::play, "##play", "Play", "Play"},
    ButtonRow{TransportButton::step_forward, "##forward", "One frame forward", "Step forward"},
    ButtonRow{TransportButton::next_key, "##next", "Next key", "Go to next key"},
    ButtonRow{TransportButton::last_key, "##last", "Last key", "Go to end"},
};

constexpr std::array speeds{1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0, 2.0, 4.0, 8.0};
constexpr std::array frame_rates{10.0, 24.0, 25.0, 30.0, 50.0, 60.0};

/// Tooltips above the row: beside the pointer they would cover the start of the track.
void tooltip_above(const std::string& text) {
    if (!ImGui::IsItemHovered()) return;
    const ImVec2 corner = ImGui::GetItemRectMin();
    ImGui::SetNextWindowPos({corner.x, corner.y - scaled(4)}, ImGuiCond_Always, {0, 1});
    ImGui::SetTooltip("%s", text.c_str());
}

bool is_minor(TransportButton button) {
    return button == TransportButton::step_back || button == TransportButton::step_forward;
}

void show_buttons(const TransportState& state, bool all, TransportResult& result) {
    const float side = ImGui::GetFrameHeight();
    for (const auto& [button, name, tooltip, command] : buttons) {
        if (!all && is_minor(button)) continue;
        const bool is_on = state.playing && ((button == TransportButton::play && !state.plays_back) ||
                                             (button == TransportButton::play_backward && state.plays_back));
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        if (ImGui::Button(name, {side * 1.25F, side})) result.pressed = button;
        tooltip_above(with_keys(is_on ? "Pause" : tooltip, {command}));
        draw_symbol(button, is_on,
                    {*ImGui::GetWindowDrawList(),
                     {corner.x + side * 0.625F, corner.y + side / 2},
                     side * 0.22F,
                     is_on ? colors::accent : colors::text});
        ImGui::SameLine(0, scaled(3));
    }
}

/// A combo box as wide as \p width. \p show(item) lists the items while it is open.
template <typename Items>
void combo(const char* name, const std::string& shown, const std::string& tooltip, float width,
           Items show_items) {
    need_glyphs(shown);
    ImGui::SetNextItemWidth(width);
    const bool is_open = ImGui::BeginCombo(name, shown.c_str(), ImGuiComboFlags_HeightLargest);
    if (!is_open) tooltip_above(tooltip);
    if (is_open) {
        show_items();
        ImGui::EndCombo();
    }
    ImGui::SameLine(0, scaled(6));
}

std::string title_of(Repeat repeat) {
    std::string title(name_of(repeat));
    title.front() = static_cast<char>(title.front() - 'a' + 'A');
    return title;
}

struct BasisTitle {
    Basis basis;
    const char* title;
    const char* description;
};

constexpr std::array<BasisTitle, basis_count> basis_titles{
    BasisTitle{Basis::linear, "Linear", "Straight from key to key"},
    BasisTitle{Basis::hold, "Hold", "Each key until the next one"},
    BasisTitle{Basis::bernstein, "Bernstein", "One polynomial; near the inner keys, not through them"},
    BasisTitle{Basis::catmull_rom, "Catmull-Rom", "Smooth through all keys, local"},
    BasisTitle{Basis::b_spline, "B-spline", "Smoothest; near the inner keys, not through them"},
    BasisTitle{Basis::spline, "Spline", "Smoothest through all keys; uses many keys at once"},
};

constexpr bool have_order_of_enumeration() {
    for (std::size_t i = 0; i < basis_count; ++i)
        if (basis_titles[i].basis != static_cast<Basis>(i) || basis_titles[i].title == nullptr) return false;
    return true;
}
static_assert(have_order_of_enumeration());

std::string title_of(const Interpolation& interpolation) {
    const char* const title = basis_titles.at(static_cast<std::size_t>(interpolation.basis)).title;
    return interpolation.degree > 0 ? fmt::format("{} {}", title, interpolation.degree) : title;
}

void choose_interpolation(const TransportState& state, TransportResult& result) {
    const bool turns = state.blend == BlendKind::turning;
    combo("##interpolation", title_of(state.interpolation) + (turns ? " ↻" : ""),
          with_keys(turns ? "How the keys are blended (↻ parts turn)" : "How the keys are blended",
                    {"Interpolation"}),
          scaled(turns ? 136 : 118), [&] {
              for (const auto& [basis, title, description] : basis_titles) {
                  const bool is_chosen =
                      basis == state.interpolation.basis && state.interpolation.degree == 0;
                  if (ImGui::Selectable(title, is_chosen))
                      result.interpolation = Interpolation{.basis = basis};
                  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", description);
              }
              if (ImGui::Selectable("Bernstein pieces...", state.interpolation.degree > 0))
                  result.pressed = TransportButton::ask_for_degree;
              if (ImGui::IsItemHovered())
                  ImGui::SetTooltip("Polynomials of a degree that you type, joined at keys");
              ImGui::Separator();
              if (ImGui::Selectable("Turn parts", turns))
                  result.blend = turns ? BlendKind::straight : BlendKind::turning;
              tooltip(with_keys("Parts that turn from key to key turn on the way, instead of shrinking",
                                {"Turn parts"}));
          });
}

void choose_source(const TransportState& state, TransportResult& result) {
    const auto title_of_source = [](TimeSource source) {
        return source == TimeSource::keys ? "Keys" : "Path";
    };
    combo("##source", title_of_source(state.source),
          with_keys("Follow the keys, or the path through the domain", {"Follow path"}), scaled(76), [&] {
              for (const TimeSource each : {TimeSource::keys, TimeSource::path})
                  if (ImGui::Selectable(title_of_source(each), each == state.source)) result.source = each;
          });
}

void choose_repeat(const TransportState& state, TransportResult& result) {
    combo("##repeat", title_of(state.repeat), with_keys("What happens at the end", {"Repeat"}), scaled(122),
          [&] {
              for (const Repeat each : repeats())
                  if (ImGui::Selectable(title_of(each).c_str(), each == state.repeat)) result.repeat = each;
          });
}

/// "1/16", "2": as playback speeds are read.
std::string speed_text(double speed) {
    const double inverse = std::round(1 / speed);
    if (speed < 1 && inverse * speed == 1) return fmt::format("1/{:.0f}", inverse);
    return fmt::format("{:.4g}", speed);
}

void choose_speed(const TransportState& state, TransportResult& result) {
    combo("##speed", speed_text(state.speed) + "x", "Speed ([ slower, ] faster, Backspace normal)",
          scaled(72), [&] {
              for (const double each : speeds)
                  if (ImGui::Selectable((speed_text(each) + "x").c_str(), each == state.speed))
                      result.speed = each;
              if (ImGui::Selectable("Type...")) result.pressed = TransportButton::ask_for_speed;
          });
}

void choose_frame_rate(const TransportState& state, TransportResult& result) {
    combo("##rate", fmt::format("{:g} fps", state.frame_rate), "Frame rate of single steps (Left, Right)",
          scaled(82), [&] {
              for (const double each : frame_rates)
                  if (ImGui::Selectable(fmt::format("{:g} fps", each).c_str(), each == state.frame_rate))
                      result.frame_rate = each;
              if (ImGui::Selectable("Type...")) result.pressed = TransportButton::ask_for_rate;
          });
}

/// The time at the right end of the row; a click asks for another time.
void show_time(const TransportState& state, float right, float row_end, TransportResult& result) {
    const std::string text = state.unit_name.empty()
                                 ? fmt::format("step {:.2f} / {:.6g}", state.time, state.end)
                                 : fmt::format("{:.3f} / {:.6g} {}", state.time, state.end, state.unit_name);
    const float width = text_size(text).x + 2 * ImGui::GetStyle().FramePadding.x;
    const ImVec2 cursor = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({std::max(right - width, row_end), cursor.y});
    ImGui::PushStyleColor(ImGuiCol_Button, 0);
    if (ImGui::Button((text + "###time").c_str())) result.pressed = TransportButton::ask_for_time;
    ImGui::PopStyleColor();
    tooltip_above(with_keys("Go to a time", {"Go to time"}));
}

}  // namespace

TransportResult show_transport(const TransportState& state, float width) {
    TransportResult result;
    const float left = ImGui::GetCursorScreenPos().x;
    show_buttons(state, width > scaled(560), result);
    ImGui::SameLine(0, scaled(14));
    if (width > scaled(420)) choose_speed(state, result);
    if (width > scaled(700)) choose_repeat(state, result);
    if (state.has_both_sources) choose_source(state, result);
    if (width > scaled(560) && state.source == TimeSource::keys) choose_interpolation(state, result);
    if (width > scaled(860)) choose_frame_rate(state, result);
    show_time(state, left + width, ImGui::GetCursorScreenPos().x, result);
    return result;
}

}  // namespace interleaf
