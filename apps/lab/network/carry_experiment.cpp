#include "apps/lab/network/carry_experiment.h"

#include "engine/core/monotonic_clock.h"
#include "engine/io/anatomy_set/anatomy_cache.h"
#include "engine/io/fact_store/sql_fact_store.h"
#include "engine/net/anatomy_transfer/set_fetch.h"
#include "engine/net/node/session_node.h"

#include <QTemporaryDir>

#include <algorithm>
#include <thread>

namespace carina::lab
{
namespace
{

constexpr Duration kLook = std::chrono::microseconds{100}; ///< between two looks at what came
constexpr Duration kComingIn = std::chrono::seconds{20};

Result<AccessKey> sameKey(const JoinCode&, const SessionKey&) { return AccessKey{}; }

/// One surface of about so many bytes, half of them vertices and half corners.
ImportedSet madeUpSet(int megabytes)
{
    const auto count = std::size_t(megabytes) * 500'000 / sizeof(Vec3f) / 2;
    TriangleMesh mesh;
    for (std::size_t i = 0; i < count; ++i)
        mesh.positions.emplace_back(0.001F * float(i % 1000), 0.0F, 0.0F);
    mesh.normals.assign(count, Vec3f::UnitZ());
    mesh.triangles.assign(2 * count, Triangle{0, 1, 2});
    ImportedSet set;
    set.anatomy.contentHash = std::string(64, 'c');
    set.anatomy.parts.push_back({"Skin", PartRole::Skin, {}, {std::move(mesh)}});
    return set;
}

/// The two programs, and what came of the one's tube at the other.
class CarryingPair
{
public:
    Result<void> start(const ImportedSet& set)
    {
        const std::filesystem::path folder = m_folder.path().toStdString();
        auto made = AnatomyCache{folder / "host"}.store(set, std::string(64, 'd')).and_then([&] {
            return openFactStore((folder / "session.sqlite").string());
        });
        if (!made)
            return tl::unexpected(made.error());
        auto host = SessionNode::host({.sessionName = "Carrying",
                                       .participantName = "Host",
                                       .derive = sameKey,
                                       .anatomyCache = folder / "host"},
                                      *std::move(made));
        if (!host)
            return tl::unexpected(host.error());
        m_host = *std::move(host);
        m_host->propose(ownStation(*m_host),
                        fact::AnatomyChosen{set.anatomy.contentHash, "Made up"});
        m_host->publish(ObjectKind::Tube, "Tube", [this] { return tubeNow(); });
        return join();
    }

    /// Until then, and so often: adds how old each new pose was when it came.
    void watch(LocalTime until, std::vector<Duration>& ages,
               const std::function<void()>& beside = {})
    {
        while (monotonicNow() < until) {
            std::this_thread::sleep_for(kLook);
            const auto now = m_client->now();
            const auto state = m_client->state();
            const auto tube = state->objects().empty()
                                  ? nullptr
                                  : m_client->object(state->objects().begin()->first);
            const auto newest = tube ? tube->newest() : std::nullopt;
            if (newest && now && newest->time > m_seen) {
                m_seen = newest->time;
                ages.push_back(*now - newest->time);
            }
            if (beside)
                beside();
        }
        std::ranges::sort(ages);
    }

    /// Begins to fetch the set where nothing is fetched, and counts those that came.
    void fetchOn(const std::string& contentHash, CarryFigures& figures)
    {
        const std::filesystem::path cache = m_folder.path().toStdString() + "/client";
        if (!m_fetch) {
            std::error_code error;
            std::filesystem::remove_all(cache, error);
            m_began = monotonicNow();
            m_fetch = std::make_unique<SetFetch>(*m_client->door(), contentHash, cache);
        }
        const FetchStatus status = m_fetch->status();
        if (status.state != FetchStatus::State::Here)
            return;
        figures.bytes = status.set.bytes;
        figures.fetching += monotonicNow() - m_began;
        ++figures.sets;
        m_fetch.reset();
    }
    void stopFetching() { m_fetch.reset(); }

private:
    [[nodiscard]] std::optional<PoseSample> tubeNow() const
    {
        const auto now = m_host->now();
        if (!now)
            return std::nullopt;
        PoseSample sample;
        sample.time = *now;
        return sample;
    }

    Result<void> join()
    {
        auto client = SessionNode::join({.port = m_host->port(),
                                         .participantName = "Trainee",
                                         .code = m_host->joinCodes().at(Role::Trainee),
                                         .derive = sameKey});
        if (!client)
            return tl::unexpected(client.error());
        m_client = *std::move(client);
        for (const LocalTime until = monotonicNow() + kComingIn; monotonicNow() < until;) {
            std::this_thread::sleep_for(kLook);
            if (m_client->now() && m_client->door() && !m_client->state()->objects().empty())
                return {};
        }
        return fail(Errc::HostSilent, "nobody came in");
    }

    QTemporaryDir m_folder;
    std::unique_ptr<SessionNode> m_host;
    std::unique_ptr<SessionNode> m_client;
    std::unique_ptr<SetFetch> m_fetch;
    LocalTime m_began{};
    SessionTime m_seen = SessionTime::min();
};

} // namespace

Result<CarryFigures> measureCarrying(const CarrySettings& settings)
{
    const ImportedSet set = madeUpSet(settings.megabytes);
    CarryingPair pair;
    if (const auto started = pair.start(set); !started)
        return tl::unexpected(started.error());
    CarryFigures figures;
    std::vector<Duration> settling;
    pair.watch(monotonicNow() + std::chrono::seconds{2}, settling);
    pair.watch(monotonicNow() + settings.phase, figures.before);
    pair.watch(monotonicNow() + settings.phase, figures.during,
               [&] { pair.fetchOn(set.anatomy.contentHash, figures); });
    pair.stopFetching();
    pair.watch(monotonicNow() + settings.phase, figures.after);
    return figures;
}

} // namespace carina::lab
