#include "fit/landmarks/landmark_agreement.h"

#include "text/shown_text.h"
#include <fmt/core.h>

namespace interleaf {
namespace {

/// Right landmarks of four-legged animals agree with 0.9 and more; with nose and tail swapped, 0.5 to 0.7.
constexpr double good_cosine = 0.85;

/// Three points and their mirror image can be turned into each other.
constexpr std::size_t fewest_chiral = 4;

}  // namespace

bool LandmarkAgreement::is_doubtful() const {
    return mean_cosine < good_cosine;
}

std::vector<std::string> faults_of(const LandmarkAgreement& agreement,
                                   const std::vector<std::string>& names) {
    std::vector<std::string> faults;
    if (names.size() >= fewest_chiral && agreement.mirrored_cosine >= agreement.mean_cosine)
        faults.emplace_back(
            "the landmarks fit better mirrored: left and right are probably swapped in one of the meshes");
    if (agreement.is_doubtful())
        faults.push_back(
            fmt::format("the landmarks lie differently than on the first mesh (agreement {:.2f}, expected at "
                        "least {}), most "
                        "of all '{}': it is probably swapped with another one or in the wrong place; check "
                        "it, or leave it out",
                        agreement.mean_cosine, good_cosine, shown_text(names[agreement.farthest])));
    return faults;
}

std::string advice_on(const LandmarkAgreement& agreement, const std::vector<std::string>& names) {
    std::string advice;
    for (const std::string& fault : faults_of(agreement, names)) advice += "; " + fault;
    if (agreement.is_doubtful()) return advice;
    return advice + fmt::format("; the landmark '{}' is farthest from its place: check it, or leave it out",
                                shown_text(names[agreement.farthest]));
}

}  // namespace interleaf
