#pragma once

#include "apps/lab/rendering/scope_series.h"

#include <QDir>

namespace carina::lab
{

/// Which pictures of a laryngoscopy are wanted.
struct LaryngoscopyOrder {
    ScopeWay way{};
    Length lift = kUsualLift;
    std::optional<Angle> levering{}; ///< instead of the lift
    AirwayEvents events{};
    HeadPosition head{};
    /// Each is also drawn in every PictureQuality, and held against a reference (drawCompared).
    bool isCompared = false;
    QDir folder; ///< made if need be
};

/// Draws what a laryngoscope shows of a patient in each of kLaryngoscopySteps, and measures it.
/// Every picture is a PNG. The keys of what is returned are in the help of `render`.
///
/// @param anatomy with the mouth shut
/// @returns FileUnwritable with the path; what canShowAll, patientOf, Laryngoscopy::of and
///          drawShots fail with; drawCompared likewise
/// @pre as drawShots
[[nodiscard]] Result<QJsonObject> drawLaryngoscopy(Anatomy anatomy, const LaryngoscopyOrder& order);

} // namespace carina::lab
