#pragma once

#include "models/registration/registration_model.h"
#include "widgets/report/registration_report.h"

#include <QImage>

namespace carina
{

/// The report of a registration.
/// @param picture of the anatomy with the map of the expected error; may be null
[[nodiscard]] RegistrationReport reportOf(const RegistrationModel& registration, QImage picture);

} // namespace carina
