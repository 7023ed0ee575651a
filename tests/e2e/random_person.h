// A user who acts at random: moves, clicks, drags and turns the wheel anywhere, presses any key, types, drops
// good and bad files, resizes the window, saves and quits.
#pragma once

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "e2e/running_viewer.h"
#include <glm/vec2.hpp>

namespace interleaf {

class RandomPerson {
  public:
    /// \param files  files and folders to drop
    RandomPerson(std::uint64_t seed, std::vector<std::filesystem::path> files);

    /// Acts once on the program, and returns a description of the act. The effect also depends on the speed
    /// of the program, so runs with the same seed are only similar.
    std::string act(const RunningViewer& viewer);

    /// Releases all buttons and keys that are held.
    static void let_go(const Desktop& desktop);

  private:
    struct Deed;
    static const std::vector<Deed>& deeds();

    std::size_t below(std::size_t count);
    bool happens(double chance);
    glm::vec2 anywhere(const RunningViewer::State& state);
    glm::vec2 inside(const RunningViewer::State& state, const char* part);

    std::string move(const RunningViewer& viewer);
    std::string click(const RunningViewer& viewer);
    std::string drag(const RunningViewer& viewer);
    std::string drag_key(const RunningViewer& viewer);
    std::string hold_button(const RunningViewer& viewer);
    std::string turn_wheel(const RunningViewer& viewer);
    std::string press_key(const RunningViewer& viewer);
    std::string press_with_modifiers(const RunningViewer& viewer);
    std::string answer(const RunningViewer& viewer);
    std::string type(const RunningViewer& viewer);
    std::string choose_in_menu(const RunningViewer& viewer);
    std::string go_through_steps(const RunningViewer& viewer);
    std::string save(const RunningViewer& viewer);
    std::string drop(const RunningViewer& viewer);
    std::string resize(const RunningViewer& viewer);

    std::mt19937_64 random_;
    std::vector<std::filesystem::path> files_;
};

}  // namespace interleaf
