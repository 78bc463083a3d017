#pragma once

#include "models/scoring/try_watch.h"

#include <QCommandLineParser>

namespace carina::program
{

/// `--rubric FILE` and `--depth-rule RULE`: by what a try at intubating is judged.
void addTryOptions(QCommandLineParser& parser);

/// Has tries judged as the options say; without them by the published scheme, and by the usual rule
/// for the patient.
/// @returns WrongOption for a rule that is none; the errors of readRubricFile.
[[nodiscard]] Result<void> readTryOptions(const QCommandLineParser& parser, TryWatch& tries);

} // namespace carina::program
