#include "app/fitting/mesh_previews.h"

#include <algorithm>
#include <array>
#include <exception>
#include <iterator>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "fit/clean_up/clean_up.h"
#include "hierarchy/color.h"
#include "hierarchy/error.h"
#include "hierarchy/vertex_normals.h"
#include "io/read_files.h"
#include "render/image_texture.h"
#include "render/lone_picture.h"
#include "render/palette.h"
#include "render/plain_mesh.h"
#include "ui/dialogs/fit_tiles.h"

namespace interleaf {

namespace {

/// Samples per pixel in each direction, from which the previews are averaged.
constexpr std::size_t subpixels = 3;

/// A picture whose width and height are those of \p target divided by subpixels. The color of a pixel is the
/// mean of its covered samples, and its opacity is their share. RGBA, top row first.
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

/// The colors of removed and of added parts; sRGB, 0 to 1.
constexpr glm::vec3 dropped_color{0.93F, 0.55F, 0.2F};
constexpr glm::vec3 made_color{0.36F, 0.64F, 0.98F};

/// Collects triangles of several colors into one mesh for a picture.
class PictureMesh {
  public:
    void add(std::span<const Triangle> triangles, std::span<const glm::dvec3> positions,
             const glm::vec3& color) {
        const auto first = static_cast<Index>(positions_.size());
        for (const auto& [a, b, c] : triangles) triangles_.push_back({first + a, first + b, first + c});
        positions_.insert(positions_.end(), positions.begin(), positions.end());
        colors_.resize(positions_.size(), color);
    }

    std::span<const Triangle> triangles() const { return triangles_; }

    /// The mesh moved and scaled into the unit ball about \p center. \p radius becomes the ball's radius.
    UnionMesh in_unit_ball(const glm::dvec3& center, double& radius) const {
        radius = 0;
        for (const Triangle& triangle : triangles_)
            for (const Index vertex : triangle)
                radius = std::max(radius, glm::distance(positions_[vertex], center));
        std::vector<glm::vec3> in_ball;
        in_ball.reserve(positions_.size());
        for (const glm::dvec3& position : positions_)
            in_ball.emplace_back(radius > 0 ? (position - center) / radius : glm::dvec3(0));
        UnionMesh mesh = plain_mesh(triangles_, in_ball);
        UnionField& field = mesh.fields.emplace_back();
        field.label = {"color", FieldKind::color};
        field.values.emplace_back();
        for (const glm::vec3& color : colors_) {
            const glm::vec3 linear = linear_light(color);
            field.values.front().insert(field.values.front().end(), {linear.r, linear.g, linear.b});
        }
        return mesh;
    }

  private:
    std::vector<Triangle> triangles_;
    std::vector<glm::dvec3> positions_;
    std::vector<glm::vec3> colors_;
};

}  // namespace

MeshPreviews::MeshPreviews(std::vector<std::filesystem::path> meshes)
    : files_(std::move(meshes)),
      previews_(files_.size()),
      drawn_(files_.size()),
      thread_([this](const std::stop_token& stop) { read_all(stop); }) {}

MeshPreviews::Read MeshPreviews::read(const std::filesystem::path& file) {
    Read read;
    try {
        SurfaceFile surface = read_surface(file);
        const SurfaceMesh brought{std::move(surface.positions), std::move(surface.triangles), {}};
        PictureMesh picture;
        try {
            const CleanMesh clean = clean_up(brought, {});
            const std::size_t kept = clean.mesh.triangles.size() - clean.report.filling_triangles();
            const std::span<const Triangle> triangles = clean.mesh.triangles;
            picture.add(triangles.first(kept), clean.mesh.positions, plain_color);
            picture.add(triangles.subspan(kept), clean.mesh.positions, made_color);
            picture.add(clean.dropped.triangles, clean.dropped.positions, dropped_color);
            read.body.surface = extent_of(clean.mesh);
            read.dropped = clean.report.dropped_area;
            read.made = clean.report.made_area;
        } catch (const InputError&) {  // the fit will report the reason; show the mesh unchanged
            picture.add(brought.triangles, brought.positions, plain_color);
            read.body.surface = extent_of(brought);
        }
        read.body.ball_center = read.body.surface.center;
        read.mesh = picture.in_unit_ball(read.body.ball_center, read.body.ball_radius);
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
        preview.body = read.body;
        preview.dropped = read.dropped;
        preview.made = read.made;
    }
    std::ranges::move(done_, std::back_inserter(meshes_));
    done_.clear();
}

bool MeshPreviews::update(int side, std::span<const UpAxis> ups) {
    take_read();
    for (std::size_t mesh = 0; mesh < meshes_.size(); ++mesh) {
        const Drawn wanted{side, ups[mesh]};
        if (drawn_[mesh] == wanted || !previews_[mesh].fault.empty()) continue;
        draw(mesh, wanted);
        return true;
    }
    return meshes_.size() < files_.size();
}

void MeshPreviews::draw(std::size_t mesh, const Drawn& as) {
    drawn_[mesh] = as;
    const auto turned = [&](const glm::dvec3& position) {
        std::vector<glm::dvec3> one{position};
        turn_up(one, as.up);
        return one.front();
    };
    try {
        UnionMesh drawn = meshes_[mesh].mesh;
        for (glm::vec3& position : drawn.positions.front())
            position = glm::vec3(turned(glm::dvec3(position)));
        TileBody& body = previews_[mesh].body = meshes_[mesh].body;
        body.surface.center = turned(body.surface.center);
        body.ball_center = turned(body.ball_center);

        if (!renderer_) renderer_.emplace();
        const UnionField& colors = drawn.fields.front();
        const int fine_side = static_cast<int>(subpixels) * as.side;
        LonePicture picture{.size = {fine_side, fine_side},
                            .samples = 1,
                            .camera = tile_camera(),
                            .display = {},
                            .field = &colors};
        picture.display.coloring = Coloring::field;
        picture.display.field = colors.label.name;
        OffscreenTarget target = draw_alone(*renderer_, drawn, normal_form(drawn), picture);
        previews_[mesh].picture = image_texture(as.side, as.side, without_background(target));
    } catch (const MachineError& error) {
        previews_[mesh].fault = fmt::format("{}: {}", files_[mesh].string(), error.what());
    }
}

}  // namespace interleaf
