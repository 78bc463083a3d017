#pragma once

#include "widgets/report/bar_table.h"
#include "widgets/report/registration_report.h"

namespace carina
{

/// A length as text, such as "0.31 mm"; a dash if it is absent or not finite.
[[nodiscard]] QString reportedMillimetres(std::optional<double> value_mm);

/// The check points: measured error, compared with its expected bound.
[[nodiscard]] BarTable tableOfChecked(const RegistrationReport& report);

/// The targets: the RMS of the TRE, and its bound.
[[nodiscard]] BarTable tableOfTargets(const RegistrationReport& report);

/// The landmarks: residual, compared with the expected one.
[[nodiscard]] BarTable tableOfLandmarks(const RegistrationReport& report);

} // namespace carina
