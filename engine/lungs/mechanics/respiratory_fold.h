#pragma once

#include "engine/lungs/mechanics/body_position.h"
#include "engine/lungs/mechanics/breath_clock.h"
#include "engine/lungs/mechanics/breathing_pattern.h"
#include "engine/lungs/mechanics/lung_condition.h"
#include "engine/lungs/mechanics/lung_dynamics.h"
#include "engine/lungs/mechanics/ventilation.h"

#include <array>
#include <cstdint>
#include <optional>

namespace carina
{

/// Everything that people decide about a patient's breathing.
struct RespiratorySettings {
    PatientBuild build;
    LungCondition condition;
    Length tube; ///< inner diameter; 0 without a tube
    BreathingPattern pattern;
    VentilatorSettings ventilator;
    BodyPosition position = BodyPosition::Supine;

    friend bool operator==(const RespiratorySettings&, const RespiratorySettings&) = default;
};

/// The patient's lungs, chest and airway as the settings make them; relaxed where a ventilator
/// alone breathes, which takes none of the resting volume of someone who sits.
[[nodiscard]] RespiratorySystem systemOf(const RespiratorySettings& settings);

/// What one whole breath came to.
struct BreathFigures {
    Volume tidalVolume;                      ///< inspired at the opening
    std::array<Volume, 2> tidalVolumeOfLung; ///< greatest less least gas; right, left
    Frequency rate;                          ///< one over the time it took
    Pressure peak;                           ///< greatest at the opening
    Pressure plateau;                        ///< at the carina as inspiration ended
    Pressure endExpiratory;                  ///< in the alveoli as the next began, mean by bronchi
    Pressure autoPeep;                       ///< of that, above PEEP
    VolumeFlow alveolarVentilation;          ///< less both dead spaces, by the rate

    friend bool operator==(const BreathFigures&, const BreathFigures&) = default;
};

/// The breath that is going on.
struct BreathTally {
    std::int64_t steps = 0;
    Volume inspired;
    std::array<Volume, 2> least;
    std::array<Volume, 2> most;
    Pressure peak;
    Pressure plateau;

    friend bool operator==(const BreathTally&, const BreathTally&) = default;
};

/// Everything that decides how the breathing goes on under given settings: a checkpoint.
struct RespiratoryState {
    std::int64_t steps = 0; ///< since the fold began
    RespiratorySystem system;
    ChestContent content;
    BreathClock::State clock;
    VentilatorState ventilator;
    BreathingPattern breath; ///< in force since the present breath began
    Pressure effort;         ///< greatest of it
    Pressure muscle;         ///< at the end of the last step
    AirwayOpening opening;   ///< in the last step
    BreathTally tally;
    BreathFigures last; ///< the latest whole breath; all 0 before there was one

    friend bool operator==(const RespiratoryState&, const RespiratoryState&) = default;
};

/// Breathes a patient, one step of kRespiratoryStep after another.
///
/// A fold: the same settings, changes and triggers at the same steps give the same state, bit for
/// bit, wherever it is run with the same mathematical library; one made from a checkpoint goes on
/// as the one that wrote it. It reads no clock. What a condition, patient, position or tube changes
/// system comes in over kChangeTime, so that nothing jumps; a tidal volume and an inspiratory
/// fraction hold from the next breath on, the volume as far as largestTidalVolume.
class RespiratoryFold
{
public:
    /// At rest, before a first breath.
    /// @pre every setting is in the range of engine/session/facts/fact_rules.
    explicit RespiratoryFold(const RespiratorySettings& settings);
    RespiratoryFold(const RespiratorySettings& settings, const RespiratoryState& checkpoint);

    /// From the next step on.
    void set(const RespiratorySettings& settings);
    /// A breath of the manikin began so many seconds before the end of the last step.
    void trigger(double secondsAgo) { m_clock.trigger(secondsAgo); }
    void step();

    /// It took a step, or one before its checkpoint did.
    [[nodiscard]] bool hasBegun() const { return m_state.steps > 0; }
    [[nodiscard]] const RespiratorySettings& settings() const { return m_settings; }
    [[nodiscard]] RespiratoryState state() const;
    /// At the end of the last step.
    [[nodiscard]] const ChestMoment& moment() const { return m_moment; }
    [[nodiscard]] const ChestContent& content() const { return m_state.content; }
    [[nodiscard]] const RespiratorySystem& system() const { return m_state.system; }
    [[nodiscard]] const BreathFigures& lastBreath() const { return m_state.last; }
    /// Of the breath that is going on.
    [[nodiscard]] const BreathTally& breath() const { return m_state.tally; }
    [[nodiscard]] Pressure muscle() const { return m_state.muscle; }

private:
    /// With which m_healthy breathes.
    struct FoundEffort {
        BreathingPattern pattern;
        Pressure effort;
    };

    [[nodiscard]] bool isVentilated() const;
    [[nodiscard]] Pressure muscleAt(double breaths) const;
    [[nodiscard]] Pressure relaxedTo(double breaths, double before, double seconds) const;
    [[nodiscard]] bool ventilatorBegins() const;
    [[nodiscard]] bool inspires() const;
    [[nodiscard]] AirwayOpening openingNow() const;
    [[nodiscard]] Pressure effortOfHealth(const BreathingPattern& pattern);
    void beginBreath();
    void tally(const ChestContent& content);

    RespiratorySettings m_settings;
    RespiratorySystem m_target;
    RespiratorySystem m_healthy; ///< the patient in health, in that position
    std::optional<FoundEffort> m_found;
    RespiratoryState m_state; ///< but for the clock's
    BreathClock m_clock;
    ChestMoment m_moment;
};

inline constexpr double kRespiratoryStep = 2e-3; ///< s
inline constexpr double kChangeTime = 2.0;       ///< s, for 63 % of a change of the system
/// How fast the muscle gives up, or takes up, what a change of its effort in mid-breath leaves: a
/// quiet breath's effort in a tenth of a second.
inline constexpr double kMuscleSlew_cmH2OPerS = 100.0;

} // namespace carina
