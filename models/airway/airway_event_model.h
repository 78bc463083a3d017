#pragma once

#include "engine/session/airway/airway_rules.h"
#include "models/airway/airway_limits.h"
#include "models/respiration/patient_changes.h"
#include "models/session/obstacle_to_change.h"
#include "models/session/session_model.h"

#include <QPointer>

#include <optional>
#include <string>

namespace carina
{

class SessionPatient;

/// The events of one station's airway, as an instructor sees and changes them.
///
/// A change is sent to every site before it takes effect; until then the getters already return it
/// and `travellingText` tells it. While one change is pending, only the latest further one is kept,
/// so that dragging a severity does not flood the session with facts. Only instructors can change
/// anything; what others set is ignored.
class AirwayEventModel : public QObject
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    AirwayEventModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Shows the patient of another station from now on. What was changed before is undone where it
    /// was changed.
    void setStation(StationId station);
    /// Adds its changes to a history from now on, by which alone they are to be undone.
    void setHistory(ChangeHistory& history) { m_changes.setHistory(history); }
    /// Whether a change is for the patients of all open stations, by one fact with one effect time.
    void setForAll(bool all);
    /// Tells from now on also what the patient cannot show that lies at the station, as soon as it
    /// is known which one does.
    void setPatient(const SessionPatient& patient);

    /// The severity that was set: requested or, if no change is pending, decided; 0 without one.
    [[nodiscard]] double severity(AirwayEventKind kind) const;
    /// The severity that is to be seen now, while it changes.
    [[nodiscard]] double present(AirwayEventKind kind) const;
    /// All that was set likewise, without those of severity 0.
    [[nodiscard]] AirwayEvents events() const { return m_changes.shown(kAirway); }
    /// Whether nothing is set.
    [[nodiscard]] bool isClear() const { return events().empty(); }
    /// What the patient of the station cannot show of it; nothing while the patient is not known.
    [[nodiscard]] const AirwayLimits& limits() const { return m_limits; }
    /// Whether there is anything to set: an event that the patient shows, or one to be ended, or
    /// one of other patients too.
    [[nodiscard]] bool canBeSet(AirwayEventKind kind) const;

    /// Sets the severity of one event, 0 to 1, and leaves the others as they are set.
    void setSeverity(AirwayEventKind kind, double severity);
    /// Sets all events at once, as one change; what is not among them ends. @pre areProper(events)
    void setEvents(const AirwayEvents& events);
    /// Sets no event at all.
    void clear() { setEvents({}); }
    /// The time over which severities change, from the next change on; at once at first.
    /// @pre 0 to kLongestAirwayChange
    void setChangeTime(Duration over) { m_over = over; }

    /// The events to be seen now: "Tongue oedema 60 %"; "Clear".
    [[nodiscard]] QString inForceText() const;
    /// The pending change: "Airway → Laryngospasm 100 %"; empty if there is none.
    [[nodiscard]] QString travellingText() const;
    /// One sentence: why this person cannot change anything; empty if they can.
    [[nodiscard]] QString obstacle() const { return obstacleToChange(m_session); }

    [[nodiscard]] bool canUndo() const { return m_changes.canUndo(); }
    /// Reverts the last change, at each station where nobody decided otherwise since; at once, also
    /// where it was one over a time.
    void undo() { m_changes.undo(); }

Q_SIGNALS:
    /// Anything of the above changed.
    void changed();

private:
    /// The airway is one thing of the patient, whichever of its events is changed.
    using Changes = PatientChanges<AirwayEvents, 1>;
    static constexpr std::size_t kAirway = 0;

    struct Shown {
        AirwayEvents set;
        AirwayEvents present;
        bool isPending = false;
        QString obstacle;
        bool canUndo = false;
        AirwayLimits limits;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    [[nodiscard]] Changes::Quantities quantities();
    [[nodiscard]] AirwayEvents presentEvents() const;
    [[nodiscard]] static QString textOf(const AirwayEvents& events);
    void lookAtPatient();
    void refresh();

    SessionModel& m_session;
    Changes m_changes;
    Duration m_over{};
    QPointer<const SessionPatient> m_patient;
    AirwayLimits m_limits;
    std::optional<std::string> m_limitsOf; ///< content hash of the patient whose they are
    Shown m_shown;                         ///< at the latest changed()
};

} // namespace carina
