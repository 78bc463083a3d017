#include "apps/lab/vision/video_comparison.h"

#include "engine/vision/picture_source.h"

#include <cmath>
#include <map>

namespace carina::lab
{
namespace
{

constexpr double kDecimetre = 0.1; ///< metres

bool isInPicture(const CameraModel& camera, const RigidTransform& X_TB)
{
    const auto pixel = project(camera, X_TB.translation());
    return pixel && pixel->x() >= 0.0 && pixel->y() >= 0.0 && pixel->x() < camera.width
           && pixel->y() < camera.height;
}

} // namespace

Result<std::vector<BodyInVideo>> compareVideo(const std::filesystem::path& video,
                                              const WatchedBodies& watched, const BodyTruth& truth)
{
    auto source = PictureSource::open({.kind = PicturePlace::Kind::Video, .path = video});
    if (!source)
        return tl::unexpected(source.error());
    MarkerWatch watch{watched};
    std::map<std::pair<std::size_t, int>, AccuracySum> sums; // by body and decimetres
    while (const auto taken = source->next()) {
        const std::vector<BodySight> sights = watch.look(taken->picture, taken->time);
        for (std::size_t body = 0; body < sights.size(); ++body) {
            const auto X_TB = truth(body, taken->time);
            if (!X_TB || !isInPicture(watched.camera, *X_TB))
                continue;
            const auto away = int(std::lround(X_TB->translation().norm() / kDecimetre));
            sums[{body, away}].add(sights[body], *X_TB);
        }
    }
    std::vector<BodyInVideo> found;
    for (const auto& [of, sum] : sums)
        found.push_back({of.first, sum.result(kDecimetre * of.second)});
    return found;
}

} // namespace carina::lab
