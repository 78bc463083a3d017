#pragma once

#include "engine/lungs/mechanics/body_position.h"
#include "engine/lungs/mechanics/breath_clock.h"
#include "engine/lungs/mechanics/breathing_pattern.h"
#include "engine/lungs/mechanics/lung_condition.h"
#include "engine/lungs/mechanics/lung_dynamics.h"
#include "engine/lungs/mechanics/ventilation.h"
#include "engine/lungs/mechanics/ventilatory_drive.h"

#include <array>
#include <cstdint>
#include <optional>

namespace carina
{

/// Everything about a patient's breathing that is set by people.
struct RespiratorySettings {
    PatientBuild build;
    LungConditions conditions; ///< that can coexist
    Length tube;               ///< inner diameter; 0 without a tube
    BreathingPattern pattern;
    VentilatorSettings ventilator;
    BodyPosition position = BodyPosition::Supine;
    double ownBreathing = 1.0; ///< share of the patient's own breathing that is left; 0: apnoea
    HandBag bag;
    double cough = 0.0; ///< how hard the patient coughs, as a share of the hardest; 0: not at all

    friend bool operator==(const RespiratorySettings&, const RespiratorySettings&) = default;
};

/// Lungs, chest and airway of a patient with these settings; relaxed (see relax) where only the
/// ventilator breathes. Relaxation takes none of the resting volume of a sitting patient.
[[nodiscard]] RespiratorySystem systemOf(const RespiratorySettings& settings);

/// Measured values of one whole breath.
struct BreathFigures {
    Volume tidalVolume;                      ///< inspired at the airway opening
    std::array<Volume, 2> tidalVolumeOfLung; ///< each lung's part of it; right, left
    Frequency rate;                          ///< reciprocal of its duration
    Pressure peak;                           ///< greatest at the airway opening
    Pressure plateau;                        ///< at the carina at the end of inspiration
    /// Alveolar, at the end of the breath; mean weighted by bronchial conductance.
    Pressure endExpiratory;
    Pressure autoPeep; ///< endExpiratory less PEEP
    /// Tidal volume less anatomical and alveolar dead space, times rate.
    VolumeFlow alveolarVentilation;

    friend bool operator==(const BreathFigures&, const BreathFigures&) = default;
};

/// Running values of the present breath.
struct BreathTally {
    std::int64_t steps = 0;
    Volume inspired;
    std::array<Volume, 2> least; ///< gas in each lung as the breath began
    /// That and what the lung gained while both together inspired.
    std::array<Volume, 2> most;
    Pressure peak;
    Pressure plateau;

    friend bool operator==(const BreathTally&, const BreathTally&) = default;
};

/// The complete state of the fold under given settings: a checkpoint.
struct RespiratoryState {
    std::int64_t steps = 0; ///< since the fold began
    RespiratorySystem system;
    ChestContent content;
    BreathClock::State clock;
    VentilatorState ventilator;
    BreathingPattern breath; ///< in force since the present breath began
    Pressure effort;         ///< peak muscle pressure of the present breath
    Pressure muscle;         ///< at the end of the last step; below 0 in a cough
    AirwayOpening opening;   ///< in the last step
    BreathTally tally;
    BreathFigures last; ///< the latest whole breath; all 0 before the first
    DriveState drive;

    friend bool operator==(const RespiratoryState&, const RespiratoryState&) = default;
};

/// Simulates the breathing of a patient in steps of kRespiratoryStep.
///
/// A fold: the same settings, changes and triggers at the same steps give the same state, bit for
/// bit, wherever it runs with the same mathematical library. A fold made from a checkpoint
/// continues exactly as the one that wrote it. It reads no clock. A change of condition, patient,
/// position or tube is approached exponentially with the time constant kChangeTime, so that no
/// volume jumps. A new tidal volume or inspiratory fraction takes effect with the next breath; the
/// tidal volume is limited to largestTidalVolume.
///
/// The pattern that is set is that of a healthy patient. Where a spontaneous breath brings less
/// alveolar ventilation than it does in health, CO2 accumulates and raises effort and rate, until
/// the muscles tire (ventilatory_drive.h). A set tidal volume that does not exceed the anatomical
/// dead space ventilates nobody: such a patient needs the ventilation of quiet breathing
/// (restingPattern).
///
/// As ownBreathing decreases, rate and effort decrease in proportion, the rate not below
/// kSlowestOwn. At 0 the patient does not breathe: the muscles let go, the present breath is not
/// counted, and there is none until breathing goes on or something ventilates. A bag takes the
/// place of the ventilator while its rate is above 0.
///
/// A patient who coughs does so on top of all that, with or without breath of its own: the
/// expiratory muscles press with coughShare() of kCoughPressure, less in who is weak.
class RespiratoryFold
{
public:
    /// Starts at rest, before the first breath.
    /// @pre every setting is in the range of engine/session/facts/fact_rules.
    explicit RespiratoryFold(const RespiratorySettings& settings);
    RespiratoryFold(const RespiratorySettings& settings, const RespiratoryState& checkpoint);

    /// Settings from the next step on.
    void set(const RespiratorySettings& settings);
    /// A breath of the manikin began `secondsAgo` before the end of the last step.
    void trigger(double secondsAgo) { m_clock.trigger(secondsAgo); }
    void step();

    /// Whether a step was taken, here or before the checkpoint.
    [[nodiscard]] bool hasBegun() const { return m_state.steps > 0; }
    /// Since the fold began, with those before the checkpoint.
    [[nodiscard]] std::int64_t steps() const { return m_state.steps; }
    [[nodiscard]] const RespiratorySettings& settings() const { return m_settings; }
    [[nodiscard]] RespiratoryState state() const;
    /// Pressures and flows at the end of the last step.
    [[nodiscard]] const ChestMoment& moment() const { return m_moment; }
    [[nodiscard]] const ChestContent& content() const { return m_state.content; }
    [[nodiscard]] const RespiratorySystem& system() const { return m_state.system; }
    [[nodiscard]] const BreathFigures& lastBreath() const { return m_state.last; }
    /// Running values of the present breath.
    [[nodiscard]] const BreathTally& breath() const { return m_state.tally; }
    /// Of the inspiratory muscles, less that of the expiratory ones in a cough.
    [[nodiscard]] Pressure muscle() const { return m_state.muscle; }
    /// How far the inspiratory muscles have risen to their peak in the present breath, 0 to 1;
    /// nothing where the patient makes no effort.
    [[nodiscard]] std::optional<double> inspiration() const;
    /// Whether a ventilator or a bag delivers the breaths.
    [[nodiscard]] bool isVentilated() const;
    /// Whether nothing breathes: the patient has stopped, and is not ventilated.
    [[nodiscard]] bool isStill() const;

private:
    /// Result of effortFor with m_healthy, kept for the next breath.
    struct FoundEffort {
        BreathingPattern pattern;
        Pressure effort;
    };

    [[nodiscard]] Pressure muscleAt(double breaths, double seconds) const;
    [[nodiscard]] Pressure relaxedTo(double breaths, double before, double seconds) const;
    [[nodiscard]] bool ventilatorBegins() const;
    [[nodiscard]] bool inspires() const;
    [[nodiscard]] AirwayOpening openingNow() const;
    [[nodiscard]] Pressure effortOfHealth(const BreathingPattern& pattern);
    [[nodiscard]] Frequency ownRate() const;
    [[nodiscard]] BreathingPattern patternAsSet() const;
    [[nodiscard]] VolumeFlow wantedVentilation() const;
    void sumUpBreath();
    void takeDrive(double seconds);
    void beginBreath();
    void beStill();
    void tally(const ChestContent& content);

    RespiratorySettings m_settings;
    VentilatorSettings m_ventilator; ///< in use: that of the settings, or what a bag is
    RespiratorySystem m_target;
    RespiratorySystem m_healthy; ///< without condition, in the set position
    std::optional<FoundEffort> m_found;
    RespiratoryState m_state; ///< its `clock` is not used: m_clock has it
    BreathClock m_clock;
    ChestMoment m_moment;
};

inline constexpr double kRespiratoryStep = 2e-3; ///< s
/// Least rate of a patient whose breathing fails.
inline constexpr Frequency kSlowestOwn = perMinute(4.0);
inline constexpr double kChangeTime = 2.0; ///< s, time constant: 63 % of a change of the system
/// Rate at which the muscle's pressure follows a change of effort within a breath: the effort of a
/// quiet breath in 0.1 s.
inline constexpr double kMuscleSlew_cmH2OPerS = 100.0;

} // namespace carina
