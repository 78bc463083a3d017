#pragma once

#include "engine/net/node/client_driver.h"
#include "engine/net/node/host_driver.h"
#include "tests/engine/net/node/nodes.h"

#include <atomic>
#include <utility>

namespace carina
{

/// A MemoryStore whose appends wait as long as the test holds them.
class HeldStore : public MemoryStore
{
public:
    /// What the test sees of it.
    struct Disk : MemoryDisk {
        std::atomic<bool> isHeld = false;
        std::vector<std::size_t> transactions; ///< facts in each; read it while nothing is written

        void hold() { isHeld = true; }
        void letGo()
        {
            isHeld = false;
            isHeld.notify_all();
        }
    };

    explicit HeldStore(Disk& disk) : MemoryStore{disk}, m_disk{disk} {}

    Result<void> append(std::span<const FactRecord> facts) override
    {
        m_disk.isHeld.wait(true);
        const Result<void> stored = MemoryStore::append(facts);
        if (stored)
            m_disk.transactions.push_back(facts.size());
        return stored;
    }

private:
    Disk& m_disk;
};

/// The drivers of a host and of participants in virtual time, without sockets: datagrams arrive in
/// the turn in which they are sent, every millisecond.
class DriverWorld
{
public:
    struct Guest {
        PeerAddress address;
        NodeBoard board;
        std::unique_ptr<ClientDriver> driver;
        bool hasNews = true; ///< since its last turn
    };

    explicit DriverWorld(HeldStore::Disk& disk) : m_disk{disk}
    {
        auto opened =
            HostDriver::open(hostSettings(disk), std::make_unique<HeldStore>(disk), board, now);
        if (opened)
            host = *std::move(opened);
    }

    Guest& add(const std::string& name, Role role = Role::Trainee)
    {
        auto guest = std::make_unique<Guest>();
        guest->address = 100 + m_guests.size();
        guest->driver = std::make_unique<ClientDriver>(
            JoinSettings{.participantName = name, .role = role}, guest->board, now);
        host->connected(guest->address, {role, std::nullopt}, now);
        guest->driver->connected(kPathToHost, {}, now);
        m_guests.push_back(std::move(guest));
        return *m_guests.back();
    }

    /// So many at once; no more at a moment than the paths that one address may have idle.
    std::vector<Guest*> addCrowd(int size, Role role = Role::Trainee)
    {
        std::vector<Guest*> crowd;
        for (int n = 0; n < size; ++n) {
            if (n > 0 && n % int(HostPaths::kMostIdleOfCode) == 0)
                run(std::chrono::milliseconds{1});
            crowd.push_back(&add("Guest " + std::to_string(n), role));
        }
        return crowd;
    }

    /// From now on the guest comes by another path, with the role's code; what is on its way to it
    /// on the old one is lost.
    void movePath(Guest& guest, Role role = Role::Trainee)
    {
        guest.address = m_nextMoved++;
        host->connected(guest.address, {role, std::nullopt}, now);
        guest.driver->connected(kPathToHost, {}, now);
    }

    /// Lets virtual time pass; the disk is waited for at each turn, unless it is held.
    void run(Duration length, const std::function<void()>& each = {})
    {
        for (const LocalTime end = now + length; now < end; now += 1ms) {
            for (const auto& guest : m_guests)
                for (const auto& [to, bytes] : guest->driver->advance(now))
                    host->receive(guest->address, bytes, now);
            deliver(host->advance(now));
            if (!m_disk.isHeld) {
                host->waitForDisk(now);
                deliver(host->advance(now));
            }
            if (each)
                each();
        }
    }

    /// The same, but who has neither asked for a turn nor received a datagram has none.
    void runByWakes(Duration length, const std::function<void()>& each = {})
    {
        for (const LocalTime end = now + length; now < end; now += 1ms) {
            for (const auto& guest : m_guests) {
                if (!std::exchange(guest->hasNews, false) && guest->driver->nextWake() > now)
                    continue;
                for (const auto& [to, bytes] : guest->driver->advance(now)) {
                    host->receive(guest->address, bytes, now);
                    m_hostHasNews = true;
                }
            }
            if (std::exchange(m_hostHasNews, false) || host->nextWake() <= now) {
                deliver(host->advance(now));
                host->waitForDisk(now); // whose report gives it another turn
                deliver(host->advance(now));
            }
            if (each)
                each();
        }
    }

    HeldStore::Disk& disk() { return m_disk; }

    LocalTime now = monotonicNow();
    NodeBoard board;
    std::unique_ptr<HostDriver> host;

private:
    static constexpr PeerAddress kPathToHost = 1;

    void deliver(const NodeDriver::Datagrams& datagrams)
    {
        for (const auto& [to, bytes] : datagrams)
            for (const auto& guest : m_guests)
                if (guest->address == to) {
                    guest->driver->receive(kPathToHost, bytes, now);
                    guest->hasNews = true;
                }
    }

    HeldStore::Disk& m_disk;
    std::vector<std::unique_ptr<Guest>> m_guests;
    PeerAddress m_nextMoved = 10'000;
    bool m_hostHasNews = true; // since its last turn
};

} // namespace carina
