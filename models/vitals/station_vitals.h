#pragma once

#include "engine/session/respiration/respiration_follower.h"
#include "models/session/session_model.h"
#include "models/vitals/vitals_model.h"

namespace carina
{

/// The bedside monitor of one station's patient in a session. While the session is paused nothing
/// is measured. A child's breath is heard as loud as that of a grown person who breathes alike
/// (of ours), though the flow of a newborn is a tenth of it.
class StationVitals : public QObject
{
    Q_OBJECT

public:
    using Hears = std::function<std::optional<AuscultationGains>()>;

    /// @pre session outlives this.
    StationVitals(SessionModel& session, StationId station, KeptSounds kept = {},
                  QObject* parent = nullptr);

    /// Watches the patient of another station from now on.
    void setStation(StationId station);
    /// What the stethoscope hears where it is; nothing without one.
    void setStethoscope(Hears hears) { m_hears = std::move(hears); }

    [[nodiscard]] VitalsModel& model() { return m_model; }

private:
    [[nodiscard]] VitalsSources sources();
    [[nodiscard]] const PatientRun* runAt(SessionTime t);
    [[nodiscard]] std::optional<BreathFlows> flowsAt(SessionTime t);
    [[nodiscard]] double decidedAge_years() const;
    void followAge();

    SessionModel& m_session;
    StationId m_station;
    RespirationFollower m_patient;
    Hears m_hears;
    double m_age_years;
    VitalsModel m_model;
};

} // namespace carina
