#pragma once

#include "engine/anatomy/patient_dimensions.h"

#include <QCommandLineParser>

namespace carina::lab
{

/// Whom `--patient` means (see patientFromWords).
/// @returns OutOfRange for a patient there is not.
[[nodiscard]] Result<PatientParameters>
figuresOption(const QCommandLineParser& parser, const char* command, BuiltinPatient otherwise);

} // namespace carina::lab
