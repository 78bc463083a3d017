#pragma once

#include "apps/registration/simulated_workplace.h"
#include "models/registration/registration_model.h"

#include <QJsonObject>

namespace carina
{

/// The result of a registration, compared with the simulator's ground truth:
///
///     schema             "carina.registration/1"
///     landmarks          a list of name, spread_mm, residual_mm, each null where it is not there
///     rms_mm             of the fit
///     stylus             tip_mm, rms_mm
///     X_AT_mm            from the site file, four rows of four numbers
///     X_TA_true_mm       of the simulator
///     localisation_error_mm_rms   asked of the hand
///     overlay_error_mm   a list of name and mm: carina, vocal cords, incisors, and the landmarks
///
/// @param site returned by readSiteFile
/// @pre it is registered.
[[nodiscard]] QJsonObject registrationReport(const Site& site, const AirwayLandmarks& airway,
                                             const SimulatedWorkplace& workplace);

} // namespace carina
