#pragma once

#include "engine/session/respiration/respiration_follower.h"
#include "models/session/session_model.h"

#include <optional>

namespace carina
{

/// The waveforms of a ventilator's screen for one station's patient: flow, pressure, volume.
///
/// Sample times are whole multiples of kSampleEvery in session time, so that every console shows
/// the same samples.
class BreathTrace : public QObject
{
    Q_OBJECT

public:
    struct Sample {
        double time_s = 0.0; ///< of the session
        double flow_lPerMin = 0.0;
        double pressure_cmH2O = 0.0; ///< at the airway opening
        double volume_ml = 0.0;      ///< in the lungs, above that at the start of the breath
    };
    /// Of the last complete breath.
    struct Figures {
        double tidalVolume_ml = 0.0;
        double right_ml = 0.0;
        double left_ml = 0.0;
        double rate_perMin = 0.0;
        /// Airway pressures of a ventilated breath; empty for a spontaneous one.
        struct Airway {
            double peak_cmH2O = 0.0;
            double plateau_cmH2O = 0.0;
        };
        std::optional<Airway> airway{};
        double autoPeep_cmH2O = 0.0;
        double alveolarVentilation_lPerMin = 0.0; ///< to perfused alveoli
        /// Functional residual capacity: gas in both lungs at rest, at the end of that breath.
        double functionalResidual_ml = 0.0;
    };
    /// A breath in whole millilitres, of which the sides make the whole.
    struct WholeBreath {
        int tidalVolume_ml = 0;
        int right_ml = 0;
        int left_ml = 0;
    };

    static constexpr Duration kSampleEvery = std::chrono::milliseconds{20};
    /// After a longer gap the missing samples are skipped.
    static constexpr Duration kLongestGap = std::chrono::seconds{10};

    /// @pre session outlives this.
    BreathTrace(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Traces the patient of another station from now on.
    void setStation(StationId station);

    /// Whether nothing breathes: the patient has stopped, and is not ventilated.
    [[nodiscard]] bool hasStopped() const { return m_traced.isStill; }
    /// std::nullopt before the first complete breath, and in apnoea.
    [[nodiscard]] std::optional<Figures> lastBreath() const;

    /// Rounds by the largest remainder: what the sides lack of the whole breath, each rounded down,
    /// goes to the one that lost more.
    [[nodiscard]] static WholeBreath inWhole(const Figures& breath);

    /// Emits the samples that are due; a timer calls it.
    void sample();

Q_SIGNALS:
    void sampled(const carina::BreathTrace::Sample& sample);
    /// The next sample is of another patient.
    void startedAfresh();

private:
    void take(const PatientRun& run, SessionTime t);

    SessionModel& m_session;
    StationId m_station;
    /// What is known of the patient.
    struct Traced {
        RespirationFollower breathing{};
        std::optional<SessionTime> last{};
        Volume breathBegan{}; ///< gas in both lungs at the start of the breath
        std::int64_t breathSteps = 0;
        BreathFigures figures{};
        Volume functionalResidual{};
        bool isStill = false;       ///< no breath at the latest sample
        bool isVentilated = false;  ///< the breath of the latest sample
        bool wasVentilated = false; ///< the last complete breath
    };
    Traced m_traced;
};

} // namespace carina
