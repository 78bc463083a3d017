#pragma once

#include "engine/core/session_time.h"

#include <cstddef>
#include <deque>

namespace carina
{

/// The last delays of a path, H_p of the Adaptive Synchronization Algorithm (Hamza-Lup et al.
/// 2004).
///
///     h_mean = (1/p) sum h_i        sigma = sqrt((1/p) sum (h_i - h_mean)^2)
///
/// Both are over the delays stored so far, the newest delay h_0, delays().back(), included; sigma
/// is the population standard deviation (eq. 4).
class DelayHistory
{
public:
    /// p of the paper, as published.
    static constexpr std::size_t kCapacity = 100;

    /// @param capacity p, at least 1
    explicit DelayHistory(std::size_t capacity = kCapacity) : m_capacity{capacity} {}

    void add(Duration delay);
    void clear() { m_delays.clear(); }

    /// Oldest first.
    [[nodiscard]] const std::deque<Duration>& delays() const { return m_delays; }
    [[nodiscard]] std::size_t size() const { return m_delays.size(); }
    [[nodiscard]] bool isFull() const { return m_delays.size() == m_capacity; }
    /// h_mean, in whole nanoseconds. @pre size() > 0
    [[nodiscard]] Duration mean() const;
    /// sigma, to the nearest nanosecond. @pre size() > 0
    [[nodiscard]] Duration sigma() const;

private:
    std::size_t m_capacity;
    std::deque<Duration> m_delays; // the newest last
};

} // namespace carina
