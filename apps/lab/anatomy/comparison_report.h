#pragma once

#include "engine/anatomy/patient/patient_landmarks.h"
#include "evaluation/anatomy/anatomy_comparison.h"

#include <QJsonArray>
#include <QJsonObject>

namespace carina::lab
{

/// A comparison as `anatomy compare` prints it, with "unmet": one line for each demand that is not
/// met.
[[nodiscard]] QJsonObject reportOf(const AnatomyComparison& comparison);

/// "landmarks" of a report.
[[nodiscard]] QJsonObject reportOf(const PatientLandmarks& landmarks);

/// "self_intersections" of a report.
[[nodiscard]] QJsonArray listOf(const std::vector<SelfIntersection>& found);

} // namespace carina::lab
