// A surface in a picture of the landmark window: drawn when it changes, seen by its own camera, with points on it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "fit/mesh/surface_mesh.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/measure.h"
#include "render/camera.h"
#include "render/display.h"
#include "render/gl_object.h"
#include "render/renderer.h"

namespace interleaf {

/// The ball of space that a picture shows.
struct ShownBall {
    glm::dvec3 center{0};
    double radius = 1;

    glm::vec3 operator()(const glm::dvec3& position) const { return {(position - center) / radius}; }
};

ShownBall ball_of(const SurfaceMesh& mesh);

class LandmarkSurface {
  public:
    /// Shows \p mesh, and finds points on it.
    void set_mesh(std::shared_ptr<const SurfaceMesh> mesh);

    /// Shows keys in place of the mesh, blended by the weights of draw().
    /// \param keys  over the same roots, one or two
    void show_keys(const std::vector<std::shared_ptr<const Hierarchy>>& keys, const ShownBall& ball);
    void show_mesh();

    bool has_mesh() const { return mesh_ != nullptr; }
    const SurfaceMesh& mesh() const { return *mesh_; }
    const ShownBall& ball() const { return ball_; }

    /// Draws the picture if anything in it has changed.
    /// \pre a GL context is current
    void draw(glm::ivec2 size, const std::vector<float>& weights, Coloring coloring);

    /// OpenGL name of the picture; 0 while there is none.
    unsigned texture() const { return texture_.name(); }

    Camera camera;

    /// The point of the mesh under a place of the picture (parts of its width and height, y down).
    std::optional<glm::dvec3> point_at(glm::vec2 place) const;

    struct Projected {
        glm::vec2 place;  ///< in the picture
        bool is_hidden;   ///< behind the surface
    };
    Projected project(const glm::dvec3& position) const;

    /// Zooms, keeping what is under \p place there.
    void zoom(float factor, glm::vec2 place);

  private:
    struct Drawn {
        glm::ivec2 size{0};
        Camera camera;
        std::vector<float> weights;
        Coloring coloring = Coloring::plain;
        bool operator==(const Drawn&) const = default;
    };
    void upload(const UnionMesh& mesh);
    float aspect() const;

    std::shared_ptr<const SurfaceMesh> mesh_;
    std::vector<glm::vec3> in_ball_;  ///< positions of the mesh in the picture's ball
    ShownBall ball_;
    bool shows_mesh_ = false;
    std::vector<std::shared_ptr<const Hierarchy>> keys_;  ///< that are shown in place of the mesh
    std::unique_ptr<Renderer> renderer_;
    std::optional<Extent> extent_to_view_;  ///< what the camera frames as a whole when the picture is drawn
    std::optional<Drawn> drawn_;
    std::vector<float> depths_;  ///< of the picture, top row first
    GlTexture texture_;
};

}  // namespace interleaf
