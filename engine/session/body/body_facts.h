#pragma once

#include "engine/airway/monitor/intubation_event.h"
#include "engine/physiology/body_state.h"
#include "engine/physiology/drug.h"
#include "engine/physiology/gas_supply.h"

namespace carina::fact
{

/// What the patient breathes, by mask or tube, and whether the oximeter has its probe.
struct GasSupplySet {
    GasSupply gas;

    friend bool operator==(const GasSupplySet&, const GasSupplySet&) = default;
};
/// A drug is given into a vein at the effect time.
struct DrugGiven {
    DrugDose dose;

    friend bool operator==(const DrugGiven&, const DrugGiven&) = default;
};
/// The cuff of the tube that a monitor notes is inflated or emptied.
struct CuffSet {
    bool inflated = true;

    friend bool operator==(const CuffSet&, const CuffSet&) = default;
};
/// The stylet is drawn out of the tube.
struct StyletDrawn {
    friend bool operator==(const StyletDrawn&, const StyletDrawn&) = default;
};
/// The tube of the station's patient is kinked, bitten on or blocked, from 0, open, to 1, shut.
struct TubeObstructed {
    double share = 0.0; ///< of its lumen that is lost

    friend bool operator==(const TubeObstructed&, const TubeObstructed&) = default;
};
/// The monitor of an intubation notes what happened at the station.
struct IntubationNoted {
    IntubationEvent event;
    /// Of the tube that it watches; 0 where it is not known: one that fits the patient then.
    Length innerDiameter{};

    friend bool operator==(const IntubationNoted&, const IntubationNoted&) = default;
};
/// A person ends the try at intubating that is under way at the station.
struct TryEnded {
    friend bool operator==(const TryEnded&, const TryEnded&) = default;
};
/// The state of the capnograph of the station's patient at a time, which is a fact of its own: with
/// that of the body it would be more than a fact may have.
struct CapnographCheckpoint {
    SessionTime at{};
    CapnographState state;

    friend bool operator==(const CapnographCheckpoint&, const CapnographCheckpoint&) = default;
};
/// The state of the body of the station's patient at a time, without the capnograph. It is the last
/// part of a checkpoint of the patient: before it come the RespirationCheckpoint and the
/// CapnographCheckpoint of the same time.
struct BodyCheckpoint {
    SessionTime at{};
    BodyState state;

    friend bool operator==(const BodyCheckpoint&, const BodyCheckpoint&) = default;
};

} // namespace carina::fact
