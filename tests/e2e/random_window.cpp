// Gives random input to the program in its window, and checks that it keeps running, answers, saves families
// that are sound, and that OpenGL does not complain. Usage: random_window [RUNS] [EVENTS] [SEED]
//
// The program runs confined: wherever random input leads it, it can write only into its user's home, a
// temporary folder. The exit status is 77 if this machine cannot confine it.
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "e2e/confinement.h"
#include "e2e/person.h"
#include "e2e/random_person.h"
#include "scratch_folder.h"
#include <fmt/core.h>

namespace interleaf {
namespace {

namespace fs = std::filesystem;

/// Number of events between two checks that the program answers, and between two checks of the saved
/// families.
constexpr std::size_t answer_interval = 25;
constexpr std::size_t check_interval = 250;

struct Plan {
    std::size_t runs = 1;
    std::size_t events = 300;
    std::uint64_t seed = 1;
};

/// The files to drop: families, keys, meshes, and files that are none of these.
std::vector<fs::path> make_files(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(INTERLEAF_BUILTIN_FAMILY)) files.push_back(entry.path());
    files.emplace_back(INTERLEAF_BUILTIN_FAMILY);
    for (const auto& entry : fs::recursive_directory_iterator(INTERLEAF_BAD_FILES))
        if (entry.is_regular_file()) files.push_back(entry.path());
    files.resize(std::min<std::size_t>(files.size(), 24));

    const auto put = [&](const char* name, const std::string& text) {
        fs::create_directories((folder / name).parent_path());
        std::ofstream(folder / name) << text;
        files.push_back(folder / name);
    };
    const std::string vertices = "v 1 1 1 1 0 0\nv -1 -1 1 0 1 0\nv -1 1 -1 0 0 1\nv 1 -1 -1 1 1 1\n";
    put("tetrahedron.obj", vertices + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    put("flow.1.obj", vertices + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    put("flow.2.obj", vertices + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    put("meshes/a.off", "OFF\n4 4 0\n1 1 1\n-1 -1 1\n-1 1 -1\n1 -1 -1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
    put("sheet.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    put("note.txt", "no mesh");
    put("empty.ilh", "");
    put("a name \u2013 100% ##.obj", vertices + "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    files.push_back(folder / "meshes");
    files.push_back(folder / "none.ilh");
    files.push_back(folder);
    return files;
}

/// The folders of all families below \p home, including recoveries.
std::vector<fs::path> families_in(const fs::path& home) {
    std::vector<fs::path> families;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(home, error), end; !error && entry != end;
         entry.increment(error))
        if (entry->path().filename() == "family.json" && entry->is_regular_file())
            families.push_back(entry->path().parent_path());
    return families;
}

bool is_sound(const fs::path& family, const fs::path& output) {
    const std::string command =
        fmt::format("'{}' check '{}' >'{}' 2>&1", INTERLEAF_PROGRAM, family.string(), output.string());
    return std::system(command.c_str()) == 0;
}

class Run {
  public:
    Run(std::uint64_t seed, std::size_t events) : person_(seed, make_files(files_.path())), events_(events) {}

    /// \throw std::runtime_error if something has gone wrong, with a description
    void go() {
        const fs::path home = folder_.path() / "home";
        fs::create_directories(home);
        // A family to open and save.
        fs::copy(INTERLEAF_BUILTIN_FAMILY, home / "mine");
        while (done_.size() < events_) live_through(home);
        check(home);
    }

    /// The last acts, one per line.
    std::string story() const {
        std::string text;
        for (std::size_t i = done_.size() - std::min<std::size_t>(done_.size(), 30); i < done_.size(); ++i)
            text += fmt::format("  {}: {}\n", i, done_[i]);
        return text;
    }

    std::size_t checked() const { return checked_count_; }
    std::size_t starts() const { return starts_; }

  private:
    /// Runs the program until it ends, or until the run ends.
    void live_through(const fs::path& home) {
        RunningViewer viewer(home, {}, Confined::yes);
        ++starts_;
        try {
            while (done_.size() < events_) {
                done_.push_back(person_.act(viewer));
                if (viewer.has_ended()) break;
                if (done_.size() % answer_interval == 0 && !answers(viewer)) break;
                if (done_.size() % check_interval == 0) check(home);
            }
        } catch (const std::exception&) {
            if (!viewer.has_ended()) throw;
        }
        RandomPerson::let_go(viewer.desktop());
        if (!viewer.has_ended()) return viewer.kill();  // as a crash would: its saved files must be sound
        if (const int status = viewer.exit_status(); status != 0)
            throw std::runtime_error(fmt::format("the program has ended with {}", status));
        done_.emplace_back("(the program has been quit, and is started again)");
    }

    /// Waits until the program has seen the pointer move.
    /// \return false if the program has ended meanwhile
    static bool answers(RunningViewer& viewer) {
        const auto size = viewer.state()["window"];
        for (const float part : {0.45F, 0.5F}) {
            const glm::vec2 at(std::round(part * size[0].get<float>()),
                               std::round(0.5F * size[1].get<float>()));
            viewer.desktop().move_pointer(viewer.window(), at);
            viewer.wait_for("an answer", [&](const RunningViewer::State& s) {
                return viewer.has_ended() ||
                       (s["pointer"][0].get<float>() == at.x && s["pointer"][1].get<float>() == at.y);
            });
        }
        return !viewer.has_ended();
    }

    /// Checks that families saved since the last check are sound. A family that is being saved gets a little
    /// time.
    void check(const fs::path& home) {
        for (const fs::path& family : families_in(home)) {
            std::error_code error;
            const auto written = fs::last_write_time(family / "family.json", error);
            if (error || written == checked_[family]) continue;
            checked_[family] = written;
            ++checked_count_;
            const fs::path output = folder_.path() / "check.txt";
            bool sound = false;
            for (int attempt = 0; attempt < 5 && !sound; ++attempt) {
                sound = is_sound(family, output) || !fs::exists(family / "family.json");
                if (!sound) std::this_thread::sleep_for(std::chrono::milliseconds(400));
            }
            if (sound) continue;
            std::ifstream said(output);
            throw std::runtime_error(std::string(std::istreambuf_iterator<char>(said), {}));
        }
    }

    ScratchFolder folder_;
    ScratchFolder files_;  ///< outside the program's home, so that it cannot change them
    RandomPerson person_;
    std::size_t events_;
    std::vector<std::string> done_;
    std::map<fs::path, fs::file_time_type> checked_;
    std::size_t checked_count_ = 0;
    std::size_t starts_ = 0;
};

int go(const Plan& plan) {
    if (!can_confine_writes()) {
        fmt::print("random_window: this kernel cannot keep the program from writing elsewhere: not run\n");
        return 77;
    }
    for (std::size_t i = 0; i < plan.runs; ++i) {
        const std::uint64_t seed = plan.seed + i;
        const auto start = std::chrono::steady_clock::now();
        Run run(seed, plan.events);
        try {
            run.go();
        } catch (const std::exception& error) {
            fmt::print("seed {}: FAILED: {}\nwhat was done last:\n{}", seed, error.what(), run.story());
            return 1;
        }
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        fmt::print("seed {}: {} events, {} starts, {} saved families sound, {:.0f} s\n", seed, plan.events,
                   run.starts(), run.checked(), taken.count());
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace
}  // namespace interleaf

int main(int count, char** arguments) {
    interleaf::Plan plan;
    if (count > 1) plan.runs = std::stoul(arguments[1]);
    if (count > 2) plan.events = std::stoul(arguments[2]);
    if (count > 3) plan.seed = std::stoull(arguments[3]);
    return interleaf::go(plan);
}
