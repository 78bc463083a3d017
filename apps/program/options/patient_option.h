#pragma once

#include "engine/anatomy/patient/patient_dimensions.h"
#include "models/patient/patient_source.h"

#include <QCommandLineParser>

#include <optional>

namespace carina::program
{

/// The patient that a program was started with.
struct ChosenPatient {
    SharedPatientModel model;
    PatientDimensions dimensions; ///< how it breathes at rest
};

/// Adds `--anatomy DIR` and `--patient WHO` (patientFromWords).
void addPatientOptions(QCommandLineParser& parser);

/// What `--patient` says, and `--anatomy`; empty without it.
[[nodiscard]] QString patientOption(const QCommandLineParser& parser);
[[nodiscard]] QString anatomyOption(const QCommandLineParser& parser);

/// Whether these options name an anatomy set rather than a built-in patient.
[[nodiscard]] bool importsPatient(const QCommandLineParser& parser);

/// Whether these options name a patient, of either kind.
[[nodiscard]] bool namesPatient(const QCommandLineParser& parser);

/// The patient named by these options; by default the built-in child. An imported set is taken for
/// an adult. On its first import a dialog lets the person correct the roles of its surfaces, unless
/// the program runs without a person (`--start`, `--measure`, `--journal`).
///
/// @returns WrongOption for an unknown patient; the errors of importing or building it.
[[nodiscard]] Result<ChosenPatient> choosePatient(const QCommandLineParser& parser);

/// A patient who is laid already, or, where there is none, the one of choosePatient.
[[nodiscard]] Result<ChosenPatient> patientForStart(const std::optional<SharedPatientModel>& laid,
                                                    const QCommandLineParser& parser);

/// The set in a folder of surfaces, taken for an adult; on its first import a person may correct
/// the roles of its surfaces, and stop it.
/// @returns Cancelled; the errors of importing it.
[[nodiscard]] Result<ChosenPatient> importForPerson(const QString& folder);

} // namespace carina::program
