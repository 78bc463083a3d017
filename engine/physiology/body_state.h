#pragma once

#include "engine/physiology/drug.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace carina
{

/// Shares of the dry gas; the rest is nitrogen.
struct GasShares {
    double oxygen = 0.21;
    double carbonDioxide = 0.0;

    friend bool operator==(const GasShares&, const GasShares&) = default;
};

/// Gas in one lung that takes part in gas exchange, at body temperature and saturated with water.
struct LungGas {
    double oxygen_ml = 0.0;
    double carbonDioxide_ml = 0.0;
    double nitrogen_ml = 0.0;

    friend bool operator==(const LungGas&, const LungGas&) = default;
};

inline constexpr std::size_t kAirwayCells = 16;

/// Gas in both lungs and in the airway between them and the mouth.
struct AirwayGas {
    std::array<LungGas, 2> lungs{};               ///< right, left
    std::array<GasShares, kAirwayCells> airway{}; ///< the dead space, from opening to carina
    double inhaled_ml = 0.0;                      ///< in the present breath
    double exhaled_ml = 0.0;
    double openShare = 1.0; ///< of the lungs' gas that is not behind closed airways
    bool filled = false;    ///< the lungs' gas was taken from the mechanics

    friend bool operator==(const AirwayGas&, const AirwayGas&) = default;
};

/// Oxygen and carbon dioxide in blood and tissues.
struct BloodGas {
    double arterialOxygen_mlPerL = 0.0;
    double venousOxygen_mlPerL = 0.0;
    double restingOxygen_mlPerL = 0.0; ///< of blood that turns over slowly
    double arterialCarbonDioxide_mmHg = 40.0;
    double tissueCarbonDioxide_mmHg = 46.0;
    std::array<double, 2> lungCarbonDioxide_mmHg{40.0, 40.0}; ///< in the tissue of each lung
    std::array<double, 2> constriction{}; ///< hypoxic, of the vessels of each lung, 0 to 1

    friend bool operator==(const BloodGas&, const BloodGas&) = default;
};

inline constexpr std::size_t kSampleLine = 75; ///< body steps from the connector to the sensor

struct CapnographState {
    double connector_mmHg = 0.0; ///< at the place of sampling
    std::array<double, kSampleLine> line{};
    std::int64_t next = 0; ///< the place in `line` that is read and written next
    double sensor_mmHg = 0.0;
    bool inBreath = false;
    bool hasBreath = false;     ///< there was one
    double highest_mmHg = 0.0;  ///< of the present breath
    double lowest_mmHg = 0.0;   ///< since the last one
    double endTidal_mmHg = 0.0; ///< of the last breath
    double rate_perS = 0.0;
    double sinceBreath_s = 0.0; ///< since the last breath began to be exhaled
    double stomach_mmHg = 0.0;  ///< what the next breath from the stomach brings
    double stomachPhase = 0.0;  ///< of the present one, 0 to 1

    friend bool operator==(const CapnographState&, const CapnographState&) = default;
};

inline constexpr std::size_t kWayToFinger = 16; ///< samples of 0.5 s

struct OximeterState {
    std::array<double, kWayToFinger> way{}; ///< saturations on their way to the finger
    std::int64_t steps = 0;                 ///< body steps
    double shown = 0.0;

    friend bool operator==(const OximeterState&, const OximeterState&) = default;
};

struct CirculationState {
    double heartRate_perS = 0.0;
    double mean_mmHg = 0.0;
    double pulse_mmHg = 0.0; ///< systolic less diastolic
    double alarm = 0.0;      ///< response to a stimulus of the airway, 0 to 1
    double accustomed = 0.0; ///< to the stimulus of a tube that stays
    double harm = 0.0;       ///< of the heart by lack of oxygen; it stops at 1
    double beat = 0.0;       ///< phase within the present beat, 0 to 1
    bool arrested = false;

    friend bool operator==(const CirculationState&, const CirculationState&) = default;
};

/// One drug in the body.
struct DrugAmounts {
    double vein_mg = 0.0; ///< injected, and not yet in the central compartment
    double central_mg = 0.0;
    double fast_mg = 0.0;
    double slow_mg = 0.0;
    double effect_mgPerL = 0.0; ///< concentration at the effect site

    friend bool operator==(const DrugAmounts&, const DrugAmounts&) = default;
};

using DrugsInBody = std::array<DrugAmounts, kDrugKinds.size()>; ///< in the order of kDrugKinds

/// The complete state of a BodyFold under given settings: a checkpoint.
struct BodyState {
    std::int64_t steps = 0; ///< since the fold began
    AirwayGas gas;
    BloodGas blood;
    CapnographState capnograph;
    OximeterState oximeter;
    CirculationState circulation;
    DrugsInBody drugs{};
    double spasm = 0.0; ///< of the vocal cords, 0 to 1

    friend bool operator==(const BodyState&, const BodyState&) = default;
};

} // namespace carina
