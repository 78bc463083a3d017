#pragma once

#include "apps/lab/rendering/scope_series.h"

#include <array>

namespace carina::lab
{

/// One shot as the programs draw it in each quality, and its reference.
struct ComparedShot {
    std::size_t number = 0; ///< of the shot
    std::array<QImage, kPictureQualities> inQuality{};
    QImage reference; ///< of kReferenceSamples samples per pixel, with the same surfaces
};

/// Draws each shot in each PictureQuality, and once for each sample of its reference, whose mean is
/// that (ReferencePicture).
/// @param take gets what is compared in the order of the shots; a failure ends the series
/// @returns what drawShots fails with
/// @pre as drawShots
[[nodiscard]] Result<void>
drawCompared(const PatientModel& patient, const Laryngoscopy& laryngoscopy, const ScopeWay& way,
             std::span<const ScopeShot> shots,
             const std::function<Result<void>(const ComparedShot&)>& take);

} // namespace carina::lab
