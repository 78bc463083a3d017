#pragma once

#include "engine/core/ids.h"
#include "engine/core/units.h"

namespace carina
{

/// Facts about the people around a patient.
namespace fact
{

/// Nothing is heard of the program of a participant any more: they have left as after
/// ParticipantLeft, but not on purpose, and may come back.
struct ParticipantFellSilent {
    ParticipantId participant;

    friend bool operator==(const ParticipantFellSilent&, const ParticipantFellSilent&) = default;
};
/// A participant is at work at the station from now on: it is their tube that is in the patient,
/// and their jaw probe that opens the mouth.
struct WorkTaken {
    ParticipantId participant;
    /// Who was at work until then: void where another has taken their place.
    ParticipantId before = kNobody;

    friend bool operator==(const WorkTaken&, const WorkTaken&) = default;
};
/// Where others see a participant: their head and hands are turned about the patient, by this angle
/// about +y of A through its origin; 0 is as they are tracked. It holds until it is changed, also
/// when the participant comes in again.
struct PlaceChosen {
    ParticipantId participant;
    Angle turn;

    friend bool operator==(const PlaceChosen&, const PlaceChosen&) = default;
};

} // namespace fact

} // namespace carina
