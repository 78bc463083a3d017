#pragma once

#include "engine/core/session_time.h"
#include "engine/lungs/mechanics/respiratory_fold.h"
#include "engine/lungs/mechanics/tube_place.h"

namespace carina::fact
{

/// Height, weight, age and sex of the station's patient.
struct PatientBuildSet {
    PatientBuild build;

    friend bool operator==(const PatientBuildSet&, const PatientBuildSet&) = default;
};
/// The diseases of the lungs; they replace the previous ones.
struct LungConditionsSet {
    LungConditions conditions;

    friend bool operator==(const LungConditionsSet&, const LungConditionsSet&) = default;
};
/// The settings of the ventilator, beside rate, tidal volume and inspiratory fraction.
struct VentilatorSet {
    VentilatorSettings settings;

    friend bool operator==(const VentilatorSet&, const VentilatorSet&) = default;
};
/// An instructor says where the tube is, whatever is noted of it; or says so no longer.
struct TubePlaced {
    SetTube tube;

    friend bool operator==(const TubePlaced&, const TubePlaced&) = default;
};
/// The patient is moved into a position.
struct BodyPositionSet {
    BodyPosition position = BodyPosition::Supine;

    friend bool operator==(const BodyPositionSet&, const BodyPositionSet&) = default;
};
/// The patient's own breathing stops over a time, or goes on again over it.
struct BreathingStopped {
    bool stopped = true;
    Duration over{};

    friend bool operator==(const BreathingStopped&, const BreathingStopped&) = default;
};
/// A bag is squeezed by hand, in place of a ventilator; rate 0: no longer.
struct BagSqueezed {
    HandBag bag;

    friend bool operator==(const BagSqueezed&, const BagSqueezed&) = default;
};
/// A sensor on the manikin's chest detected the beginning of a breath.
struct ManikinBreathed {
    SessionTime began{};

    friend bool operator==(const ManikinBreathed&, const ManikinBreathed&) = default;
};
/// The state of the station's breathing at a time.
struct RespirationCheckpoint {
    SessionTime at{};
    RespiratoryState state;

    friend bool operator==(const RespirationCheckpoint&, const RespirationCheckpoint&) = default;
};

} // namespace carina::fact
