#pragma once

#include "widgets/report/bar_table.h"
#include "widgets/report/registration_report.h"

namespace carina
{

/// A length as the report writes it, such as "0.31 mm"; a dash where there is none, or no finite
/// one.
[[nodiscard]] QString reportedMillimetres(std::optional<double> value_mm);

/// The points that were checked: the error measured, held against its expected bound.
[[nodiscard]] BarTable tableOfChecked(const RegistrationReport& report);

/// The targets: the RMS of the TRE, and its bound.
[[nodiscard]] BarTable tableOfTargets(const RegistrationReport& report);

/// The landmarks: the residual, held against the expected one.
[[nodiscard]] BarTable tableOfLandmarks(const RegistrationReport& report);

} // namespace carina
