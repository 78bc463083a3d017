#pragma once

#include "engine/io/site_file.h"

#include <QString>

namespace carina
{

class RegistrationModel;

/// What the technician has to do now, in a sentence.
[[nodiscard]] QString registrationInstruction(const RegistrationModel& model);

/// What has to be done before a step can be entered; empty where it can be.
[[nodiscard]] QString whyNotYet(const RegistrationModel& model, SiteStep step);

} // namespace carina
