// Tests of automatic matching, on bodies whose correspondence is known: star shapes on two unlike meshes.
#include "fit/correspondence/match.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "fit/correspondence/coarsening.h"
#include "fit/correspondence/direction_insertion.h"
#include "fit/correspondence/even_mesh.h"
#include "fit/correspondence/matched_body.h"
#include "fit/correspondence/moving_mesh.h"
#include "fit/fit.h"
#include "fit/landmarks/pinned_map.h"
#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/star_shapes.h"
#include "hierarchy/error.h"

using namespace interleaf;
using interleaf::testing::MappedMesh;

namespace {

const MatchOptions quick = {.vertices = 1500, .max_passes = 4};

glm::dmat3 turn_about_z(double sine) {
    const double cosine = std::sqrt(1 - sine * sine);
    return {{cosine, sine, 0}, {-sine, cosine, 0}, {0, 0, 1}};
}

/// A body with a nose, two ears and a tail.
double radius_of(const glm::dvec3& u) {
    const auto bump = [&](const glm::dvec3& at, double height, double width) {
        const glm::dvec3 away = u - glm::normalize(at);
        return height / (1 + glm::dot(away, away) / (width * width));
    };
    return 1 + bump({1, 0, 0.2}, 0.6, 0.3) + bump({0.3, 0.5, 1}, 0.4, 0.2) + bump({0.3, -0.5, 1}, 0.4, 0.2) +
           bump({-1, 0, -0.3}, 0.8, 0.25);
}

/// The body on a mesh that is turned against the sphere by \p mesh_turn, denser towards one side by \p pull.
MappedMesh body_on_mesh(unsigned divisions, const glm::dmat3& mesh_turn, double pull) {
    MappedMesh body = testing::unit_sphere_mesh(divisions);
    for (std::size_t v = 0; v < body.points.size(); ++v) {
        body.points[v] = glm::normalize(mesh_turn * body.points[v] + pull * glm::dvec3(0.3, -0.8, 0.5));
        body.mesh.positions[v] = radius_of(body.points[v]) * body.points[v];
    }
    return body;
}

/// The mean distance between each vertex's own direction and its point in the matched map.
double mean_error(const MappedMesh& body, const MatchedMap& matched) {
    double sum = 0;
    for (std::size_t v = 0; v < body.points.size(); ++v)
        sum += glm::distance(body.points[v], matched.points[v]);
    return sum / double(body.points.size());
}

/// A map of the same body that is wrong: drawn to one side and turned.
std::vector<glm::dvec3> wrong_map(const MappedMesh& body, const glm::dmat3& turn) {
    std::vector<glm::dvec3> points;
    for (const glm::dvec3& point : body.points)
        points.push_back(glm::normalize(turn * point + glm::dvec3(0, 0.25, 0.1)));
    return points;
}

}  // namespace

TEST_CASE("matching finds the known correspondence of a body on unlike meshes, and flips nothing") {
    struct Case {
        unsigned divisions;
        double sine;  ///< of the wrong turn, up to 20 degrees
        double pull;
    };
    for (const Case& each : {Case{3, 0.1, 0.0}, Case{4, -0.34, 0.2}, Case{4, 0.25, -0.3}}) {
        CAPTURE(each.divisions);
        CAPTURE(each.sine);
        const MappedMesh first = body_on_mesh(4, glm::dmat3(1), 0);
        const MappedMesh second = body_on_mesh(each.divisions, turn_about_z(0.6), each.pull);
        const std::vector<glm::dvec3> given = wrong_map(second, turn_about_z(each.sine));
        double before = 0;
        for (std::size_t v = 0; v < given.size(); ++v) before += glm::distance(given[v], second.points[v]);
        before /= double(given.size());

        const auto model = model_of(first.mesh, first.points, glm::dmat3(1), {}, quick, {});
        const MatchedMap matched = match(*model, second.mesh, given, glm::dmat3(1), {}, quick, {});
        REQUIRE(matched.report.fault.empty());
        const double after = mean_error(second, matched);
        MESSAGE(doctest::toString(each.divisions) << " divisions: mean error " << before << " before, "
                                                  << after << " after, passes: " << matched.report.passes);
        CHECK(after < 0.35 * before);
        CHECK(after < 0.06);
        CHECK(fault_of_map(matched.mesh, matched.points).empty());
        CHECK(matched.report.after.energy < matched.report.before.energy);
        CHECK(matched.report.after.mean_cosine > 0.97);
        CHECK(matched.report.after.stretched < 0.01);
    }
}

TEST_CASE("the matched map is one of the same surface: the given vertices come first, in place") {
    const MappedMesh first = body_on_mesh(3, glm::dmat3(1), 0);
    const MappedMesh second = body_on_mesh(2, turn_about_z(0.5), 0.1);
    const auto model = model_of(first.mesh, first.points, glm::dmat3(1), {}, quick, {});
    const MatchedMap matched = match(*model, second.mesh, second.points, glm::dmat3(1), {}, quick, {});
    REQUIRE(matched.report.fault.empty());
    REQUIRE(matched.mesh.positions.size() > second.mesh.positions.size());
    CHECK(std::equal(second.mesh.positions.begin(), second.mesh.positions.end(),
                     matched.mesh.positions.begin()));
    CHECK(matched.points.size() == matched.mesh.positions.size());
    const MatchedMap again = match(*model, second.mesh, second.points, glm::dmat3(1), {}, quick, {});
    CHECK(matched.points == again.points);
}

TEST_CASE("matching keeps the given map where no match agrees better") {
    const MappedMesh body = body_on_mesh(4, glm::dmat3(1), 0);
    const auto model = model_of(body.mesh, body.points, glm::dmat3(1), {}, quick, {});
    const MatchedMap matched = match(*model, body.mesh, body.points, glm::dmat3(1), {}, quick, {});
    CHECK(matched.report.before.distortion < 1.01);
    if (!matched.report.fault.empty()) {
        CHECK(matched.mesh.triangles.empty());
        CHECK(matched.report.after.energy == matched.report.before.energy);
    } else {
        CHECK(matched.report.after.energy < matched.report.before.energy);
    }
}

TEST_CASE(
    "matching holds landmarks to the last bit, and brings the rest nearer to its place than pins alone") {
    const MappedMesh first = body_on_mesh(4, glm::dmat3(1), 0);
    const MappedMesh second = body_on_mesh(3, turn_about_z(0.6), 0.3);
    LandmarkPins pins;
    for (const glm::dvec3& extremity :
         {glm::dvec3(1, 0, 0.2), glm::dvec3(0.3, 0.5, 1), glm::dvec3(-1, 0, -0.3)}) {
        const auto along = [&](const glm::dvec3& point) {
            return glm::dot(point, glm::normalize(extremity));
        };
        const auto nearest = std::ranges::max_element(second.points, {}, along);
        pins.names.push_back(std::to_string(pins.names.size()));
        pins.vertices.push_back(static_cast<Index>(nearest - second.points.begin()));
        pins.directions.push_back(*nearest);
    }
    const PinnedMap pinned = map_to_pins(second.mesh, pins, {}, {});
    const auto model = model_of(first.mesh, first.points, glm::dmat3(1), pins.directions, quick, {});
    REQUIRE(model->landmarks().size() == pins.vertices.size());
    const MatchedMap matched =
        match(*model, second.mesh, pinned.points, glm::dmat3(1), pins.vertices, quick, {});
    REQUIRE(matched.report.fault == "");
    CHECK(fault_of_map(matched.mesh, matched.points).empty());
    for (std::size_t k = 0; k < pins.vertices.size(); ++k)
        CHECK(matched.points[pins.vertices[k]] == pins.directions[k]);
    const double before = mean_error(second, {.mesh = {}, .points = pinned.points, .report = {}});
    CHECK(mean_error(second, matched) < 0.5 * before);
    CHECK(mean_error(second, matched) < 0.03);
}

TEST_CASE("points in given directions become vertices, also at corners, on edges and two in one triangle") {
    const MappedMesh body = body_on_mesh(1, glm::dmat3(1), 0);
    SphereMesh mesh = normalized(body.mesh, body.points, glm::dmat3(1));
    const auto& [a, b, c] = mesh.triangles.front();
    const std::vector<glm::dvec3> directions = {
        mesh.points[a], glm::normalize(mesh.points[a] + mesh.points[b]),
        glm::normalize(mesh.points[a] + mesh.points[b] + mesh.points[c]),
        glm::normalize(2.0 * mesh.points[a] + mesh.points[b] + mesh.points[c]), mesh.points[a]};
    const Index corner = a;
    insert_directions(mesh, directions);
    REQUIRE(mesh.landmarks.size() == 4);
    CHECK(mesh.landmarks.front().vertex == corner);
    for (const SphereLandmark& landmark : mesh.landmarks)
        CHECK(glm::distance(mesh.points[landmark.vertex], landmark.direction) < 2e-3);
    CHECK(fault_of_map({.positions = mesh.positions, .triangles = mesh.triangles, .colors = {}}, mesh.points)
              .empty());
}

TEST_CASE("matching can be cancelled, and its progress never falls") {
    const MappedMesh first = body_on_mesh(3, glm::dmat3(1), 0);
    const MappedMesh second = body_on_mesh(3, turn_about_z(0.5), 0.1);
    const auto model = model_of(first.mesh, first.points, glm::dmat3(1), {}, quick, {});
    double last = 0;
    bool falls = false;
    match(*model, second.mesh, second.points, glm::dmat3(1), {}, quick, [&](std::string_view, double part) {
        falls = falls || part < last;
        last = part;
        return true;
    });
    CHECK_FALSE(falls);
    CHECK(last > 0.8);
    CHECK_THROWS_AS(match(*model, second.mesh, second.points, glm::dmat3(1), {}, quick,
                          [](std::string_view, double part) { return part < 0.5; }),
                    Cancelled);
}

TEST_CASE("an even mesh has the wanted number of vertices, and its map is one to one") {
    for (const std::size_t vertices : {std::size_t{300}, std::size_t{3000}}) {
        const MappedMesh body = body_on_mesh(4, turn_about_z(0.3), 0.3);
        const SphereMesh whole = normalized(body.mesh, body.points, glm::dmat3(1));
        const Progress none;
        ProgressMeter meter(none);
        SphereMesh divided = whole;
        split_long_edges(divided, vertices, meter);
        const SphereMesh even = coarsened(divided, vertices, {}).mesh;
        CHECK(even.positions.size() <= vertices);
        CHECK(even.positions.size() > 0.7 * double(vertices));
        const SurfaceMesh mesh{.positions = even.positions, .triangles = even.triangles, .colors = {}};
        CHECK(fault_of_map(mesh, even.points).empty());
    }
}

TEST_CASE("a moving mesh comes to rest also over a body that is turned far") {
    const MappedMesh first = body_on_mesh(4, glm::dmat3(1), 0);
    const MappedMesh second = body_on_mesh(4, turn_about_z(0.6), 0.2);
    const MatchedBody moving(normalized(first.mesh, first.points, glm::dmat3(1)), {});
    for (const double sine : {0.55, 0.65, 0.75}) {
        CAPTURE(sine);
        const MatchedBody onto(normalized(second.mesh, second.points, turn_about_z(sine)), {});
        int reports = 0;  // one per about 300 moves of a vertex
        const Progress count = [&](std::string_view, double) { return ++reports > 0; };
        ProgressMeter meter(count);
        MovingMesh mesh(moving, onto, meter);
        mesh.put_at_own_points();
        mesh.set_weights(weights_at(double(mesh.count())));
        mesh.relax(2000);
        // A mesh that went back and forth would cause 4,800 to 14,500.
        CHECK(reports < 1500);
    }
}

TEST_CASE("a match whose key is no good is relaxed further, and given up in the end") {
    const MappedMesh first = body_on_mesh(3, glm::dmat3(1), 0);
    const MappedMesh second = body_on_mesh(3, turn_about_z(0.5), 0.2);
    const std::vector<glm::dvec3> given = wrong_map(second, turn_about_z(0.2));
    const auto model = model_of(first.mesh, first.points, glm::dmat3(1), {}, quick, {});
    std::vector<std::vector<glm::dvec3>> judged;
    const auto match_with = [&](std::size_t refused) {
        judged.clear();
        return match(*model, second.mesh, given, glm::dmat3(1), {}, quick, {},
                     [&](const MatchedMap& map, const Progress&) {
                         judged.push_back(map.points);
                         return judged.size() > refused ? std::string() : std::string("bad leaves");
                     });
    };
    const MatchedMap accepted = match_with(1);
    REQUIRE(judged.size() == 2);
    CHECK(accepted.report.fault == "");
    CHECK(accepted.points == judged.back());
    CHECK(judged.front() != judged.back());
    const MatchedMap given_up = match_with(100);
    CHECK(given_up.report.fault == "no good key: bad leaves");
    CHECK(given_up.points.empty());
    CHECK(given_up.report.after.energy == given_up.report.before.energy);
}

TEST_CASE("bodies that are too unlike are given up after the first passes, without the judging of a key") {
    MappedMesh along_x = body_on_mesh(4, glm::dmat3(1), 0);
    MappedMesh along_y = along_x;
    for (std::size_t v = 0; v < along_x.points.size(); ++v) {
        along_x.mesh.positions[v] = glm::dvec3(12, 1, 1) * along_x.points[v];
        along_y.mesh.positions[v] = glm::dvec3(1, 12, 1) * along_y.points[v];
    }
    const auto model = model_of(along_x.mesh, along_x.points, glm::dmat3(1), {}, quick, {});
    int judged = 0;
    const MatchedMap matched = match(*model, along_y.mesh, along_y.points, glm::dmat3(1), {}, quick, {},
                                     [&](const MatchedMap&, const Progress&) {
                                         ++judged;
                                         return std::string();
                                     });
    CHECK(matched.report.fault == "the bodies are too unlike");
    CHECK(judged == 0);
    CHECK(matched.points.empty());
    CHECK(matched.report.after.energy == matched.report.before.energy);
}

TEST_CASE(
    "a refinement that stops on the way and goes on ends in the same places as one that does not stop") {
    const MappedMesh first = body_on_mesh(3, glm::dmat3(1), 0);
    const MappedMesh second = body_on_mesh(3, turn_about_z(0.5), 0.1);
    const auto model = model_of(first.mesh, first.points, glm::dmat3(1), {}, quick, {});
    const auto body = model_of(second.mesh, second.points, glm::dmat3(1), {}, quick, {});
    const Progress none;
    ProgressMeter meter(none);
    constexpr int sweeps = 5;
    constexpr std::size_t on_the_way = 200;
    MovingMesh whole(*body, *model, meter);
    const std::size_t all = whole.count();
    whole.coarsen_to(100, 0, false);
    MovingMesh stopped = whole;
    REQUIRE(stopped.refine(sweeps, on_the_way));
    CHECK(stopped.count() >= on_the_way);
    CHECK(stopped.count() < all);
    REQUIRE(stopped.refine(sweeps));
    REQUIRE(whole.refine(sweeps));
    CHECK(stopped.count() == all);
    CHECK(stopped.places().on_sphere == whole.places().on_sphere);
}

TEST_CASE("undoing all collapses of a coarsening restores the mesh") {
    const MappedMesh body = body_on_mesh(3, glm::dmat3(1), 0.2);
    const SphereMesh whole = normalized(body.mesh, body.points, glm::dmat3(1));
    HalfEdgeMesh mesh(static_cast<Index>(whole.positions.size()), whole.triangles);
    const Progress none;
    ProgressMeter meter(none);
    const std::vector<Index> collapses =
        coarsen(mesh, 50, {.positions = whole.positions, .points = whole.points, .variation = 3}, meter);
    CHECK(collapses.size() > whole.positions.size() / 2);
    for (auto half_edge = collapses.rbegin(); half_edge != collapses.rend(); ++half_edge)
        mesh.undo_collapse(*half_edge);
    for (Index t = 0; t < mesh.triangle_capacity(); ++t)
        for (Index k = 0; k < 3; ++k) CHECK(mesh.origin(3 * t + k) == whole.triangles[t][k]);
}

TEST_CASE("fit with a model matches the key, and without one fits as before") {
    const MappedMesh first = body_on_mesh(3, glm::dmat3(1), 0);
    const MappedMesh second = body_on_mesh(3, turn_about_z(0.5), 0.2);
    const FittedKey alone = fit(first.mesh, {.leaves = 2000});
    CHECK_FALSE(alone.report.match);
    REQUIRE(alone.points.size() == alone.mapped_mesh().positions.size());
    // The model's map is drawn to one side, so that the two maps do not agree by themselves.
    const std::vector<glm::dvec3> drawn = wrong_map({alone.mapped_mesh(), alone.points}, turn_about_z(0.2));
    const auto model = model_of(alone.mapped_mesh(), drawn, glm::dmat3(1), {}, quick, {});
    FitOptions options{.leaves = 2000};
    options.model = model.get();
    options.matching = quick;
    double last = 0;
    bool falls = false;
    const FittedKey matched = fit(second.mesh, options, [&](std::string_view, double part) {
        falls = falls || part < last;
        last = part;
        return true;
    });
    CHECK_FALSE(falls);
    REQUIRE(matched.report.match);
    CHECK(matched.report.match->fault == "");
    CHECK(matched.report.match->after.energy < matched.report.match->before.energy);
    CHECK(matched.report.match->half_way_area_after > matched.report.match->half_way_area_before);
    CHECK(matched.report.match->half_way_area_after > 0.95);
    CHECK(matched.report.quality.hausdorff < 0.005);

    options.limits.hausdorff = 1e-6;  // refuses the key without matching, whatever the match gives
    CHECK_THROWS_WITH_AS(fit(second.mesh, options), doctest::Contains("no good key"), InputError);
}

TEST_CASE("a way that starts clearly worse is gone on with only when all keys of the other way are refused") {
    const auto hand = [](double length, double tilt) {
        return testing::star_shape(5, [=](const glm::dvec3& u) {
            constexpr double width = 0.08;
            double radius = 1;
            for (const double y : {-0.6, -0.2, 0.2, 0.6}) {
                const glm::dvec3 away = u - glm::normalize(glm::dvec3(1, y, tilt));
                radius += length / (1 + glm::dot(away, away) / (width * width));
            }
            return radius;
        });
    };
    const MappedMesh first = hand(2.4, 0);
    const MappedMesh second = hand(1.2, 0.3);
    const auto model = model_of(first.mesh, first.points, glm::dmat3(1), {}, quick, {});
    std::vector<int> work;  // before each key that is judged, and after the last one, in reports of progress
    std::vector<double> energies;
    const auto match_with = [&](std::size_t refused) {
        work.assign(1, 0);
        energies.clear();
        const auto count = [&](std::string_view, double) {
            ++work.back();
            return true;
        };
        return match(*model, second.mesh, second.points, glm::dmat3(1), {}, quick, count,
                     [&](const MatchedMap& map, const Progress&) {
                         work.push_back(0);
                         energies.push_back(map.report.after.energy);
                         return energies.size() > refused ? std::string() : std::string("bad leaves");
                     });
    };
    CHECK(match_with(100).report.fault == "no good key: bad leaves");
    const auto going_on =
        std::max_element(work.begin() + 1, work.end() - 1);  // the second way moves only then
    for (auto other = work.begin() + 1; other != work.end(); ++other)
        CHECK((other == going_on || *other * 5 < *going_on));
    const auto refused = static_cast<std::size_t>(going_on - work.begin());
    REQUIRE(refused >= 2);
    const std::vector<double> all = energies;
    CHECK(all[0] < all[refused]);

    CHECK(match_with(0).report.fault == "");
    CHECK(energies.size() == 1);
    CHECK(work[1] * 5 < work[0]);
    CHECK(match_with(refused).report.after.energy == all[refused]);
    CHECK(energies.size() == refused + 1);
}
