#pragma once

#include "engine/session/respiration/respiration_follower.h"
#include "models/session/session_model.h"

#include <optional>

namespace carina
{

/// What a ventilator's screen shows of one station's patient, sample by sample.
///
/// Samples are of whole multiples of kSampleEvery of the session time, so that every console shows
/// the same ones.
class BreathTrace : public QObject
{
    Q_OBJECT

public:
    struct Sample {
        double time_s = 0.0; ///< of the session
        double flow_lPerMin = 0.0;
        double pressure_cmH2O = 0.0; ///< at the airway's opening
        double volume_ml = 0.0;      ///< in the lungs, above that at the beginning of the breath
    };
    /// Of the last whole breath.
    struct Figures {
        double tidalVolume_ml = 0.0;
        double right_ml = 0.0;
        double left_ml = 0.0;
        double rate_perMin = 0.0;
        /// At the airway, in a breath of a ventilator; nothing where nobody pushes.
        struct Airway {
            double peak_cmH2O = 0.0;
            double plateau_cmH2O = 0.0;
        };
        std::optional<Airway> airway;
        double autoPeep_cmH2O = 0.0;
        double alveolarVentilation_lPerMin = 0.0; ///< that reaches alveoli with blood
    };

    static constexpr Duration kSampleEvery = std::chrono::milliseconds{20};
    /// Further back nothing is made good.
    static constexpr Duration kLongestGap = std::chrono::seconds{10};

    /// @pre session outlives this.
    BreathTrace(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Nothing before there was a whole breath.
    [[nodiscard]] std::optional<Figures> lastBreath() const;

    /// Takes the samples that are due.
    void sample();

Q_SIGNALS:
    void sampled(const carina::BreathTrace::Sample& sample);

private:
    void take(const RespirationRun& run, SessionTime t);

    SessionModel& m_session;
    StationId m_station;
    RespirationFollower m_breathing;
    std::optional<SessionTime> m_last;
    Volume m_breathBegan; ///< gas in both lungs as it did
    std::int64_t m_breathSteps = 0;
    BreathFigures m_figures;
    bool m_isVentilated = false;  ///< the breath at the latest sample
    bool m_wasVentilated = false; ///< the last whole breath
};

} // namespace carina
