#pragma once

#include "apps/lab/intubation/intubation_trial.h"

#include <QJsonObject>

namespace carina::lab
{

/// What was concluded of an intubation, with what became of its patient in the minute after it,
/// metrics and score: of what `carina-lab intubate` prints, all that a recording has too.
[[nodiscard]] QJsonObject watchedReport(const IntubationSubject& subject,
                                        const WatchedIntubation& watched);

/// One trial as `carina-lab intubate` prints it: that, beside what happened.
[[nodiscard]] QJsonObject trialReport(const IntubationSubject& subject,
                                      const IntubationTrial& trial);

/// "rod" or "rigid": in which shape the monitor was shown the tube.
[[nodiscard]] QString shapeWord(const IntubationSubject& subject);

/// The parameter that is not within its usual range; null where none is.
[[nodiscard]] QJsonValue outsideWord(const MotionParameters& parameters);

} // namespace carina::lab
