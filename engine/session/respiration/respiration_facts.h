#pragma once

#include "engine/core/session_time.h"
#include "engine/lungs/mechanics/respiratory_fold.h"

namespace carina::fact
{

/// Who the patient of the station is.
struct PatientBuildSet {
    PatientBuild build;

    friend bool operator==(const PatientBuildSet&, const PatientBuildSet&) = default;
};
/// What ails the lungs; one condition takes the place of another.
struct LungConditionSet {
    LungCondition condition;

    friend bool operator==(const LungConditionSet&, const LungConditionSet&) = default;
};
/// Who breathes the patient, and how, besides rate, tidal volume and inspiratory fraction.
struct VentilatorSet {
    VentilatorSettings settings;

    friend bool operator==(const VentilatorSet&, const VentilatorSet&) = default;
};
/// A tube of that inner diameter is in the trachea; 0: none is.
struct TubePlaced {
    Length innerDiameter;

    friend bool operator==(const TubePlaced&, const TubePlaced&) = default;
};
/// The patient lies or sits otherwise.
struct BodyPositionSet {
    BodyPosition position = BodyPosition::Supine;

    friend bool operator==(const BodyPositionSet&, const BodyPositionSet&) = default;
};
/// A sensor on the manikin's chest saw a breath begin.
struct ManikinBreathed {
    SessionTime began{};

    friend bool operator==(const ManikinBreathed&, const ManikinBreathed&) = default;
};
/// Where the breathing of the station had come to.
struct RespirationCheckpoint {
    SessionTime at{};
    RespiratoryState state;

    friend bool operator==(const RespirationCheckpoint&, const RespirationCheckpoint&) = default;
};

} // namespace carina::fact
