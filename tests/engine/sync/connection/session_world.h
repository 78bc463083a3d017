#pragma once

#include "engine/sync/connection/sync_client.h"
#include "engine/sync/connection/sync_host.h"
#include "tests/support/simulated_link.h"

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace carina
{

/// A machine's clock against the virtual time of a SessionWorld.
struct SimulatedClock {
    Duration offset{};
    int skewPpm = 0;

    [[nodiscard]] LocalTime at(Duration t) const
    {
        return LocalTime{offset + t + t / 1'000'000 * skewPpm};
    }
    /// The first virtual time at which the clock shows at least `local`, to a microsecond.
    [[nodiscard]] Duration when(LocalTime local) const
    {
        const Duration reading = local.time_since_epoch() - offset;
        return reading - reading / 1'000'000 * skewPpm + std::chrono::microseconds{1};
    }
};

/// The smallest session behind a host: its disk, and rules that number what comes.
///
/// A proposal's body is a letter and text. 'J' joins by name; 'X' is refused; "T<epoch> <owner>"
/// gives the one object to another owner, if that epoch is its ownership's; anything else goes in.
struct TestSession {
    SyncHost* host = nullptr; ///< whose session it is
    std::vector<FactRecord> disk;
    bool isFast = true; ///< the disk: otherwise the test appends to the host's log
    std::vector<std::pair<ParticipantId, LocalTime>> departures;
    std::vector<Leave> reasons;        ///< of these
    std::set<ParticipantId> observers; ///< who may not act
    bool areProven = true;             ///< whether each proves by a secret who it is
    PeerLimits limits{1e4, 1e7, 1e4, 1e4, 1e4, 1e4, 1e4};
    Ownership ownership{kNobody, 1};           ///< of the one object
    StationId station;                         ///< where everybody is
    std::map<ParticipantId, StationId> places; ///< but those
    std::set<ParticipantId> watchers;          ///< of the streams of all stations
    ParticipantId worker = kNobody;            ///< whose streams come first
    std::shared_ptr<SharedBudget> shared;      ///< by all, if there is one
    mutable int lookUps = 0;                   ///< of whether a proposal is settled

    [[nodiscard]] static std::vector<std::byte> body(const std::string& text)
    {
        const auto bytes = std::as_bytes(std::span{text});
        return {bytes.begin(), bytes.end()};
    }
    [[nodiscard]] bool isSettled(ProposalId id) const
    {
        ++lookUps;
        return std::ranges::find(disk, id, &FactRecord::proposal) != disk.end();
    }
    [[nodiscard]] Result<void> decide(const ProposalRecord& proposal)
    {
        if (proposal.body.front() == std::byte{'X'})
            return fail(Errc::OutOfRange);
        if (const auto next = handedOver(proposal.body)) {
            if (next->epoch != ownership.epoch + 1)
                return fail(Errc::OwnerChanged);
            ownership = *next;
        }
        disk.push_back({FactNumber{disk.size() + 1}, proposal.id, proposal.author, proposal.station,
                        SessionTime{}, SessionTime{}, proposal.body});
        if (isFast)
            host->append(disk.back());
        return {};
    }
    /// The ownership that a fact begins, if it is such a fact.
    [[nodiscard]] static std::optional<Ownership> handedOver(const std::vector<std::byte>& body)
    {
        if (body.front() != std::byte{'T'})
            return std::nullopt;
        std::istringstream text{{reinterpret_cast<const char*>(body.data()) + 1, body.size() - 1}};
        Ownership next;
        text >> next.epoch >> next.owner.value;
        ++next.epoch;
        return next;
    }
    /// The first to come with a name has the number of that fact.
    [[nodiscard]] Result<ParticipantId> identify(const ProposalRecord& join) const
    {
        if (join.body.front() != std::byte{'J'})
            return fail(Errc::NotPermitted);
        const auto first = std::ranges::find(disk, join.body, &FactRecord::body);
        return ParticipantId{static_cast<std::uint16_t>(first - disk.begin() + 1)};
    }
    [[nodiscard]] Result<Admission> admit(const ProposalRecord& join)
    {
        const auto participant = identify(join);
        if (!isSettled(join.id))
            static_cast<void>(decide(join));
        const auto fact = std::ranges::find(disk, join.id, &FactRecord::proposal);
        return Admission{*participant, fact->number};
    }
    [[nodiscard]] HostRules rules()
    {
        return {
            [this](const Hello& hello, LocalTime) {
                return identify(hello.join).map([this](ParticipantId id) {
                    return Identity{id, areProven};
                });
            },
            [this](const Hello& hello, LocalTime) { return admit(hello.join); },
            [this](ProposalId id) { return isSettled(id); },
            [this](const ProposalRecord& proposal, LocalTime) { return decide(proposal); },
            [this](ParticipantId who, Leave why, LocalTime when) {
                departures.emplace_back(who, when);
                reasons.push_back(why);
            },
            [this](ParticipantId who) { return !observers.contains(who); },
            [this](ParticipantId) { return limits; },
            [this](ParticipantId who) { return places.contains(who) ? places.at(who) : station; },
            [this](PeerAddress) { return shared; },
            [this](ParticipantId who) { return watchers.contains(who); },
            [this](ParticipantId who) { return who == worker; }};
    }
};

/// A host and clients in virtual time, each with a clock of its own, joined by simulated links.
class SessionWorld
{
public:
    struct Site {
        SimulatedClock clock;
        PeerAddress address = 0;
        SimulatedLink toHost;
        SimulatedLink fromHost;
        std::unique_ptr<SyncClient> client;
        std::vector<FactRecord> log;
        std::vector<StreamSample> streams;
        std::vector<RefusedProposal> refused;
        std::vector<ShownPose> shown;
        int timesStartedAfresh = 0;
    };

    static constexpr Duration kSessionOffset = std::chrono::hours{1000};

    explicit SessionWorld(std::uint32_t seed) : m_random{seed} { startHost(); }

    void startHost(std::byte sessionTag = std::byte{1})
    {
        SessionKey key{};
        key.front() = sessionTag;
        m_host = std::make_unique<SyncHost>(key, session.disk, kSessionOffset, session.rules());
        session.host = m_host.get();
    }
    /// As by kill -9: what is on disk stays.
    void crashHost() { m_host.reset(); }
    [[nodiscard]] SyncHost& host() { return *m_host; }

    std::size_t addSite(const SimulatedLink::Path& path, const SimulatedClock& clock = {})
    {
        m_sites.push_back(std::make_unique<Site>(Site{clock,
                                                      1000 + m_sites.size(),
                                                      SimulatedLink{path, nextRandom()},
                                                      SimulatedLink{path, nextRandom()},
                                                      nullptr,
                                                      {},
                                                      {},
                                                      {},
                                                      {}}));
        return m_sites.size() - 1;
    }
    [[nodiscard]] Site& site(std::size_t index) { return *m_sites[index]; }

    /// Starts a program at a site that joins by this name. What an earlier one there knew is gone.
    void startClient(std::size_t index, const std::string& name)
    {
        Site& s = site(index);
        s.log.clear();
        s.client = std::make_unique<SyncClient>(proposal(std::string{"J"}.append(name)),
                                                nextRandom(), s.clock.at(m_now));
    }
    void crashClient(std::size_t index) { site(index).client.reset(); }

    [[nodiscard]] ProposalRecord proposal(const std::string& text)
    {
        const std::uint64_t id = std::uint64_t{nextRandom()} << 32 | nextRandom();
        return {ProposalId{id}, kNobody, StationId{}, TestSession::body(text)};
    }
    void propose(std::size_t index, const std::string& text)
    {
        site(index).client->propose(proposal(text), site(index).clock.at(m_now));
    }

    [[nodiscard]] Duration now() const { return m_now; }
    [[nodiscard]] LocalTime hostTime() const { return m_hostClock.at(m_now); }
    [[nodiscard]] SessionTime trueSessionTime() const
    {
        return SessionTime{hostTime().time_since_epoch() + kSessionOffset};
    }
    void setHostClock(const SimulatedClock& clock) { m_hostClock = clock; }

    /// Lets virtual time pass, from one arrival or timer to the next. `each` is called every
    /// `interval`, if it is not zero.
    void run(Duration length, Duration interval = {}, const std::function<void()>& each = {})
    {
        const Duration end = m_now + length;
        Duration nextCall = each ? m_now : end + Duration{1};
        while (m_now < end) {
            if (m_now >= nextCall) {
                each();
                nextCall += interval;
            }
            deliver();
            m_now = std::clamp(std::min(nextEvent(), nextCall), m_now + Duration{1000}, end);
        }
        deliver();
    }

private:
    std::uint32_t nextRandom() { return static_cast<std::uint32_t>(m_random()); }

    void deliver()
    {
        for (const auto& s : m_sites)
            while (auto bytes = s->toHost.receive(m_now))
                if (m_host)
                    m_host->receive(s->address, *bytes, hostTime());
        if (m_host)
            pumpHost();
        for (const auto& s : m_sites) {
            while (auto bytes = s->fromHost.receive(m_now))
                if (s->client)
                    s->client->receive(*bytes, s->clock.at(m_now));
            if (s->client)
                pumpClient(*s);
        }
    }

    void pumpHost()
    {
        m_host->advance(hostTime());
        for (const auto& datagram : m_host->take().datagrams)
            for (const auto& s : m_sites)
                if (s->address == datagram.to)
                    s->fromHost.send(datagram.bytes, m_now);
    }

    void pumpClient(Site& s)
    {
        s.client->advance(s.clock.at(m_now));
        SyncClient::Output output = s.client->take();
        if (output.startedAfresh) {
            ++s.timesStartedAfresh;
            s.log.clear();
        }
        std::ranges::move(output.facts, std::back_inserter(s.log));
        std::ranges::move(output.streams, std::back_inserter(s.streams));
        std::ranges::move(output.refused, std::back_inserter(s.refused));
        std::ranges::move(output.shown, std::back_inserter(s.shown));
        for (const auto& bytes : output.datagrams)
            s.toHost.send(bytes, m_now);
    }

    [[nodiscard]] Duration nextEvent() const
    {
        Duration next = Duration::max();
        const auto wake = [&](const SimulatedClock& clock, LocalTime local) {
            if (local != LocalTime::max())
                next = std::min(next, local == LocalTime::min() ? m_now : clock.when(local));
        };
        if (m_host)
            wake(m_hostClock, m_host->nextWake());
        for (const auto& s : m_sites) {
            next = std::min({next, s->toHost.nextArrival(), s->fromHost.nextArrival()});
            if (s->client)
                wake(s->clock, s->client->nextWake());
        }
        return next;
    }

public:
    TestSession session;

private:
    std::mt19937 m_random;
    Duration m_now{};
    SimulatedClock m_hostClock{std::chrono::hours{5}, 0};
    std::unique_ptr<SyncHost> m_host;
    std::vector<std::unique_ptr<Site>> m_sites;
};

} // namespace carina
