#pragma once

#include "apps/lab/command_options.h"
#include "engine/anatomy/anatomy.h"
#include "engine/lungs/lung_condition.h"
#include "engine/lungs/respiratory_system.h"
#include "engine/lungs/ventilation.h"

#include <string_view>

namespace carina::lab
{

/// `--anatomy`, `--patient`, `--condition`, `--severity`, `--side` and `--ventilator`.
void addPatientOptions(QCommandLineParser& parser);

/// The condition asked for; severity 0.6 and both lungs unless it says something else.
/// @returns OutOfRange for words and numbers that say none, and for a severity or a side of health.
[[nodiscard]] Result<LungCondition> conditionOption(const QCommandLineParser& parser,
                                                    const char* command);

/// What makes the breaths; the patient, unless a ventilator is asked for.
/// @returns OutOfRange for a ventilator there is not.
[[nodiscard]] Result<VentilationMode> ventilatorOption(const QCommandLineParser& parser,
                                                       const char* command);

/// The word for it in command lines and results; "none" where the patient breathes.
[[nodiscard]] std::string_view ventilatorName(VentilationMode mode);

/// Who is drawn, and what size of a patient breathes.
struct Subject {
    Anatomy anatomy;
    PatientBuild build;
};

/// The set or the made patient asked for; the child without either. A set breathes as the patient
/// asked for with it, or as an adult.
/// @returns OutOfRange for a patient there is not; what reading or making it fails with.
[[nodiscard]] Result<Subject> subjectOption(const QCommandLineParser& parser, const char* command);

} // namespace carina::lab
