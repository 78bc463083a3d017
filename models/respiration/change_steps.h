#pragma once

#include "engine/core/ids.h"
#include "models/session/change_history.h"

#include <QPointer>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace carina
{

/// What a person changed about patients and can take back, the last first: each step with what was
/// there before, at each station. Where somebody decided otherwise since, or the host refused the
/// change, there is nothing to take back: taking it back would change what is not theirs.
///
/// @tparam Setting a value at a station: has a member `station`
template <class Setting> class ChangeSteps
{
public:
    struct Step {
        std::size_t thing; ///< which of the patient's quantities
        Setting set;
        std::vector<Setting> before; ///< at each station that was changed
        int number;                  ///< its topic in the history
    };

    /// @param owner whose changes these are, in the history; outlives this
    explicit ChangeSteps(const QObject& owner) : m_owner{owner} {}

    /// Adds the steps to a history from now on, by which alone they are to be taken back.
    void setHistory(ChangeHistory& history) { m_history = &history; }
    [[nodiscard]] bool hasHistory() const { return !m_history.isNull(); }
    /// While what it returns lives, the steps that are added are one change in the history.
    [[nodiscard]] ChangeHistory::Joining joining(const QString& text)
    {
        return {m_history.data(), m_history ? m_history->newJoint(text) : ChangeHistory::Joint{}};
    }
    [[nodiscard]] bool isEmpty() const { return m_steps.empty(); }
    /// @param station where it was set, or kAllStations
    [[nodiscard]] bool lastIsAbout(std::size_t thing, StationId station) const
    {
        return !m_steps.empty() && m_steps.back().thing == thing
               && m_steps.back().set.station == station;
    }

    /// @param of the station of the change as it is told, or kAllStations
    /// @param takeBack sets what was there before; called by the history
    void add(std::size_t thing, const Setting& set, std::vector<Setting> before,
             const QString& text, StationId of, std::function<void(const Step&)> takeBack)
    {
        const int number = ++m_number;
        m_steps.push_back({thing, set, std::move(before), number});
        if (!m_history)
            return;
        m_history->add(
            m_owner, text,
            [this, number, takeBack = std::move(takeBack)] {
                if (const auto step = take(number))
                    takeBack(*step);
            },
            number, of == kAllStations ? kNoStation : of);
    }
    /// The last step goes on to another value, as a slider that is dragged. @pre !isEmpty()
    void goOn(const Setting& set, const QString& text)
    {
        m_steps.back().set = set;
        if (m_history)
            m_history->retitle(m_owner, text);
    }
    [[nodiscard]] std::optional<Step> takeLast()
    {
        return m_steps.empty() ? std::nullopt : take(m_steps.back().number);
    }

    /// Drops the steps that were decided over, at the stations where they were, and those that came
    /// to nothing.
    /// @param isSo (thing, setting): whether this is still what is decided at the setting's
    /// station,
    ///             or on its way. Of a thing only the last step is asked about that came to
    ///             something.
    template <class IsSo> void dropOverruled(const IsSo& isSo)
    {
        std::map<std::pair<std::size_t, StationId>, bool> stands;
        for (auto step = m_steps.rbegin(); step != m_steps.rend(); ++step)
            std::erase_if(step->before, [&](const Setting& at) {
                const auto place = std::pair{step->thing, at.station};
                if (const auto known = stands.find(place); known != stands.end())
                    return !known->second;
                Setting set = step->set;
                set.station = at.station;
                const bool isSet = isSo(step->thing, set);
                const bool cameToNothing = !isSet && isSo(step->thing, at);
                if (!cameToNothing)
                    stands.emplace(place, isSet);
                return !isSet;
            });
        std::erase_if(m_steps, [this](const Step& step) {
            if (step.before.empty() && m_history)
                m_history->forget(m_owner, step.number);
            return step.before.empty();
        });
    }

private:
    [[nodiscard]] std::optional<Step> take(int number)
    {
        const auto step = std::ranges::find(m_steps, number, &Step::number);
        if (step == m_steps.end())
            return std::nullopt;
        Step taken = std::move(*step);
        m_steps.erase(step);
        return taken;
    }

    const QObject& m_owner;
    QPointer<ChangeHistory> m_history;
    std::vector<Step> m_steps;
    int m_number = 0;
};

} // namespace carina
