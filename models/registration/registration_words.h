#pragma once

#include <QString>

namespace carina
{

class RegistrationModel;

/// One sentence: what the technician has to do now.
[[nodiscard]] QString registrationInstruction(const RegistrationModel& model);

} // namespace carina
