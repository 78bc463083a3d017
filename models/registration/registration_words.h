#pragma once

#include <QString>

namespace carina
{

class RegistrationModel;

/// What the technician has to do now, in a sentence.
[[nodiscard]] QString registrationInstruction(const RegistrationModel& model);

} // namespace carina
