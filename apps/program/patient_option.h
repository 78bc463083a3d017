#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"
#include "models/patient/patient_source.h"

#include <QCommandLineParser>

namespace carina::program
{

/// The patient that a program was started with.
struct ChosenPatient {
    SharedPatientModel model;
    PatientDimensions dimensions; ///< how it breathes at rest
};

/// Adds `--anatomy DIR` and `--patient WHO` (patientFromWords).
void addPatientOptions(QCommandLineParser& parser);

/// Whether these options name a set rather than a built-in patient.
[[nodiscard]] bool importsPatient(const QCommandLineParser& parser);

/// The patient that these options name; the child without them. An imported set is taken for an
/// adult. One that is imported for the first time is shown to the person, who may correct what its
/// surfaces are, unless the program starts or works by itself (`--start`,
/// `--measure`, `--journal`).
///
/// @returns WrongOption for another patient; what importing or building it fails with.
[[nodiscard]] Result<ChosenPatient> choosePatient(const QCommandLineParser& parser);

} // namespace carina::program
