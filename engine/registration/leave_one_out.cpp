#include "engine/registration/leave_one_out.h"

#include <utility>

namespace carina
{

Result<std::vector<std::optional<double>>> leaveOneOut(std::span<const LandmarkPair> pairs)
{
    if (const Result<RigidFit> all = fitRigid(pairs); !all)
        return tl::unexpected(all.error());
    std::vector<std::optional<double>> distances;
    // The one left out stands last; each change puts it back into the place of the next.
    std::vector<LandmarkPair> turn{pairs.begin(), pairs.end()};
    for (LandmarkPair& place : turn) {
        std::swap(place, turn.back());
        const LandmarkPair& out = turn.back();
        const Result<RigidFit> others = fitRigid(std::span{turn}.first(turn.size() - 1));
        distances.push_back(others ? std::optional{(out.p_AQ - others->X_AM * out.p_MQ).norm()}
                                   : std::nullopt);
        std::swap(place, turn.back());
    }
    return distances;
}

} // namespace carina
