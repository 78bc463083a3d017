#pragma once

namespace carina
{

/// What the patient breathes, by the mask or through the tube.
struct GasSupply {
    double inspiredOxygen = 0.21; ///< share of oxygen in the gas that is supplied, 0.21 to 1
    /// A tight mask is held on the face while there is no tube. Without it and without a tube the
    /// patient breathes room air; whether a bag or ventilator reaches the lungs then: reachesLungs.
    bool maskHeld = false;
    bool probeOn = true; ///< the oximeter's probe is on a finger

    friend bool operator==(const GasSupply&, const GasSupply&) = default;
};

} // namespace carina
