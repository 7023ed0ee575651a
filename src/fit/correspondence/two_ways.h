// The two ways in which two bodies are matched: the mesh of the body moves over the model, or the model's mesh over the
// body. Each gives a map of the body that corresponds to the model's.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/correspondence/even_mesh.h"
#include "fit/correspondence/matched_body.h"
#include "fit/correspondence/movement.h"
#include "fit/correspondence/moving_mesh.h"
#include "fit/correspondence/sphere_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// The fractions of the work of a match at which the meshes begin to move, and at which both ways are done.
inline constexpr double moving_begins = 0.1;
inline constexpr double finishing_begins = 0.6;

/// The fraction of the comparison of one body at which its functions are measured.
inline constexpr double measuring_begins = 0.3;

/// In every candidate, shapes on the sphere are restored where their distortion is larger than this.
inline constexpr double worst_kept_shape = 4;

/// A map of the whole body, and how well it agrees with the model's.
struct Candidate {
    std::vector<glm::dvec3> points;
    MatchFigures figures;
    int passes = 0;
};

class TwoWays {
  public:
    /// \param model, body      must outlive this object
    /// \param compared         \p body on fewer vertices
    /// \param models_vertices  of the model's mesh that moves; \p movement has those of the body's
    /// \param progress         of the whole match; must outlive this object
    /// \throw Cancelled
    TwoWays(const MatchedBody& model, const SphereMesh& body, CoarsenedMesh compared,
            std::size_t models_vertices, const MovementOptions& movement, const Progress& progress);
    TwoWays(const TwoWays&) = delete;
    TwoWays& operator=(const TwoWays&) = delete;

    /// How well a map agrees with the model's: the mean over the body's mesh on the model and the model's mesh on the
    /// body. Either alone steps over what the other body has between two of its vertices.
    MatchFigures figures_of(std::span<const glm::dvec3> points);

    /// Moves the body's mesh over the model and, unless that is good, the model's mesh over the body, which heeds
    /// details that only the model has. If the first way starts clearly worse, it waits for waiting_candidates(), unless
    /// the second way ends even worse. That never waits, since its later passes gain more. These run on another thread.
    /// \return the best first; none if are_too_unlike()
    /// \throw Cancelled
    std::vector<Candidate> candidates();

    /// The candidate of the way that candidates() left waiting, if there is one.
    /// \param part  of the whole work that is done
    /// \throw Cancelled
    std::vector<Candidate> waiting_candidates(double part);

    /// Whether candidates() found no parts that correspond.
    bool are_too_unlike() const { return are_too_unlike_; }

    /// As restore_shapes() (finished_map.h).
    /// \return false if there is nothing to restore
    /// \throw Cancelled
    bool restore(double worst, int sweeps, Candidate& candidate);

    void begin_part(double part) { meter_.enter("matching", part); }

    bool is_one_to_one(const Candidate& candidate) const;

  private:
    /// One mesh that moves over the other body.
    struct Way {
        std::optional<Movement> movement;  ///< none if there is no room
        std::optional<MatchFigures>
            figures;  ///< of the candidate after the first passes, if that is one to one
        bool has_gone_on = false;
    };

    bool is_own_clearly_worse() const;
    void start_own();
    void go_on_with_own(const PartOfWork& part, std::vector<Candidate>& found);
    std::optional<Candidate> own_candidate();
    void start_models();
    std::optional<Candidate> go_on_with_models(const Progress& progress);
    std::optional<Candidate> models_candidate(bool also_coarsely);
    std::optional<Candidate> restored(Candidate candidate, ProgressMeter& meter) const;
    Candidate measured(Candidate candidate);

    const MatchedBody& model_;
    const SphereMesh& body_;
    CoarsenedMesh compared_;
    MatchedBody moved_;
    std::size_t models_vertices_;
    MovementOptions movement_;
    const Progress& progress_;
    ProgressMeter meter_;
    MovingMesh own_mesh_;  ///< with all its vertices, to measure
    MovingMesh models_mesh_;
    MatchWeights own_weights_;
    MatchWeights models_weights_;
    Way own_;

    // Of the second way, for the thread that moves it.
    Progress models_progress_;
    ProgressMeter models_meter_{models_progress_};
    std::optional<MatchedBody> even_model_;
    std::optional<MatchedBody> even_body_;
    Way models_;

    bool are_too_unlike_ = false;
};

}  // namespace interleaf
