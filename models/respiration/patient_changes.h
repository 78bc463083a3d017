#pragma once

#include "models/respiration/addressed_stations.h"
#include "models/respiration/change_steps.h"
#include "models/session/session_model.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace carina
{

/// What a person changes about the patients of a session: quantities that follow from facts.
///
/// A change is sent to every site before it takes effect. While one of a quantity is under way,
/// only the latest further one is kept, so that dragging a slider does not flood the session with
/// facts. Each can be taken back, the last first (ChangeSteps); a drag is one change.
///
/// @tparam Value of a quantity
/// @tparam kThings how many quantities there are, numbered from 0
template <class Value, std::size_t kThings> class PatientChanges
{
public:
    /// A value for a station, or for all.
    struct Setting {
        StationId station;
        Value value;
        Duration over{}; ///< how long it takes to come, of a quantity that has that
    };
    /// How the quantities are decided.
    struct Quantities {
        /// What is decided for a time at a station.
        std::function<Value(StationId station, std::size_t thing, SessionTime t)> decidedAt;
        std::function<void(std::size_t thing, const Setting& setting)> propose;
        /// Of a change, in a history: "Position → Prone".
        std::function<QString(std::size_t thing, const Value& value)> textOf;
        /// Called when a value was requested.
        std::function<void()> requested;
        /// How long what is decided last takes to come in all, while it is coming; for quantities
        /// that have that.
        std::function<std::optional<Duration>(StationId station, std::size_t thing)> comesOver{};
        /// The second is what was asked for.
        std::function<bool(const Value&, const Value&)> isSame = std::equal_to<Value>{};
    };

    /// @param owner whose changes these are, in a history
    /// @pre session and owner outlive this.
    PatientChanges(const SessionModel& session, StationId station, const QObject& owner,
                   Quantities quantities)
        : m_session{session},
          m_stations{station},
          m_quantities{std::move(quantities)},
          m_steps{owner}
    {
    }
    PatientChanges(const PatientChanges&) = delete;
    PatientChanges& operator=(const PatientChanges&) = delete;

    /// Adds the changes to a history from now on, by which alone they are to be taken back.
    void setHistory(ChangeHistory& history) { m_steps.setHistory(history); }
    [[nodiscard]] bool hasHistory() const { return m_steps.hasHistory(); }

    [[nodiscard]] const AddressedStations& stations() const { return m_stations; }
    void setForAll(bool all) { m_stations.all = all; }
    /// What waits at the former station goes now, and is taken back there.
    /// @returns whether it is another station
    bool setStation(StationId station)
    {
        if (std::exchange(m_stations.shown, station) == station)
            return false;
        for (std::size_t thing = 0; thing < kThings; ++thing)
            if (const auto& latest = m_wishes[thing].latest)
                m_quantities.propose(thing, *latest);
        m_wishes = {};
        return true;
    }

    /// What was requested at the shown station, or at all, and is not in force yet.
    [[nodiscard]] const std::optional<Setting>& pending(std::size_t thing) const
    {
        const Wish& wish = m_wishes[thing];
        return wish.latest ? wish.latest : wish.sent;
    }
    [[nodiscard]] Value inForce(std::size_t thing) const
    {
        const SessionTime now = m_session.node().now().value_or(SessionTime{});
        return m_quantities.decidedAt(m_stations.shown, thing, now);
    }
    /// The value requested or, if no change is pending, in force.
    [[nodiscard]] Value shown(std::size_t thing) const
    {
        const std::optional<Setting>& wanted = pending(thing);
        return wanted ? wanted->value : inForce(thing);
    }

    /// As it is to become at a station: what is under way, else what is decided last.
    [[nodiscard]] Value wantedAt(StationId station, std::size_t thing) const
    {
        const Setting* wish = pendingAt(station, thing);
        return wish ? wish->value : last(station, thing);
    }

    /// Nothing where it is so already. Where it is still coming, over another time, it comes over
    /// this one from now on, and there is nothing more to take back.
    void set(std::size_t thing, const Value& value, Duration over = {})
    {
        const StationId target = m_stations.target();
        change(thing, replacedBy(thing), {target, value, over}, target);
    }
    /// At each addressed station what follows from what is wanted there; one step in a history.
    void setEach(std::size_t thing, const std::function<Value(const Value&)>& from, Duration over,
                 const QString& text)
    {
        const std::vector<Setting> before = replacedBy(thing);
        if (before.size() == 1) {
            const Setting& at = before.front();
            change(thing, before, {at.station, from(at.value), over}, at.station);
            return;
        }
        const ChangeHistory::Joining joining = m_steps.joining(text);
        for (const Setting& at : before)
            change(thing, {at}, {at.station, from(at.value), over}, kAllStations);
    }
    [[nodiscard]] bool canUndo() const { return !m_steps.isEmpty(); }
    /// Sets the quantity changed last to what it was, at each station where nobody decided
    /// otherwise since; at once, also where the change was one over a time.
    void undo()
    {
        if (const auto step = m_steps.takeLast())
            goBackTo(step->thing, step->before);
    }

    /// Sends what waits once the one before is in force or was not taken, and drops what can no
    /// longer be taken back. To be called when facts come, and often enough to see them take
    /// effect, which nothing signals.
    void follow()
    {
        for (std::size_t thing = 0; thing < kThings; ++thing) {
            Wish& wish = m_wishes[thing];
            if (!wish.sent || isUnderWay(thing, wish.sent->value))
                continue;
            wish.sent.reset();
            if (const auto next = std::exchange(wish.latest, std::nullopt))
                ask(thing, *next);
        }
        if (m_session.node().pending().empty())
            m_steps.dropOverruled([this](std::size_t thing, const Setting& at) {
                return m_wishes[thing].sent.has_value() || isDecided(at.station, thing, at.value);
            });
    }

private:
    /// The requested values of one quantity.
    struct Wish {
        std::optional<Setting> sent;   ///< proposed, not in force yet
        std::optional<Setting> latest; ///< to be proposed once `sent` is in force
    };

    [[nodiscard]] bool isSame(const Value& a, const Value& asked) const
    {
        return m_quantities.isSame(a, asked);
    }
    /// As it is once all has taken effect.
    [[nodiscard]] Value last(StationId station, std::size_t thing) const
    {
        return m_quantities.decidedAt(station, thing, SessionTime::max());
    }
    [[nodiscard]] const Setting* pendingAt(StationId station, std::size_t thing) const
    {
        const std::optional<Setting>& wish = pending(thing);
        return wish && (wish->station == station || wish->station == kAllStations) ? &*wish
                                                                                   : nullptr;
    }
    /// What a change would replace, at the shown station also what is under way.
    [[nodiscard]] std::vector<Setting> replacedBy(std::size_t thing) const
    {
        std::vector<Setting> settings;
        for (const StationId id : stationsOf(*m_session.node().state(), m_stations.target()))
            settings.push_back(
                {id, id == m_stations.shown ? shown(thing) : wantedAt(id, thing), {}});
        return settings;
    }
    /// @param of kAllStations for a part of a change at several
    void change(std::size_t thing, const std::vector<Setting>& before, const Setting& wanted,
                StationId of)
    {
        const auto isSo = [&](const Setting& at) { return isSame(at.value, wanted.value); };
        if (!std::ranges::all_of(before, isSo))
            addStep(thing, before, wanted, of);
        else if (!comesOtherwise(thing, before, wanted.over))
            return;
        if (wanted.station == m_stations.shown || wanted.station == kAllStations)
            ask(thing, wanted);
        else
            m_quantities.propose(thing, wanted);
    }
    void addStep(std::size_t thing, const std::vector<Setting>& before, const Setting& wanted,
                 StationId of)
    {
        const QString text = m_quantities.textOf(thing, wanted.value);
        if (pending(thing) && m_steps.lastIsAbout(thing, wanted.station))
            m_steps.goOn(wanted, text);
        else
            m_steps.add(thing, wanted, before, text, of,
                        [this](const auto& step) { goBackTo(step.thing, step.before); });
    }
    /// Whether what is wanted there is still to come, over another time.
    [[nodiscard]] bool comesOtherwise(std::size_t thing, const std::vector<Setting>& there,
                                      Duration over) const
    {
        return m_quantities.comesOver && std::ranges::any_of(there, [&](const Setting& at) {
                   if (const Setting* wish = pendingAt(at.station, thing))
                       return wish->over != over;
                   const auto comes = m_quantities.comesOver(at.station, thing);
                   return comes && *comes != over;
               });
    }
    void goBackTo(std::size_t thing, const std::vector<Setting>& before)
    {
        for (const Setting& at : before)
            if (at.station == m_stations.shown)
                ask(thing, at);
            else
                m_quantities.propose(thing, at);
    }
    void ask(std::size_t thing, const Setting& setting)
    {
        Wish& wish = m_wishes[thing];
        if (wish.sent) {
            wish.latest = setting;
        } else {
            wish.sent = setting;
            m_quantities.propose(thing, setting);
        }
        m_quantities.requested();
    }
    [[nodiscard]] bool isUnderWay(std::size_t thing, const Value& sent) const
    {
        if (isSame(inForce(thing), sent))
            return false;
        if (!m_session.node().pending().empty())
            return true; // the host has not answered yet
        // Decided for later, unless the host refused it or somebody decided otherwise since.
        return isSame(last(m_stations.shown, thing), sent);
    }
    [[nodiscard]] bool isDecided(StationId station, std::size_t thing, const Value& value) const
    {
        return m_session.node().state()->isOpen(station) && isSame(last(station, thing), value);
    }

    const SessionModel& m_session;
    AddressedStations m_stations;
    Quantities m_quantities;
    std::array<Wish, kThings> m_wishes;
    ChangeSteps<Setting> m_steps;
};

} // namespace carina
