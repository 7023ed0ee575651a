#include "app/mesh_previews.h"

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "fit/unit_box.h"
#include "hierarchy/error.h"
#include "io/surface_file.h"
#include "render/image_texture.h"
#include "render/offscreen_target.h"
#include "render/plain_mesh.h"
#include "ui/fit_tiles.h"

namespace interleaf {

namespace {

/// Samples a pixel, in either direction, from which the pictures are made.
constexpr std::size_t subpixels = 3;

/// A picture of a part of \p target's width and height, each pixel the mean of the samples that show
/// something, and as opaque as there are such samples. RGBA, top row first.
std::vector<std::uint8_t> without_background(OffscreenTarget& target) {
    const std::vector<std::uint8_t> colors = target.read_rgba();
    const std::vector<float> depths = target.read_depths();
    const auto width = static_cast<std::size_t>(target.width());
    const std::size_t side = width / subpixels;
    std::vector<std::uint8_t> pixels;
    pixels.reserve(4 * side * side);
    for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) {
            std::array<std::size_t, 3> sums{};
            std::size_t count = 0;
            for (std::size_t sample = 0; sample < subpixels * subpixels; ++sample) {
                const std::size_t at =
                    (subpixels * y + sample / subpixels) * width + subpixels * x + sample % subpixels;
                if (depths[at] >= 1) continue;
                ++count;
                for (std::size_t c = 0; c < 3; ++c) sums[c] += colors[4 * at + c];
            }
            for (const std::size_t sum : sums)
                pixels.push_back(static_cast<std::uint8_t>(count > 0 ? sum / count : 0));
            pixels.push_back(static_cast<std::uint8_t>(255 * count / (subpixels * subpixels)));
        }
    return pixels;
}

glm::dvec3 center_of_area(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions) {
    glm::dvec3 sum(0);
    double whole = 0;
    for (const auto& [i, j, k] : triangles) {
        const glm::dvec3 &a = positions[i], &b = positions[j], &c = positions[k];
        const double area = glm::length(glm::cross(b - a, c - a));
        sum += area * (a + b + c) / 3.0;
        whole += area;
    }
    return whole > 0 ? sum / whole : positions.front();
}

/// The positions moved and scaled into the unit ball about the centre of area, from where the roots are seen.
std::vector<glm::vec3> in_unit_ball(const SurfaceFile& surface) {
    const std::vector<glm::dvec3> positions = in_unit_box(surface.positions);
    const glm::dvec3 center = center_of_area(surface.triangles, positions);
    double radius = 0;
    for (const glm::dvec3& position : positions) radius = std::max(radius, glm::distance(position, center));
    std::vector<glm::vec3> in_ball;
    in_ball.reserve(positions.size());
    for (const glm::dvec3& position : positions)
        in_ball.emplace_back(radius > 0 ? (position - center) / radius : glm::dvec3(0));
    return in_ball;
}

}  // namespace

MeshPreviews::MeshPreviews(std::vector<std::filesystem::path> meshes)
    : files_(std::move(meshes)),
      previews_(files_.size()),
      sides_(files_.size(), 0),
      thread_([this](const std::stop_token& stop) { read_all(stop); }) {}

MeshPreviews::Read MeshPreviews::read(const std::filesystem::path& file) {
    Read read;
    try {
        const SurfaceFile surface = read_surface(file);
        if (surface.triangles.empty()) throw InputError(fmt::format("{}: it has no faces", file.string()));
        read.mesh = plain_mesh(surface.triangles, in_unit_ball(surface));
        read.normals = normal_form(read.mesh);
    } catch (const std::exception& error) {
        read.fault = error.what();
    }
    return read;
}

void MeshPreviews::read_all(const std::stop_token& stop) {
    for (const std::filesystem::path& file : files_) {
        if (stop.stop_requested()) break;
        Read done = read(file);
        const std::scoped_lock lock(mutex_);
        done_.push_back(std::move(done));
    }
    is_over_ = true;
}

void MeshPreviews::take_read() {
    const std::scoped_lock lock(mutex_);
    for (const Read& read : done_) {
        Preview& preview = previews_[meshes_.size() + static_cast<std::size_t>(&read - done_.data())];
        preview.is_read = true;
        preview.triangles = read.mesh.leaf_count();
        preview.fault = read.fault;
    }
    std::ranges::move(done_, std::back_inserter(meshes_));
    done_.clear();
}

bool MeshPreviews::update(int side) {
    take_read();
    const auto is_missing = [&](std::size_t mesh) {
        return sides_[mesh] != side && previews_[mesh].fault.empty();
    };
    std::size_t mesh = 0;
    while (mesh < meshes_.size() && !is_missing(mesh)) ++mesh;
    if (mesh < meshes_.size()) draw(mesh, side);
    return mesh < meshes_.size() || meshes_.size() < files_.size();
}

void MeshPreviews::draw(std::size_t mesh, int side) {
    sides_[mesh] = side;
    try {
        if (!renderer_) renderer_.emplace();
        renderer_->upload(meshes_[mesh].mesh, meshes_[mesh].normals);
        const int samples_a_side = static_cast<int>(subpixels) * side;
        OffscreenTarget target(samples_a_side, samples_a_side, 1);
        constexpr std::array<float, 1> weight{1};
        renderer_->draw(target, tile_camera(), weight, {});
        previews_[mesh].picture = image_texture(side, side, without_background(target));
    } catch (const MachineError& error) {
        previews_[mesh].fault = fmt::format("{}: {}", files_[mesh].string(), error.what());
    }
}

}  // namespace interleaf
