#pragma once

#include "engine/core/session_time.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

namespace carina
{

/// Types that can be multiplied by a Duration.
template <class T>
concept TimesDuration = requires(T value, Duration time)
{
    value* time;
};

/// The type of a value integrated over time: Duration for bool, a duration of double for double.
template <class T> struct TimeIntegral {
    struct Type {
    };
};
template <TimesDuration T> struct TimeIntegral<T> {
    using Type = decltype(T{} * Duration{});
};

/// A parameter over session time: an initial value, and changes that each hold until the next.
///
/// Changes may be added in any order; of two at the same time the last one added holds. A look-up
/// takes O(log n), a change O(1) when it is the newest and O(n) otherwise.
template <class T> class ParameterTimeline
{
public:
    using Integral = typename TimeIntegral<T>::Type;

    struct Change {
        SessionTime from;
        T value;
        Integral before{}; ///< integral up to `from`
    };

    explicit ParameterTimeline(T initial) : m_initial{initial} {}

    void set(SessionTime from, T value)
    {
        auto place = std::lower_bound(m_changes.begin(), m_changes.end(), from, isEarlier);
        if (place != m_changes.end() && place->from == from)
            place->value = value;
        else
            place = m_changes.insert(place, Change{from, value, {}});
        if constexpr (TimesDuration<T>)
            integrateFrom(place);
    }

    /// Removes the changes at and after a time.
    void forgetFrom(SessionTime from)
    {
        m_changes.erase(std::lower_bound(m_changes.begin(), m_changes.end(), from, isEarlier),
                        m_changes.end());
    }

    /// Removes the changes before a time but the one in force then, so that value and integral are
    /// what they were from that time on. @pre none is added any more that is earlier
    void forgetBefore(SessionTime t)
    {
        const auto next = after(t);
        if (next != m_changes.begin())
            m_changes.erase(m_changes.begin(), std::prev(next));
    }

    [[nodiscard]] T at(SessionTime t) const
    {
        const auto next = after(t);
        return next == m_changes.begin() ? m_initial : std::prev(next)->value;
    }

    /// The integral of the value over time, from the first change to t.
    [[nodiscard]] Integral integral(SessionTime t) const requires TimesDuration<T>
    {
        const auto next = after(t);
        if (next == m_changes.begin())
            return {};
        const Change& inForce = *std::prev(next);
        return inForce.before + inForce.value * (t - inForce.from);
    }

    /// In ascending order of time.
    [[nodiscard]] std::span<const Change> changes() const { return m_changes; }

    /// The time of the first change after t; SessionTime::max() where there is none.
    [[nodiscard]] SessionTime changeAfter(SessionTime t) const
    {
        const auto next = after(t);
        return next == m_changes.end() ? SessionTime::max() : next->from;
    }

private:
    static bool isEarlier(const Change& change, SessionTime t) { return change.from < t; }

    [[nodiscard]] auto after(SessionTime t) const
    {
        return std::upper_bound(m_changes.begin(), m_changes.end(), t,
                                [](SessionTime time, const Change& c) { return time < c.from; });
    }

    void integrateFrom(typename std::vector<Change>::iterator place)
    {
        if (place == m_changes.begin())
            ++place;
        for (; place != m_changes.end(); ++place) {
            const Change& last = *std::prev(place);
            place->before = last.before + last.value * (place->from - last.from);
        }
    }

    T m_initial;
    std::vector<Change> m_changes;
};

} // namespace carina
