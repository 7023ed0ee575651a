// Tests of the landmark window: the keyboard does what the mouse does in the pictures.
#include "ui/dialogs/landmark_dialog.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <imgui.h>

#include "ui/headless_gui.h"

using namespace interleaf;

namespace {

/// Shows the window with two other meshes and a selected landmark on the first, and is the keyboard.
class LandmarkHand {
  public:
    LandmarkHand() {
        shown_.others = {"cow.obj", "dog.obj"};
        shown_.rows = {{.name = "nose", .state = "", .color = 0}};
        shown_.selected = 0;
        LandmarkMark nose;
        nose.place = {0.25F, 0.75F};
        nose.is_selected = true;
        shown_.sides[0].marks = {nose};
        dialog_.open();
        for (int i = 0; i < 3; ++i) frame();
    }

    LandmarkDialogShown& shown() { return shown_; }

    LandmarkDialogResult frame() {
        gui_.begin_frame({0, 0}, false);
        LandmarkDialogResult result = dialog_.show({0, 24, 1280, 776}, shown_);
        gui_.end_frame();
        return result;
    }

    /// What the frame gives in which \p key is first down.
    /// \param modifier  a GLFW key that is held, or 0
    LandmarkDialogResult press(int key, int modifier = 0) {
        ImGuiIO& io = ImGui::GetIO();
        io.KeyShift = modifier == GLFW_KEY_LEFT_SHIFT;
        io.KeyCtrl = modifier == GLFW_KEY_LEFT_CONTROL;
        io.KeysDown[key] = true;
        LandmarkDialogResult result = frame();
        io.KeysDown[key] = false;
        io.KeyShift = io.KeyCtrl = false;
        frame();
        return result;
    }

    const LandmarkDialog& dialog() const { return dialog_; }

  private:
    HeadlessGui gui_{{1280, 800}};
    LandmarkDialogShown shown_;
    LandmarkDialog dialog_;
};

}  // namespace

TEST_CASE("arrows turn the mesh of the keyboard with Shift, and choose a picture without") {
    LandmarkHand hand;
    const LandmarkDialogResult turned = hand.press(GLFW_KEY_RIGHT, GLFW_KEY_LEFT_SHIFT);
    CHECK(turned.sides[0].orbit.x == doctest::Approx(5.0 / 180));
    CHECK(turned.sides[0].orbit.y == 0);
    CHECK_FALSE(turned.side);
    CHECK(hand.press(GLFW_KEY_RIGHT).side == 1);
    const LandmarkDialogResult raised = hand.press(GLFW_KEY_UP, GLFW_KEY_LEFT_SHIFT);
    CHECK_FALSE(raised.sides[0].is_any());
    CHECK(raised.sides[1].orbit.y == doctest::Approx(-5.0 / 180));
    CHECK_FALSE(raised.selected);
}

TEST_CASE("arrows move the selected landmark with Ctrl by equal ways across and down") {
    LandmarkHand hand;
    const glm::vec2 size = hand.dialog().side_size();
    const LandmarkPictureInput across = hand.press(GLFW_KEY_LEFT, GLFW_KEY_LEFT_CONTROL).sides[0];
    CHECK(across.dragged == 0);
    CHECK(across.drag_begins);
    CHECK(across.pointer.y == 0.75F);
    const LandmarkPictureInput down = hand.press(GLFW_KEY_DOWN, GLFW_KEY_LEFT_CONTROL).sides[0];
    CHECK(down.pointer.x == 0.25F);
    CHECK(down.pointer.y > 0.75F);
    CHECK((0.25F - across.pointer.x) * size.x == doctest::Approx((down.pointer.y - 0.75F) * size.y));

    hand.shown().sides[0].marks[0].is_hidden = true;
    CHECK_FALSE(hand.press(GLFW_KEY_LEFT, GLFW_KEY_LEFT_CONTROL).sides[0].dragged);
}

TEST_CASE("Insert sets a point in the middle of the picture, Ctrl with plus and minus zooms about it") {
    LandmarkHand hand;
    const LandmarkPictureInput set = hand.press(GLFW_KEY_INSERT).sides[0];
    CHECK(set.is_clicked);
    CHECK(set.pointer == glm::vec2(0.5F));
    const LandmarkPictureInput nearer = hand.press(GLFW_KEY_EQUAL, GLFW_KEY_LEFT_CONTROL).sides[0];
    CHECK(nearer.zoom > 1);
    CHECK(nearer.pointer == glm::vec2(0.5F));
    CHECK(hand.press(GLFW_KEY_MINUS, GLFW_KEY_LEFT_CONTROL).sides[0].zoom < 1);
    CHECK(hand.dialog().blend() == 0.5F);
    hand.press(GLFW_KEY_EQUAL);
    CHECK(hand.dialog().blend() == doctest::Approx(0.6));
}

TEST_CASE("Page Up and Page Down go through the other meshes") {
    LandmarkHand hand;
    CHECK(hand.press(GLFW_KEY_PAGE_DOWN).other == 1);
    CHECK(hand.press(GLFW_KEY_PAGE_UP).other == 1);
    hand.shown().other = 1;
    CHECK(hand.press(GLFW_KEY_PAGE_DOWN).other == 0);
}

TEST_CASE("while a name is typed, no key acts on the pictures") {
    LandmarkHand hand;
    hand.press(GLFW_KEY_F2);
    CHECK_FALSE(hand.press(GLFW_KEY_RIGHT, GLFW_KEY_LEFT_SHIFT).is_any());
    CHECK_FALSE(hand.press(GLFW_KEY_INSERT).is_any());
    CHECK_FALSE(hand.press(GLFW_KEY_PAGE_DOWN).is_any());
}
