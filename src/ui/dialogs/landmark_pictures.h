// The pictures of the landmark window: meshes with numbered marks on them, which the mouse adds, moves and selects.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <imgui.h>

#include "ui/widgets/rect.h"

namespace interleaf {

/// A landmark in a picture. Places are parts of the picture's width and height, y down.
struct LandmarkMark {
    glm::vec2 place{0};
    std::string text;  ///< its number
    ImU32 color = 0;
    std::size_t index = 0;  ///< of the landmark
    bool is_selected = false;
    bool glows = false;      ///< it has no partner
    bool is_hidden = false;  ///< the surface is in front of it
};

struct LandmarkPictureShown {
    std::string title;
    std::string remark;    ///< in the picture while there is none
    unsigned texture = 0;  ///< OpenGL name; 0 while there is none
    std::vector<LandmarkMark> marks;
    std::vector<glm::vec2> proposals;              ///< the visible ones
    std::optional<std::size_t> chosen_proposal{};  ///< the one that the keyboard would accept
    bool is_active = false;                        ///< the keyboard acts on this picture
};

/// What the user did in a picture. Movements are in units of the picture's height.
struct LandmarkPictureInput {
    glm::vec2 orbit{0};
    glm::vec2 pan{0};
    float zoom = 1;
    glm::vec2 pointer{0};                 ///< a part of the picture, y down
    bool is_clicked = false;              ///< on the surface or beside it
    std::optional<std::size_t> selected;  ///< the landmark whose mark was pressed
    std::optional<std::size_t> proposal;  ///< the proposal that was clicked
    std::optional<std::size_t> dragged;   ///< the landmark whose mark is being dragged to the pointer
    bool drag_begins = false;

    bool is_any() const {
        return orbit != glm::vec2(0) || pan != glm::vec2(0) || zoom != 1 || is_clicked || selected ||
               proposal || dragged;
    }
};

/// What the mouse holds in a picture, from one frame to the next.
struct LandmarkHold {
    glm::vec2 pressed_at{0};
    bool has_moved = false;
    bool is_left = false;
    std::optional<std::size_t> mark;  ///< index of the landmark
};

/// Shows a picture at the cursor, and reads the mouse over it. A left click adds or selects, a left drag moves a
/// mark or orbits, other drags pan, the wheel zooms.
/// \param name  unique in the window
LandmarkPictureInput landmark_picture(const char* name, glm::vec2 size, const LandmarkPictureShown& shown,
                                      LandmarkHold& hold);

}  // namespace interleaf
