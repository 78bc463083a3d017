#pragma once

#include "engine/net/secure/dtls.h"
#include "engine/net/secure/endpoint.h"

#include <deque>
#include <map>

namespace carina
{

/// The datagrams of a host that have arrived and are not handled yet: those of one source in their
/// order, and of all sources in turn, so that one who sends many delays only its own.
class ArrivalQueue
{
public:
    /// Of one source; the oldest is dropped for a new one, as a full socket would drop it.
    static constexpr std::size_t kMostOfOne = 256;
    /// Of all; for a new one the oldest is dropped of its own source where that has an equal share
    /// of these already, and else of the one that has most.
    static constexpr std::size_t kMost = 4096;
    /// Sources without a path or a handshake that are told apart: a forged one costs nothing.
    static constexpr std::size_t kMostStrangers = 64;

    /// @param isKnown whether there is a path or a handshake with this source
    void add(const Endpoint& from, RawDatagram datagram, bool isKnown);
    /// The next one to be handled; nothing where there is none.
    [[nodiscard]] std::optional<RawDatagram> next();
    [[nodiscard]] bool empty() const { return m_size == 0; }
    void clear();

private:
    struct Source {
        std::deque<RawDatagram> waiting;
        bool isStranger = false;
    };

    /// @pre it is full
    [[nodiscard]] Source& sourceToDropFor(const Endpoint& place);
    void dropOldest(Source& source);

    std::map<Endpoint, Source> m_sources; // each has some waiting
    std::deque<Endpoint> m_turns;         // of these, the next first
    std::size_t m_strangers = 0;
    std::size_t m_size = 0;
};

} // namespace carina
