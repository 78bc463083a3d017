#pragma once

#include "models/respiration/patient_changes.h"
#include "models/session/obstacle_to_change.h"
#include "models/session/session_model.h"

#include <optional>
#include <utility>

namespace carina
{

/// What is decided about the patient of one station and comes over a time, as an instructor sees
/// and changes it: what of that does not depend on its values (GradualDecisionOf).
class GradualDecision : public QObject
{
    Q_OBJECT

public:
    /// The time over which it changes, from the next change on; at once at first.
    /// @pre 0 to kLongestAirwayChange
    void setChangeTime(Duration over) { m_over = over; }
    /// One sentence: why this person cannot change anything; empty if they can.
    [[nodiscard]] QString obstacle() const { return obstacleToChange(m_session); }

Q_SIGNALS:
    /// Anything that is told here changed.
    void changed();

protected:
    /// @pre session outlives this.
    GradualDecision(SessionModel& session, QObject* parent);

    /// Looks for what changed. Called when facts come, and often enough to see them take effect.
    virtual void refresh() = 0;

    [[nodiscard]] SessionModel& session() const { return m_session; }
    [[nodiscard]] Duration over() const { return m_over; }

private:
    SessionModel& m_session;
    Duration m_over{};
};

/// One quantity of that kind.
///
/// A change is sent to every site before it takes effect; until then the getters already return it
/// and `travellingText` tells it. While one change is pending, only the latest further one is kept,
/// so that dragging does not flood the session with facts. Only instructors can change anything;
/// what others set is ignored.
template <class Value> class GradualDecisionOf : public GradualDecision
{
public:
    /// Shows the patient of another station from now on. What was changed before is undone where it
    /// was changed.
    void setStation(StationId station)
    {
        if (!m_changes.setStation(station))
            return;
        refresh();
        Q_EMIT changed();
    }
    /// Adds its changes to a history from now on, by which alone they are to be undone.
    void setHistory(ChangeHistory& history) { m_changes.setHistory(history); }

    /// The pending change: "Airway → Laryngospasm 100 %"; empty if there is none.
    [[nodiscard]] QString travellingText() const
    {
        const auto& pending = m_changes.pending(kOnly);
        return pending ? m_kind.textOf(pending->value) : QString{};
    }

    [[nodiscard]] bool canUndo() const { return m_changes.canUndo(); }
    /// Reverts the last change, at each station where nobody decided otherwise since; at once, also
    /// where it was one over a time.
    void undo() { m_changes.undo(); }

protected:
    /// How it is decided and told.
    struct Kind {
        /// What is decided for a time.
        Value (*decidedAt)(const Station& station, SessionTime t);
        /// What is to be seen then, while that changes.
        Value (*presentAt)(const Station& station, SessionTime t);
        /// How long what is decided for a time takes to come in all.
        Duration (*overAt)(const Station& station, SessionTime t);
        FactBody (*factOf)(const Value& value, Duration over);
        QString (*textOf)(const Value& value);
    };

    GradualDecisionOf(SessionModel& session, StationId station, const Kind& kind, QObject* parent)
        : GradualDecision{session, parent},
          m_kind{kind},
          m_changes{session, station, *this, quantities()}
    {
    }

    [[nodiscard]] const AddressedStations& stations() const { return m_changes.stations(); }
    void setAddressed(bool all) { m_changes.setForAll(all); }
    /// Requested or, if no change is pending, decided.
    [[nodiscard]] Value decided() const { return m_changes.shown(kOnly); }
    /// As it is to become at a station.
    [[nodiscard]] Value wantedAt(StationId id) const { return m_changes.wantedAt(id, kOnly); }
    [[nodiscard]] Value presentValue() const { return presentValueAt(stations().shown); }
    [[nodiscard]] Value presentValueAt(StationId id) const
    {
        const SessionTime now = session().node().now().value_or(SessionTime{});
        return at(id, m_kind.presentAt, now);
    }
    void request(const Value& value) { request(value, over()); }
    void request(const Value& value, Duration over)
    {
        if (obstacle().isEmpty())
            m_changes.set(kOnly, value, over);
    }
    /// At each addressed station what follows from what is wanted there, as one change.
    /// @param text of the change at several stations, in a history
    void requestEach(Value (*from)(const Value&), Duration over, const QString& text)
    {
        if (obstacle().isEmpty())
            m_changes.setEach(kOnly, from, over, text);
    }
    /// Looks for what else is told. @returns whether that changed
    virtual bool refreshMore() { return false; }

    void refresh() final
    {
        m_changes.follow();
        const bool isMore = refreshMore();
        const Shown now{decided(), presentValue(), m_changes.pending(kOnly).has_value(), obstacle(),
                        canUndo()};
        if (std::exchange(m_shown, now) != now || isMore)
            Q_EMIT changed();
    }

private:
    using Changes = PatientChanges<Value, 1>;
    static constexpr std::size_t kOnly = 0;

    struct Shown {
        Value decided{};
        Value present{};
        bool isPending = false;
        QString obstacle;
        bool canUndo = false;

        friend bool operator==(const Shown&, const Shown&) = default;
    };

    template <class Told>
    [[nodiscard]] Told at(StationId id, Told (*toldAt)(const Station&, SessionTime),
                          SessionTime t) const
    {
        const auto state = session().node().state();
        const auto station = state->stations().find(id);
        return station == state->stations().end() ? Told{} : toldAt(station->second, t);
    }
    [[nodiscard]] typename Changes::Quantities quantities()
    {
        return {.decidedAt = [this](StationId id, std::size_t /*only*/,
                                    SessionTime t) { return at(id, m_kind.decidedAt, t); },
                .propose =
                    [this](std::size_t /*only*/, const typename Changes::Setting& setting) {
                        session().node().propose(setting.station,
                                                 m_kind.factOf(setting.value, setting.over));
                    },
                .textOf = [this](std::size_t /*only*/,
                                 const Value& value) { return m_kind.textOf(value); },
                .requested = [this] { Q_EMIT changed(); },
                .comesOver = [this](StationId id, std::size_t /*only*/) -> std::optional<Duration> {
                    constexpr SessionTime kLast = SessionTime::max();
                    if (presentValueAt(id) == at(id, m_kind.decidedAt, kLast))
                        return std::nullopt;
                    return at(id, m_kind.overAt, kLast);
                }};
    }

    Kind m_kind;
    Changes m_changes;
    Shown m_shown; ///< at the latest changed()
};

} // namespace carina
