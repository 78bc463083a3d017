#pragma once

#include "engine/core/session_time.h"

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <random>
#include <vector>

namespace carina
{

/// One direction of a network path, in virtual time that starts at zero.
///
/// Each datagram is delayed by `delay` and an exponentially distributed queue of mean `jitter`, so
/// that datagrams overtake each other; some are lost and some arrive twice. The same seed and
/// sequence of datagrams give the same delays and losses.
class SimulatedLink
{
public:
    struct Path {
        Duration delay = std::chrono::milliseconds{1};
        Duration jitter{};
        double loss = 0.0;
        double duplication = 0.0;
    };

    SimulatedLink(const Path& path, std::uint32_t seed) : m_path{path}, m_random{seed} {}

    void send(const std::vector<std::byte>& bytes, Duration now)
    {
        ++m_sent;
        m_sentBytes += bytes.size();
        const bool lost = happens(m_path.loss);
        const bool twice = happens(m_path.duplication);
        for (int copy = 0; copy < (twice ? 2 : 1); ++copy) {
            const Duration queue = queueing();
            if (!lost && !m_cut)
                m_underWay.emplace(now + m_path.delay + queue, bytes);
        }
    }

    /// The next datagram that has arrived by now; std::nullopt if there is none.
    std::optional<std::vector<std::byte>> receive(Duration now)
    {
        if (nextArrival() > now)
            return std::nullopt;
        auto first = m_underWay.extract(m_underWay.begin());
        return std::move(first.mapped());
    }

    [[nodiscard]] Duration nextArrival() const
    {
        return m_underWay.empty() ? Duration::max() : m_underWay.begin()->first;
    }

    /// While it is cut, all datagrams are lost: a network partition.
    void setCut(bool cut) { m_cut = cut; }
    void setPath(const Path& path) { m_path = path; }
    [[nodiscard]] const Path& path() const { return m_path; }
    [[nodiscard]] std::size_t sent() const { return m_sent; }
    [[nodiscard]] std::size_t sentBytes() const { return m_sentBytes; }

private:
    // Written out, for the distributions of the standard library differ from one to the next.
    double unit() { return static_cast<double>(m_random()) / 4294967296.0; }
    bool happens(double probability) { return unit() < probability; }
    Duration queueing()
    {
        const double mean = static_cast<double>(m_path.jitter.count());
        return Duration{static_cast<Duration::rep>(-mean * std::log1p(-unit()))};
    }

    Path m_path;
    std::mt19937 m_random;
    bool m_cut = false;
    std::size_t m_sent = 0;
    std::size_t m_sentBytes = 0;
    std::multimap<Duration, std::vector<std::byte>> m_underWay; // by arrival
};

} // namespace carina
