// `interleaf landmarks`, and `interleaf fit` with landmarks.
#include <array>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "hierarchy/measure.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/landmarks/landmark_file.h"
#include "io/mesh/obj_keys.h"

namespace interleaf {
namespace {

/// A mesh of the shape `star`, and the same turned, scaled and moved; both with landmarks at the same vertices.
struct TwoStars {
    ScratchFolder folder;
    std::string first = folder / "star.obj";
    std::string second = folder / "turned.obj";
    std::string first_landmarks = folder / "star.json";
    std::string second_landmarks = folder / "turned.json";
    LandmarkSet landmarks;  ///< of the first

    TwoStars() {
        REQUIRE(run_interleaf({"make", "star", "--leaves", "1500", "-o", folder / "made.ilh"}).status == 0);
        REQUIRE(run_interleaf({"export", folder / "made.ilh", "-o", first}).status == 0);
        REQUIRE(run_interleaf({"landmarks", first, "-o", first_landmarks, "--max", "6"}).status == 0);
        landmarks = read_landmarks(first_landmarks);
        const Hierarchy mesh = read_obj(first);
        std::string text;
        for (const glm::vec3& p : mesh.positions) {
            const glm::dvec3 q = turned(p);
            text += fmt::format("v {} {} {}\n", q.x, q.y, q.z);
        }
        for (const Leaf& leaf : leaves_of(mesh))
            text +=
                fmt::format("f {} {} {}\n", leaf.vertices[0] + 1, leaf.vertices[1] + 1, leaf.vertices[2] + 1);
        put(second, text);
        LandmarkSet others = landmarks;
        for (Landmark& each : others.landmarks) each.position = turned(each.position);
        put(second_landmarks, landmarks_text(others));
    }

    static glm::dvec3 turned(const glm::dvec3& p) {
        return 3.0 * glm::dvec3(p.z, p.x, p.y) + glm::dvec3(5, 0, 1);
    }

    std::vector<std::string> fit_line(const std::string& family, std::vector<std::string> more) const {
        std::vector<std::string> line = {"fit", first, second, "-o", family, "--leaves", "2000"};
        line.insert(line.end(), {"--landmarks", first_landmarks, "--landmarks", second_landmarks});
        line.insert(line.end(), more.begin(), more.end());
        return line;
    }
};

/// The two stars, and a family of their keys. All tests share them, because fits take long.
struct FittedStars : TwoStars {
    std::string family = folder / "two";
    Outcome outcome = run_interleaf(fit_line(family, {"--report", "json"}));
};

const FittedStars& fitted_stars() {
    static const FittedStars stars;
    REQUIRE_MESSAGE(stars.outcome.status == 0, stars.outcome.errors);
    return stars;
}

TEST_CASE("landmarks of the star are its tips, listed, and written to a file or to standard output") {
    const TwoStars& stars = fitted_stars();
    CHECK(stars.landmarks.landmarks.size() == 6);
    CHECK(stars.landmarks.landmarks[0].name == "tip 1");
    const Outcome listed = run_interleaf({"landmarks", stars.first, "-o", stars.folder / "all.json"});
    REQUIRE_MESSAGE(listed.status == 0, listed.errors);
    CHECK(contains(listed.output, "tip 1: at ("));
    const Outcome piped = run_interleaf({"landmarks", stars.first, "-o", "-"});
    CHECK(piped.status == 0);
    CHECK(piped.output == content(stars.folder / "all.json"));
    CHECK(run_interleaf({"landmarks", stars.first, "-o", stars.folder / "x.txt"}).status == 2);
    CHECK(run_interleaf({"landmarks", stars.first, "-o", "-", "--max", "0"}).status == 2);
    CHECK(run_interleaf({"landmarks", stars.folder / "none.obj", "-o", "-"}).status != 0);
}

TEST_CASE("landmarks place a turned and scaled copy over the first mesh, and its key has them in place") {
    const FittedStars& stars = fitted_stars();
    CHECK(stars.outcome.errors == "");
    const auto report = nlohmann::json::parse(stars.outcome.output)["meshes"];
    CHECK(report[0]["placement"].is_null());
    CHECK(report[1]["placement"]["scale"].get<double>() == doctest::Approx(1.0 / 3).epsilon(1e-6));
    CHECK(report[1]["distortion_at_90_percent"].get<double>() < 1.5);
    REQUIRE(report[1]["landmarks"].size() == 6);
    for (std::size_t k = 0; k < 6; ++k) {
        CHECK(report[0]["landmarks"][k]["direction"] == report[1]["landmarks"][k]["direction"]);
        CHECK(report[1]["landmarks"][k]["off_in_key"].get<double>() < 0.01);
    }
    const Family family = read_family(stars.family);
    const Box first = bounding_box(family.keys[0].hierarchy->positions);
    const Box second = bounding_box(family.keys[1].hierarchy->positions);
    CHECK(glm::distance(first.min, second.min) < 0.02F * first.diagonal());
    CHECK(glm::distance(first.max, second.max) < 0.02F * first.diagonal());

    // Without landmarks, the first key is the same, to the last bit.
    REQUIRE(
        run_interleaf({"fit", stars.first, "-o", stars.folder / "alone.ilh", "--leaves", "2000"}).status ==
        0);
    CHECK(serialize_hierarchy(*family.keys[0].hierarchy) ==
          serialize_hierarchy(read_hierarchy(stars.folder / "alone.ilh")));

    const std::string kept_family = stars.folder / "kept";
    const Outcome kept = run_interleaf(stars.fit_line(kept_family, {"--place", "keep", "--match", "none"}));
    REQUIRE_MESSAGE(kept.status == 0, kept.errors);
    CHECK(contains(kept.output, "landmark tip 1: "));
    const Family where_they_are = read_family(kept_family);
    CHECK(bounding_box(where_they_are.keys[1].hierarchy->positions).diagonal() ==
          doctest::Approx(3 * first.diagonal()).epsilon(0.02));
}

TEST_CASE("a family keeps its landmarks, and later keys are fitted onto them") {
    const FittedStars& stars = fitted_stars();
    const Family family = read_family(stars.family);
    REQUIRE(family.landmarks.size() == 6);
    const Outcome outcome = run_interleaf({"fit", stars.second, "--landmarks", stars.second_landmarks,
                                           "--onto", stars.family, "--match", "none", "--leaves", "2000",
                                           "-o", stars.folder / "later.ilh", "--report", "json"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    const auto landmarks = nlohmann::json::parse(outcome.output)["meshes"][0]["landmarks"];
    for (std::size_t k = 0; k < 6; ++k) {
        CHECK(landmarks[k]["direction"][1].get<double>() == family.landmarks[k].direction.y);
        CHECK(landmarks[k]["off_in_key"].get<double>() < 0.01);
    }
    const Box first = bounding_box(family.keys[0].hierarchy->positions);
    const Box later = bounding_box(read_hierarchy(stars.folder / "later.ilh").positions);
    CHECK(glm::distance(first.min, later.min) < 0.03F * first.diagonal());
    CHECK(glm::distance(first.max, later.max) < 0.03F * first.diagonal());

    CHECK(run_interleaf({"fit", stars.second, "--onto", stars.family, "-o", stars.folder / "x.ilh"}).status ==
          2);
    const Outcome without = run_interleaf({"fit", stars.second, "--landmarks", stars.second_landmarks,
                                           "--onto", INTERLEAF_FIVE_KEYS, "-o", stars.folder / "x.ilh"});
    CHECK(without.status == 1);
    CHECK(contains(without.errors, "has no landmarks"));
}

TEST_CASE("options and files of landmarks that make no sense are refused, naming the reason") {
    const TwoStars stars;
    const std::string family = stars.folder / "two";
    const auto fault = [](const std::vector<std::string>& line, int status) {
        const Outcome outcome = run_interleaf(line);
        CHECK(outcome.status == status);
        CHECK(is_one_message(outcome.errors));
        return outcome.errors;
    };
    CHECK(contains(fault(stars.fit_line(family, {"--same-size"}), 2), "--place keep"));
    CHECK(contains(fault(stars.fit_line(family, {"--place", "near"}), 2), "similarity, rigid or keep"));
    CHECK(
        contains(fault(stars.fit_line(family, {"--rotate", "x,0", "--rotate", "x,90"}), 2), "--rotate x,0"));
    CHECK(contains(
        fault({"fit", stars.first, stars.second, "--landmarks", stars.first_landmarks, "-o", family}, 2),
        "once per mesh"));
    CHECK(contains(fault({"fit", stars.first, stars.second, "--place", "rigid", "-o", family}, 2),
                   "--landmarks"));
    put(stars.second_landmarks, R"({"format": "interleaf-landmarks", "version": 1, "landmarks":
        [{"name": "tail", "position": [0, 0, 0]}]})");
    CHECK(contains(fault(stars.fit_line(family, {}), 1), "no landmark has the name"));
    put(stars.second_landmarks, "{}");
    CHECK(contains(fault(stars.fit_line(family, {}), 1), "turned.json: document: has no \"format\""));
    CHECK_FALSE(std::filesystem::exists(family));
}

}  // namespace
}  // namespace interleaf
