#pragma once

#include "apps/lab/command/words.h"
#include "apps/lab/intubation/intubation_subject.h"

namespace carina::lab
{

/// Whom the options kPatient, kAnatomy and intubate_option::kTube mean.
/// @returns the errors of subjectOption and intubationSubject
[[nodiscard]] Result<IntubationSubject> intubationSubjectOption(const Words& words);

/// `carina-lab intubate RECORDING`: what the monitor makes of a recording.
/// @returns the errors of readAnyRecording, readSiteFile, stationRegistration, intubationSubject
///          and watchRecording; OtherPatient; WrongOption
[[nodiscard]] Result<QJsonObject> watchFile(const Words& words);

} // namespace carina::lab
