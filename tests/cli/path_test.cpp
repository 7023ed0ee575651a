// A path through the parameter domain on the command line: --time, --along, and what `info` says.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/process.h"
#include "messages.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "family/family_time.h"
#include "io/family/family_file.h"

namespace interleaf {
namespace {

/// Three triangles over a domain, with a timeline from 0 to 1 and a path from 10 to 14.
Family family_with_path() {
    Family family{.name = "three", .keys = {}, .timeline = {}, .domain = {}};
    const RootComplex roots(3, {{0, 1, 2}});
    for (const float height : {0.0F, 1.0F, 5.0F})
        family.keys.push_back({std::string(1, static_cast<char>('a' + family.keys.size())),
                               unrefined(roots, {{0, 0, height}, {1, 0, height}, {0, 1, height}})});
    family.timeline.emplace(std::vector<TimelineKey>{{0, 0}, {1, 1}});
    family.domain.emplace(std::vector<DomainVertex>{{{0, 0}, 0}, {{1, 0}, 1}, {{0, 1}, 2}},
                          std::vector<Triangle>{{0, 1, 2}});
    family.path.emplace(std::vector<PathPoint>{{10, {0.25, 0.25}}, {12, {0.5, 0.25}}, {14, {0, 1}}});
    return family;
}

/// The folder of \p family; the file is the same for all commands of a test.
class SavedFamily {
  public:
    explicit SavedFamily(const Family& family) { write_family(family, folder_ / "f"); }
    std::string path() const { return folder_ / "f"; }
    Outcome exported(std::vector<std::string> choice) const {
        choice.insert(choice.begin(), {"export", path(), "-o", "-", "--format", "obj"});
        return run_interleaf(choice);
    }
    std::string mesh(const std::vector<std::string>& choice) const {
        const Outcome outcome = exported(choice);
        CHECK_MESSAGE(outcome.status == 0, outcome.errors);
        return outcome.output;
    }

  private:
    ScratchFolder folder_;
};

TEST_CASE("a time belongs to the keys or to the path, as the family says or as --along says otherwise") {
    const Family keys_drive = family_with_path();
    const Family path_drives = with_time_source(keys_drive, TimeSource::path);
    const SavedFamily by_keys(keys_drive);
    const SavedFamily by_path(path_drives);
    const std::string on_keys = by_keys.mesh({"--weights", "a=0.5,b=0.5"});
    const std::string on_path = by_keys.mesh({"--at", "0.375,0.25"});
    CHECK(on_keys != on_path);
    CHECK(by_keys.mesh({"--time", "0.5"}) == on_keys);
    CHECK(by_path.mesh({"--time", "11"}) == on_path);
    CHECK(by_keys.mesh({"--time", "11", "--along", "path"}) == on_path);
    CHECK(by_path.mesh({"--time", "11", "--along", "path"}) == on_path);
    CHECK(by_path.mesh({"--time", "0.5", "--along", "keys"}) == on_keys);

    // Without a time, time 0 counts, and times outside move to the nearest end.
    CHECK(by_path.mesh({}) == by_keys.mesh({"--at", "0.25,0.25"}));
    CHECK(by_keys.mesh({"--along", "path"}) == by_path.mesh({}));
    CHECK(by_path.mesh({"--time", "99"}) == by_keys.mesh({"--at", "0,1"}));
}

TEST_CASE("a path drives where there is no timeline") {
    Family family = family_with_path();
    family.timeline.reset();
    const SavedFamily saved(family);
    CHECK(saved.mesh({"--time", "12"}) == saved.mesh({"--at", "0.5,0.25"}));
    const Outcome outcome = saved.exported({"--along", "keys"});
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.errors, "--along: the family has no timeline"));
}

TEST_CASE("--along names a part that the family has, and goes with no point and no weights") {
    const SavedFamily saved(with_path(family_with_path(), std::nullopt));
    const std::string none = "--along: the family has no path through a parameter domain";
    const std::vector<std::pair<std::vector<std::string>, std::string>> faults{
        {{"--along", "path"}, none},
        {{"--along", "path", "--time", "1"}, none},
        {{"--along", "point"}, "--along: expected keys or path, got 'point'"},
        {{"--along", "keys", "--at", "0,0"}, "--along"},
        {{"--along", "keys", "--weights", "a=1"}, "--along"}};
    for (const auto& [choice, part] : faults) {
        CAPTURE(part);
        const Outcome outcome = saved.exported(choice);
        CHECK(outcome.status == 2);
        CHECK(contains(outcome.errors, part));
    }
    const Outcome view = run_interleaf({"view", saved.path(), "--along", "path"});
    CHECK(view.status == 2);
    CHECK(contains(view.errors, none));
    const Outcome render =
        run_interleaf({"render", saved.path(), "--along", "path", "-o", saved.path() + "/a.png"});
    CHECK(render.status == 2);
    CHECK(contains(render.errors, none));
}

TEST_CASE("info shows the path, its times and which part drives") {
    for (const TimeSource source : {TimeSource::keys, TimeSource::path}) {
        const SavedFamily saved(with_time_source(family_with_path(), source));
        const bool drives = source == TimeSource::path;
        CAPTURE(drives);
        const Outcome as_json = run_interleaf({"info", saved.path(), "--json"});
        REQUIRE(as_json.status == 0);
        CHECK(nlohmann::json::parse(as_json.output).at("path") ==
              nlohmann::json{{"points", 3}, {"begin", 10}, {"end", 14}, {"drives", drives}});
        const Outcome text = run_interleaf({"info", saved.path()});
        CHECK(contains(text.output, std::string("path through the domain, 3 points, 10 to 14 seconds, ") +
                                        (drives ? "drives the blend over time" : "the timeline drives")));
    }
    const Outcome without = run_interleaf({"info", INTERLEAF_FIVE_KEYS, "--json"});
    CHECK_FALSE(nlohmann::json::parse(without.output).contains("path"));
}

}  // namespace
}  // namespace interleaf
