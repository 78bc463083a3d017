#pragma once

#include "engine/geometry/fit/motion_covariance.h"
#include "models/patient/patient_model.h"

#include <QString>

#include <vector>

namespace carina
{

/// A point in A at which the TRE matters for an intubation.
struct RegistrationTarget {
    QString name;
    Vec3 p_A = Vec3::Zero();
};

/// Glottis, carina, upper incisors, and the centre of each lung's base.
[[nodiscard]] std::vector<RegistrationTarget> registrationTargets(const PatientModel& patient);

/// The expected TRE of a registration at a target.
struct ExpectedError {
    QString name{};
    double rms_mm = 0.0;
    double bound_mm = 0.0; ///< 95 % bound of the TRE
    QString weakest{};     ///< the direction in which it is largest: "left-right"
};

/// @param covariance_A of X_AM
/// @param degrees of freedom of the estimated FLE that scales the covariance
[[nodiscard]] std::vector<ExpectedError>
expectedErrors(const Mat6& covariance_A, double degrees,
               const std::vector<RegistrationTarget>& targets);

} // namespace carina
