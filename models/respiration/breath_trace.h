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
        std::optional<Airway> airway;
        double autoPeep_cmH2O = 0.0;
        double alveolarVentilation_lPerMin = 0.0; ///< to perfused alveoli
    };

    static constexpr Duration kSampleEvery = std::chrono::milliseconds{20};
    /// After a longer gap the missing samples are skipped.
    static constexpr Duration kLongestGap = std::chrono::seconds{10};

    /// @pre session outlives this.
    BreathTrace(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// std::nullopt before the first complete breath.
    [[nodiscard]] std::optional<Figures> lastBreath() const;

    /// Emits the samples that are due; a timer calls it.
    void sample();

Q_SIGNALS:
    void sampled(const carina::BreathTrace::Sample& sample);

private:
    void take(const RespirationRun& run, SessionTime t);

    SessionModel& m_session;
    StationId m_station;
    RespirationFollower m_breathing;
    std::optional<SessionTime> m_last;
    Volume m_breathBegan; ///< gas in both lungs at the start of the breath
    std::int64_t m_breathSteps = 0;
    BreathFigures m_figures;
    bool m_isVentilated = false;  ///< the breath of the latest sample
    bool m_wasVentilated = false; ///< the last complete breath
};

} // namespace carina
