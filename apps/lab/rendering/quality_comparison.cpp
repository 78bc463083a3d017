#include "apps/lab/rendering/quality_comparison.h"

#include "apps/lab/rendering/reference_picture.h"

#include <utility>
#include <vector>

namespace carina::lab
{
namespace
{

/// Of each shot: first one picture in each quality, and then the samples of the reference.
constexpr std::size_t kPicturesPerShot = kPictureQualities + std::size_t(kReferenceSamples);

std::vector<ScopeShot> comparedShots(std::span<const ScopeShot> shots)
{
    std::vector<ScopeShot> all;
    for (ScopeShot shot : shots) {
        for (std::size_t n = 0; n < kPictureQualities; ++n) {
            shot.quality = static_cast<PictureQuality>(n);
            all.push_back(shot);
        }
        shot.quality = PictureQuality::Quick;
        shot.look = SurfaceLook::Moist; // as in the finest
        for (int sample = 0; sample < kReferenceSamples; ++sample) {
            shot.sample = sample;
            all.push_back(shot);
        }
    }
    return all;
}

} // namespace

Result<void> drawCompared(const PatientModel& patient, const Laryngoscopy& laryngoscopy,
                          const ScopeWay& way, std::span<const ScopeShot> shots,
                          const std::function<Result<void>(const ComparedShot&)>& take)
{
    ComparedShot compared;
    ReferencePicture reference;
    const auto takeOne = [&](const DrawnShot& drawn) -> Result<void> {
        const std::size_t place = drawn.number % kPicturesPerShot;
        if (place < kPictureQualities) {
            compared.inQuality[place] = drawn.picture.copy();
            return {};
        }
        reference.add(drawn.picture);
        if (place + 1 < kPicturesPerShot)
            return {};
        compared.number = drawn.number / kPicturesPerShot;
        compared.reference = std::exchange(reference, {}).mean();
        return take(compared);
    };
    return drawShots(patient, laryngoscopy, way, comparedShots(shots), takeOne);
}

} // namespace carina::lab
