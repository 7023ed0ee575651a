// Tests of the import dialog: the keyboard in it, and that a fault keeps it open.
#include "ui/dialogs/import_dialog.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <imgui.h>

#include "ui/headless_gui.h"

using namespace interleaf;

namespace {

/// Shows the dialog, and is the keyboard.
class ImportHand {
  public:
    explicit ImportHand(const char* fault = "") {
        shown_.fields = {"u"};
        shown_.fault = fault;
        ImGui::GetIO().KeyMap[ImGuiKey_Enter] = GLFW_KEY_ENTER;
        ImportDialogChoices choices;
        choices.tolerance = "2";
        choices.are_wanted = {true};
        dialog_.open(choices);
        for (int i = 0; i < 3; ++i) frame();
    }

    std::optional<bool> frame() {
        gui_.begin_frame({0, 0}, false);
        const auto answer = dialog_.show({0, 24, 1280, 776}, shown_);
        gui_.end_frame();
        return answer;
    }

    std::optional<bool> press(int key) {
        ImGui::GetIO().KeysDown[key] = true;
        const auto answer = frame();
        ImGui::GetIO().KeysDown[key] = false;
        const auto later = frame();
        return answer ? answer : later;
    }

    const ImportDialog& dialog() const { return dialog_; }

  private:
    HeadlessGui gui_{{1280, 800}};
    ImportDialogShown shown_;
    ImportDialog dialog_;
};

}  // namespace

TEST_CASE("Enter imports with the choices that the dialog was opened with") {
    ImportHand hand;
    CHECK(hand.dialog().is_open());
    CHECK(hand.press(GLFW_KEY_ENTER) == true);
    CHECK_FALSE(hand.dialog().is_open());
    CHECK(hand.dialog().choices().tolerance == "2");
    CHECK(hand.dialog().choices().every == "1");
}

TEST_CASE("with a fault Enter does nothing, but Esc still cancels") {
    ImportHand hand("Every: expected a whole number from 1 on");
    CHECK_FALSE(hand.press(GLFW_KEY_ENTER));
    CHECK(hand.dialog().is_open());
    CHECK(hand.press(GLFW_KEY_ESCAPE) == false);
    CHECK_FALSE(hand.dialog().is_open());
}
