#pragma once

#include "models/registration/registration_model.h"
#include "widgets/report/registration_report.h"

#include <QImage>

namespace carina
{

/// A registration as it is reported. @param picture of the anatomy with the expected error on it;
/// may be null
[[nodiscard]] RegistrationReport reportOf(const RegistrationModel& registration, QImage picture);

} // namespace carina
