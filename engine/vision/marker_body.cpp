#include "engine/vision/marker_body.h"

#include <set>

namespace carina
{
namespace
{

constexpr std::size_t kMostMarkers = 64;
constexpr double kSmallest = 1e-3; ///< metres
constexpr double kLargest = 1.0;

} // namespace

std::array<Vec3, 4> cornersOf(const BodyMarker& marker)
{
    const double h = 0.5 * marker.side;
    return {marker.X_BK * Vec3{-h, h, 0.0}, marker.X_BK * Vec3{h, h, 0.0},
            marker.X_BK * Vec3{h, -h, 0.0}, marker.X_BK * Vec3{-h, -h, 0.0}};
}

Result<void> checkBody(std::span<const BodyMarker> body, int markersInDictionary)
{
    if (body.empty() || body.size() > kMostMarkers)
        return fail(Errc::OutOfRange, "a body has from 1 to 64 markers");
    std::set<int> ids;
    for (const BodyMarker& marker : body) {
        const std::string name = "marker " + std::to_string(marker.id);
        if (marker.id < 0 || marker.id >= markersInDictionary)
            return fail(Errc::OutOfRange, name + " is not in the dictionary");
        if (!ids.insert(marker.id).second)
            return fail(Errc::OutOfRange, name + " is there twice");
        if (!(marker.side >= kSmallest && marker.side <= kLargest))
            return fail(Errc::OutOfRange, name + ": its side is from 1 mm to 1 m");
    }
    return {};
}

} // namespace carina
