#pragma once

#include "engine/registration/fit/uncertain_transform.h"
#include "models/patient/patient_model.h"

#include <QString>

#include <vector>

namespace carina
{

/// A place by which an intubation is judged, in A.
struct RegistrationTarget {
    QString name;
    Vec3 p_A = Vec3::Zero();
};

/// Glottis, carina, upper incisors, and the middle of each lung's base.
[[nodiscard]] std::vector<RegistrationTarget> registrationTargets(const PatientModel& patient);

/// How far a registration is expected to be off at a target, in words and numbers.
struct ExpectedError {
    QString name{};
    double rms_mm = 0.0;
    double bound_mm = 0.0; ///< 95 % of registrations are off by less
    QString weakest{};     ///< the direction in which it is largest: "left-right"
};

/// @param covariance_A of X_AM
/// @param degrees of freedom of the estimate of its size
[[nodiscard]] std::vector<ExpectedError>
expectedErrors(const Mat6& covariance_A, double degrees,
               const std::vector<RegistrationTarget>& targets);

} // namespace carina
