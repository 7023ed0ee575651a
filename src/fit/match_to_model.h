// The part of a fit in which a mesh's map is matched to the map of another body, its model, and the choice between the
// keys with and without matching.
#pragma once

#include <span>
#include <string>
#include <utility>

#include <glm/vec3.hpp>

#include "fit/correspondence/match.h"
#include "fit/fit.h"
#include "fit/fit_quality.h"
#include "fit/landmarks/landmark_agreement.h"
#include "fit/map_choice.h"
#include "fit/mesh/stopwatch.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// \param pins  of the mesh, null for none: they may say why there is no good key
/// \throw InputError  if the key is refused; a LandmarkError (pinned_map.h) if the landmarks are doubtful
void require_accepted(const JudgedMap& judged, const FitLimits& limits, const LandmarkPins* pins);

/// The least angle, in degrees, that the key of a matched map is to have; 0 for any.
double wanted_angle(const FitQuality& unmatched);

/// Why a matched map is not taken, in words: its key is refused, or much worse than that of the unmatched map.
std::string fault_of_match(const JudgedMap& matched, const FitQuality& unmatched, const FitLimits& limits);

/// Matches a map to the model's that \p options name. The key without matching is judged meanwhile, on another thread.
/// \param pins       of the mesh; null for none
/// \param landmarks  the positions of the pinned landmarks
/// \return the key with matching; where that gives none that is accepted, the key without
/// \throw InputError, LandmarkError  if the key without matching is refused
/// \throw Cancelled
std::pair<JudgedMap, MatchReport> match_to_model(ChosenMap chosen, const FitOptions& options,
                                                 const LandmarkPins* pins,
                                                 std::span<const glm::dvec3> landmarks, Stopwatch& stopwatch,
                                                 const Progress& progress);

}  // namespace interleaf
