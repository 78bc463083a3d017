#pragma once

#include "engine/session/airway/airway_rules.h"
#include "models/respiration/patient_changes.h"
#include "models/session/obstacle_to_change.h"
#include "models/session/session_model.h"

namespace carina
{

/// How head and neck of one station's patient lie, as an instructor sees and changes it.
///
/// A change is sent to every site before it takes effect; until then the getters already return it
/// and `travellingText` tells it. Only instructors can change anything; what others set is ignored.
class HeadPositionModel : public QObject
{
    Q_OBJECT

public:
    /// @pre session outlives this.
    HeadPositionModel(SessionModel& session, StationId station, QObject* parent = nullptr);

    /// Shows the patient of another station from now on. What was changed before is undone where it
    /// was changed.
    void setStation(StationId station);
    /// Adds its changes to a history from now on, by which alone they are to be undone.
    void setHistory(ChangeHistory& history) { m_changes.setHistory(history); }
    /// Whether a change is for the patients of all open stations, by one fact with one effect time.
    void setForAll(bool all) { m_changes.setForAll(all); }

    /// What was set: requested or, if no change is pending, decided.
    [[nodiscard]] HeadPosition position() const { return m_changes.shown(kHead); }
    /// How they are to be seen now, while that changes, and as far as a stiff neck lets them.
    [[nodiscard]] HeadPosition present() const;
    /// Whether they are to be seen in neutral position.
    [[nodiscard]] bool isNeutral() const { return present() == HeadPosition{}; }

    /// @pre within the range that is drawn (withinReach)
    void setPosition(const HeadPosition& position);
    /// The time over which the position changes, from the next change on; at once at first.
    /// @pre 0 to kLongestAirwayChange
    void setChangeTime(Duration over) { m_over = over; }

    /// As they are to be seen now: "neck 35° flexed, head 24° extended".
    [[nodiscard]] QString inForceText() const;
    /// The pending change: "Head position → Sniffing: neck 35° flexed, head 24° extended"; empty if
    /// there is none.
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
    using Changes = PatientChanges<HeadPosition, 1>;
    static constexpr std::size_t kHead = 0;

    struct Shown {
        HeadPosition set;
        HeadPosition present;
        bool isPending = false;
        QString obstacle;
        bool canUndo = false;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    [[nodiscard]] Changes::Quantities quantities();
    [[nodiscard]] static QString textOf(const HeadPosition& position);
    void refresh();

    SessionModel& m_session;
    Changes m_changes;
    Duration m_over{};
    Shown m_shown; ///< at the latest changed()
};

} // namespace carina
