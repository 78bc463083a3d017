#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"
#include "engine/lungs/lung_condition.h"
#include "engine/lungs/respiratory_system.h"

#include <QCommandLineParser>

#include <initializer_list>

namespace carina::lab
{

/// Options that take a value, by their names.
void addValueOptions(QCommandLineParser& parser, std::initializer_list<const char*> names);

/// `--anatomy`, `--patient`, `--condition`, `--severity` and `--side`.
void addPatientOptions(QCommandLineParser& parser);

/// The number given for an option, between two bounds.
/// @param command that the sentence names which says what is wrong
/// @returns OutOfRange for anything else, NaN included.
[[nodiscard]] Result<double> numberOption(const QCommandLineParser& parser, const char* command,
                                          const char* name, double least, double greatest);

/// The condition asked for; severity 0.6 and both lungs unless it says something else.
/// @returns OutOfRange for words and numbers that say none.
[[nodiscard]] Result<LungCondition> conditionOption(const QCommandLineParser& parser,
                                                    const char* command);

/// Who is drawn, and what size of a patient breathes.
struct Subject {
    Anatomy anatomy;
    PatientBuild build;
};

/// The set or the built-in patient asked for; the child without either. A set breathes as an adult.
/// @returns OutOfRange for a patient there is not; what reading or making it fails with.
[[nodiscard]] Result<Subject> subjectOption(const QCommandLineParser& parser, const char* command);

} // namespace carina::lab
