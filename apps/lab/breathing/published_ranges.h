#pragma once

#include "engine/lungs/mechanics/respiratory_fold.h"

#include <QJsonArray>

namespace carina::lab
{

/// What was measured of one condition in `mechanics`.
struct MeasuredCondition {
    LungCondition condition;
    RespiratorySystem healthy; ///< the same patient without it, awake
    RespiratorySystem awake;
    RespiratorySystem ventilated;
    BreathFigures spontaneous;   ///< after minutes
    BreathFigures volumeControl; ///< PEEP 5 cmH2O
    BreathFigures at20PerMin;    ///< volume control with 20 breaths per minute
    Pressure rightPleuraAtLast;  ///< at the end of expiration, after ten minutes of volume control
    Pressure peep;
    double ageInYears = 0.0;
    double inspiratoryFraction = 0.0; ///< of the spontaneous breath
    double inspiratoryFractionInHealth = 0.0;
};

/// Of a push on both sides at rest: lung and wall in series, right and left beside each other.
[[nodiscard]] Compliance complianceAtRest(const RespiratorySystem& system);

/// The figures of this condition and severity for which a range is published at the patient's age,
/// each with its range, its source, whether the model was given the figure, and whether it lies
/// within. The keys are in the help of `mechanics`.
[[nodiscard]] QJsonArray publishedRanges(const MeasuredCondition& measured);

/// The same for the ranges that we ask of the model where no publication was found: without source.
[[nodiscard]] QJsonArray ourTargets(const MeasuredCondition& measured);

} // namespace carina::lab
