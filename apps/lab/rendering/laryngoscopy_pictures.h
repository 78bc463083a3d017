#pragma once

#include "engine/core/result.h"
#include "models/patient/laryngoscopy.h"

#include <QDir>
#include <QJsonObject>
#include <QSize>

#include <optional>

namespace carina::lab
{

/// Which pictures of a laryngoscopy are wanted.
struct LaryngoscopyOrder {
    BladeKind blade = BladeKind::Macintosh3;
    bool isDirect = false; ///< past the blade, not by the camera on it
    Length lift = kUsualLift;
    std::optional<Angle> levering{}; ///< instead of the lift
    AirwayEvents events{};
    HeadPosition head{};
    QSize size{640, 480}; ///< of each, pixels
    QDir folder;          ///< made if need be
};

/// Draws what a laryngoscope shows of a patient in each of kLaryngoscopySteps, and measures it.
/// Every picture is a PNG. The keys of what is returned are in the help of `render`.
///
/// @param anatomy with the mouth shut
/// @returns FileUnwritable with the path; NoAirway with the event that the patient lacks a part
/// for;
///          what patientOf, Laryngoscopy::of and drawSeries fail with
/// @pre as drawSeries
[[nodiscard]] Result<QJsonObject> drawLaryngoscopy(Anatomy anatomy, const LaryngoscopyOrder& order);

} // namespace carina::lab
