#pragma once

#include "apps/lab/intubation/intubation_trial.h"

#include <QJsonObject>

namespace carina::lab
{

/// One trial as `carina-lab intubate` prints it, with what became of its patient in the minute
/// after it, metrics and score.
[[nodiscard]] QJsonObject trialReport(const IntubationSubject& subject,
                                      const IntubationTrial& trial);

/// The parameter that is not within its usual range; null where none is.
[[nodiscard]] QJsonValue outsideWord(const MotionParameters& parameters);

} // namespace carina::lab
