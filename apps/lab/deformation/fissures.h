#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/lungs/mechanics/lung_pair.h"

#include <string>
#include <vector>

namespace carina::lab
{

/// How two lobes of a lung keep together along their fissure while they move.
struct FissureFit {
    std::string upper;         ///< name of the lobe above
    std::string lower;         ///< name of the one that slides
    std::size_t points = 0;    ///< vertices of the lower lobe at the fissure
    double meanSlide_mm = 0.0; ///< how far they move along the lobe above
    double gap_mm = 0.0;       ///< by which they come away from it at most
    double overlap_mm = 0.0;   ///< by which they enter it at most
};

/// Each lower lobe against the other lobes of its lung, in the finest level. A vertex is at the
/// fissure where at rest the other lobe is within kFissure and its normal points there, not past
/// it. What counts is how the distance changes, since lobes of an anatomy do not fit to better than
/// that themselves.
[[nodiscard]] std::vector<FissureFit> fissuresOf(const Anatomy& anatomy, const LungPair& lungs,
                                                 const ChestPose& pose);

inline constexpr Length kFissure = millimetres(1.5);

} // namespace carina::lab
