// The work behind the landmark window, on a separate thread: reads the two meshes, proposes landmarks, and remakes
// the blend whenever landmarks change.
#pragma once

#include <array>
#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "fit/mesh/surface_mesh.h"
#include "fit/placement.h"
#include "fit/preview.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/landmark.h"

namespace interleaf {

/// Where a mesh comes from, and how the fit takes it.
struct LandmarkSource {
    std::filesystem::path file;
    UpAxis up = UpAxis::y;
    glm::dmat3 rotation{1};
    std::optional<Hierarchy> key{};  ///< in place of the file: a key of an existing family
};

/// A mesh in the landmark window, turned so that y is up.
struct LandmarkBody {
    SurfaceMesh mesh;                   ///< clean
    std::vector<glm::dvec3> proposals;  ///< its extremities
    std::string fault;                  ///< why there is no mesh; empty if there is one
};

/// The blend of the first mesh and another one by their landmarks.
struct LandmarkBlend {
    std::size_t mesh = 0;         ///< the other one
    std::vector<Landmark> first;  ///< the landmarks of which the blend was made
    std::vector<Landmark> other;
    std::shared_ptr<const Hierarchy> first_key;   ///< null if there is a fault
    std::shared_ptr<const Hierarchy> other_key;   ///< where its mesh is
    std::shared_ptr<const Hierarchy> placed_key;  ///< placed by the landmarks
    std::vector<double> ways;                     ///< per landmark, how far it had to come on the sphere
    std::vector<std::string> warnings;
    std::string fault;  ///< why there is no blend; empty if there is one
    double seconds = 0;
};

class LandmarkPreview {
  public:
    /// \param roots  over which the keys will be fitted
    LandmarkPreview(std::vector<LandmarkSource> sources, SphereRoots roots);
    LandmarkPreview(const LandmarkPreview&) = delete;
    LandmarkPreview& operator=(const LandmarkPreview&) = delete;
    ~LandmarkPreview() = default;

    /// Asks for the bodies of the first mesh and of \p mesh, and for their blend. Given up for a later wish.
    /// \param first,other  landmarks with the same names in the same order, turned so that y is up
    void wish(std::size_t mesh, std::vector<Landmark> first, std::vector<Landmark> other);

    /// The body of \p mesh; null before it is read.
    std::shared_ptr<const LandmarkBody> body(std::size_t mesh) const;

    /// The last finished blend; null before there is one.
    std::shared_ptr<const LandmarkBlend> blend() const;

    bool is_working() const;
    void stop() { thread_.request_stop(); }

    /// Whether the thread has ended, so that the destructor does not wait.
    bool is_over() const;

  private:
    struct Wish {
        std::size_t mesh = 0;
        std::vector<Landmark> first;
        std::vector<Landmark> other;
        std::size_t number = 0;
    };
    void work(const std::stop_token& stop);
    std::shared_ptr<const LandmarkBody> read(std::size_t mesh, const std::stop_token& stop);
    void make_blend(const Wish& wish, const std::stop_token& stop);
    std::shared_ptr<LandmarkBlend> blended(const Wish& wish, const Progress& progress);
    bool is_wanted(std::size_t number) const;

    const std::vector<LandmarkSource> sources_;
    const SphereRoots roots_;
    std::optional<PreviewReference> reference_;  ///< used by the thread alone

    mutable std::mutex mutex_;  ///< guards the members below
    std::condition_variable_any wished_;
    std::optional<Wish> wish_;
    std::size_t wish_count_ = 0;
    std::vector<std::shared_ptr<const LandmarkBody>> bodies_;
    std::shared_ptr<const LandmarkBlend> blend_;
    bool is_working_ = false;
    bool is_over_ = false;

    std::jthread thread_;  ///< last member: must end before the members it uses
};

}  // namespace interleaf
