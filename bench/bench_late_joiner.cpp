// What a participant waits for who joins a session of 60 000 facts over encrypted sockets on this
// machine, and how long a host takes to open such a session from its file. Prints one JSON object.

#include "engine/core/monotonic_clock.h"
#include "engine/io/fact_store/sql_fact_store.h"
#include "engine/net/node/session_node.h"
#include "engine/session/facts/fact_codec.h"

#include <QCoreApplication>
#include <QTemporaryDir>
#include <QThread>

#include <algorithm>
#include <array>
#include <cstdio>

namespace
{

using namespace std::chrono_literals;
using namespace carina;

constexpr std::uint64_t kFacts = 60'000;
constexpr std::uint64_t kBetweenCheckpoints =
    20; ///< facts; a part of a checkpoint fills a datagram
constexpr auto kBetweenFacts = 100ms;
constexpr int kRounds = 5;
constexpr auto kPatience = 120s;
constexpr StationId kStation{0};

/// How keys are derived from codes is not what is measured.
Result<AccessKey> keyAtOnce(const JoinCode& /*code*/, const SessionKey& /*session*/)
{
    return AccessKey{};
}

/// A session in which an instructor turns knobs.
FactBody bodyOf(std::uint64_t number, SessionTime at)
{
    static const RespiratoryState kBreathing =
        RespiratoryFold{RespirationTimeline{}.settingsAt({})}.state();
    if (number == 1)
        return fact::SessionCreated{"Course", "000102030405060708090a0b0c0d0e0f"};
    if (number == 2)
        return fact::StationAdded{"Station 1"};
    if (number % kBetweenCheckpoints == 0)
        return fact::RespirationCheckpoint{at, kBreathing};
    if (number % kBetweenCheckpoints == 1)
        return fact::CapnographCheckpoint{at - kBetweenFacts, {}};
    if (number % kBetweenCheckpoints == 2)
        return fact::BodyCheckpoint{at - 2 * kBetweenFacts, BodyFold{BodySettings{}}.state()};
    if (number % 2 == 0)
        return fact::TidalVolumeSet{millilitres(200.0 + double(number % 100))};
    return fact::BreathingRateSet{perMinute(10.0 + double(number % 20))};
}

std::vector<FactRecord> longLog()
{
    std::vector<FactRecord> log;
    for (std::uint64_t number = 1; number <= kFacts; ++number) {
        const SessionTime at{number * kBetweenFacts};
        log.push_back(toRecord(Fact{FactNumber{number}, ProposalId{number}, ParticipantId{0},
                                    kStation, at, at, bodyOf(number, at)}));
    }
    return log;
}

int fails(const Error& why)
{
    std::fprintf(stderr, "carina: %s\n", why.detail.c_str());
    return EXIT_FAILURE;
}

double secondsSince(LocalTime begin) { return toSeconds(monotonicNow() - begin); }

Result<std::unique_ptr<SessionNode>> hostFile(const std::filesystem::path& file)
{
    return openFactStore(file).and_then([](std::unique_ptr<FactStore> store) {
        return SessionNode::host(
            {.sessionName = "Course", .participantName = "Host", .derive = keyAtOnce},
            std::move(store));
    });
}

/// Seconds from the start of a participant's program until it has the whole log; nothing where it
/// does not get it.
std::optional<double> joinOnce(const SessionNode& host, int round)
{
    const LocalTime begin = monotonicNow();
    const auto node = SessionNode::join({.port = host.port(),
                                         .participantName = "Late " + std::to_string(round),
                                         .role = Role::Observer,
                                         .code = host.joinCodes().at(Role::Observer),
                                         .derive = keyAtOnce});
    while (node && monotonicNow() - begin < kPatience) {
        if ((*node)->state()->lastApplied().value > kFacts)
            return secondsSince(begin);
        QThread::msleep(1);
    }
    return std::nullopt;
}

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application{argc, argv};
    const QTemporaryDir folder;
    const std::filesystem::path file =
        folder.filePath(QStringLiteral("session.sqlite")).toStdString();
    const std::vector<FactRecord> log = longLog();
    LocalTime begin = monotonicNow();
    const auto filled = openFactStore(file).and_then(
        [&](const std::unique_ptr<FactStore>& store) { return store->append(log); });
    if (!filled)
        return fails(filled.error());
    const double stored_s = secondsSince(begin);

    begin = monotonicNow();
    const auto host = hostFile(file);
    const double resumed_s = secondsSince(begin);
    if (!host)
        return fails(host.error());
    std::array<double, kRounds> joined_s{};
    for (int round = 0; round < kRounds; ++round) {
        const auto joined = joinOnce(**host, round);
        if (!joined)
            return fails({Errc::AddressInUse, "nobody comes in"});
        joined_s[std::size_t(round)] = *joined;
    }
    std::ranges::sort(joined_s);
    std::printf("{\"facts\": %llu, \"stored_s\": %.3f, \"resumed_s\": %.3f,"
                " \"joined_median_s\": %.3f, \"joined_most_s\": %.3f}\n",
                static_cast<unsigned long long>(kFacts), stored_s, resumed_s, joined_s[kRounds / 2],
                joined_s.back());
    return EXIT_SUCCESS;
}
