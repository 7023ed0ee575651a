#include "ui/headless_gui.h"

#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

HeadlessGui::HeadlessGui(glm::vec2 size) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.UserData = &state_;
    io.IniFilename = nullptr;
    io.DisplaySize = {size.x, size.y};
    apply_style(1, 1);
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
}

HeadlessGui::~HeadlessGui() {
    ImGui::DestroyContext();
}

void HeadlessGui::begin_frame(glm::vec2 pointer, bool is_button_down) {
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = 1.0F / 60;
    io.MousePos = {pointer.x, pointer.y};
    io.MouseDown[0] = is_button_down;
    ImGui::NewFrame();
}

void HeadlessGui::begin_drawing() {
    ImGui::EndFrame();
    ImGui::GetIO().DeltaTime = 1e-6F;
    ImGui::NewFrame();
}

void HeadlessGui::end_frame() {
    ImGui::Render();
}

bool HeadlessGui::has_color(unsigned color, const Rect& area) const {
    const ImDrawData& data = *ImGui::GetDrawData();
    for (int list = 0; list < data.CmdListsCount; ++list)
        for (const ImDrawVert& vertex : data.CmdLists[list]->VtxBuffer)
            if (vertex.col == color && vertex.pos.x >= area.x && vertex.pos.x < area.right() &&
                vertex.pos.y >= area.y && vertex.pos.y < area.bottom())
                return true;
    return false;
}

}  // namespace interleaf
