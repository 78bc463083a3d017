#pragma once

#include "engine/session/airway/airway_rules.h"
#include "models/airway/gradual_decision.h"
#include "models/patient/patient_source.h"

#include <QPointer>

namespace carina
{

class SessionPatient;

/// How head and neck of one station's patient lie.
class HeadPositionModel : public GradualDecisionOf<HeadPosition>
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    HeadPositionModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Whether a change is for the patients of all open stations, by one fact with one effect time.
    void setForAll(bool all) { setAddressed(all); }
    /// Tells from now on how the patient is drawn that lies at the station, as soon as it is known
    /// which one does: an infant's neck flexes less (withinReach).
    void setPatient(const SessionPatient& patient);

    /// What was set: requested or, if no change is pending, decided.
    [[nodiscard]] HeadPosition position() const { return decided(); }
    /// How they are drawn now: while that changes, and as far as a stiff neck and the patient's
    /// size let them.
    [[nodiscard]] HeadPosition present() const;
    /// Whether they are to be seen in neutral position.
    [[nodiscard]] bool isNeutral() const { return present() == HeadPosition{}; }

    /// @pre within the range that is drawn (withinReach)
    void setPosition(const HeadPosition& position);

    /// As they are drawn now: "neck 35° flexed, head 24° extended"; with limitText in brackets,
    /// where there is one.
    [[nodiscard]] QString inForceText() const;
    /// "this patient's neck flexes no farther" where its size is what stops it; else empty.
    [[nodiscard]] QString limitText() const;

private:
    [[nodiscard]] static Kind howDecided();
    /// Which patient lies at the station.
    [[nodiscard]] bool refreshMore() override;

    QPointer<const SessionPatient> m_patient;
    SharedPatientModel m_lying; ///< null while it is not known
};

} // namespace carina
