#include "widgets/scene/look/error_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
std::optional<ErrorRange> errorRange(const Mat4& quadric_A, std::span<const ScenePart> parts,
                                     const SceneFrame& frame)
{
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const ScenePart& part : parts) {
        const std::optional<PlacedBody> place = placeOf(frame, part.body, part.liftedWith);
        if (!place || !part.framed || part.group == MaterialGroup::Tool)
            continue;
        for (const Vec3f& p_F : part.levels.back()->positions) {
            const Vec3 p_A = place->at(p_F.cast<double>());
            const double squared =
                std::max(0.0, p_A.homogeneous().dot(quadric_A * p_A.homogeneous()));
            least = std::min(least, squared);
            most = std::max(most, squared);
        }
    }
    if (least > most)
        return std::nullopt;
    return ErrorRange{metres(std::sqrt(least)), metres(std::sqrt(most))};
}

} // namespace carina
