#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/network/handshake_experiment.h"

namespace carina::lab
{
namespace
{

namespace handshake_option
{
constexpr Option kJoins{"joins", "N", "how many clients, 1 to 1000; 60 unless given"};
constexpr Option kRoundTrip{"rtt-ms", "T", "round trip, 0 to 1000; 40 unless given"};
constexpr Option kLoss{"loss", "P",
                       "share of the datagrams lost each way, 0 to 0.5; 0.1 unless given"};
constexpr Option kSeed{"seed", "K", "decides which are lost, 0 to 1000000000; 1 unless given"};
} // namespace handshake_option

namespace handshake_key
{
constexpr Key kSchema{"schema", "carina.handshake/1"};
constexpr Key kJoins{"joins", "as given"};
constexpr Key kRoundTrip{"rtt_ms", "as given"};
constexpr Key kLoss{"loss", "as given"};
constexpr Key kSeed{"seed", "as given"};
constexpr Key kMedian{"p50_ms", "median time from the first hello until the path is encrypted"};
constexpr Key kPercentile{"p90_ms", "90th percentile of it"};
constexpr Key kMax{"max_ms", "the longest"};
constexpr Key kTries{"tries_per_join", "handshakes begun, for each client"};
constexpr Key kOverhead{"overhead_bytes", "that encryption adds to a datagram"};
constexpr Key kSendCost{"send_us", "processor time to encrypt and send a datagram of 481 bytes"};
constexpr Key kPassCost{"pass_us", "the same, with receiving and decrypting it"};
} // namespace handshake_key

Result<HandshakeSettings> settingsOf(const Words& words)
{
    const auto joins = words.whole(handshake_option::kJoins, 1, 1000, 60);
    if (!joins)
        return tl::unexpected(joins.error());
    const auto roundTrip_ms = words.number(handshake_option::kRoundTrip, 0.0, 1000.0, 40.0);
    if (!roundTrip_ms)
        return tl::unexpected(roundTrip_ms.error());
    const auto loss = words.number(handshake_option::kLoss, 0.0, 0.5, 0.1);
    if (!loss)
        return tl::unexpected(loss.error());
    const auto seed = words.whole(handshake_option::kSeed, 0, 1'000'000'000, 1);
    if (!seed)
        return tl::unexpected(seed.error());
    return HandshakeSettings{
        static_cast<int>(*joins),
        std::chrono::round<Duration>(std::chrono::duration<double, std::milli>{*roundTrip_ms}),
        *loss, static_cast<std::uint32_t>(*seed)};
}

/// The smallest that at least this share is not above.
double quantileMs(const std::vector<Duration>& sorted, double share)
{
    const auto index = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
    return 1e3 * toSeconds(sorted[index]);
}

Result<QJsonObject> handshake(const Words& words)
{
    const auto settings = settingsOf(words);
    if (!settings)
        return tl::unexpected(settings.error());
    const auto figures = measureHandshakes(*settings);
    if (!figures)
        return tl::unexpected(figures.error());
    return QJsonObject{{handshake_key::kSchema, QLatin1StringView{handshake_key::kSchema.help}},
                       {handshake_key::kJoins, settings->joins},
                       {handshake_key::kRoundTrip, 1e3 * toSeconds(settings->roundTrip)},
                       {handshake_key::kLoss, settings->loss},
                       {handshake_key::kSeed, qint64{settings->seed}},
                       {handshake_key::kMedian, quantileMs(figures->taken, 0.5)},
                       {handshake_key::kPercentile, quantileMs(figures->taken, 0.9)},
                       {handshake_key::kMax, 1e3 * toSeconds(figures->taken.back())},
                       {handshake_key::kTries, double(figures->tries) / settings->joins},
                       {handshake_key::kOverhead, qint64{figures->overhead}},
                       {handshake_key::kSendCost, 1e6 * toSeconds(figures->sendCost)},
                       {handshake_key::kPassCost, 1e6 * toSeconds(figures->passCost)}};
}

} // namespace

Command handshakeCommand()
{
    return {
        .name = "handshake",
        .theme = "drift and network",
        .summary = "measures how long joining a session takes over a path with delay and loss",
        .uses = {{.lines = {"[--joins N] [--rtt-ms T] [--loss P] [--seed K]"},
                  .text = "Clients join a session, one after the other, through a relay that "
                          "delays and loses datagrams, over real sockets on loopback. The time to "
                          "derive a key from a code is not included.",
                  .options = {handshake_option::kJoins, handshake_option::kRoundTrip,
                              handshake_option::kLoss, handshake_option::kSeed},
                  .schema = handshake_key::kSchema,
                  .keys = {handshake_key::kJoins, handshake_key::kRoundTrip, handshake_key::kLoss,
                           handshake_key::kSeed, handshake_key::kMedian, handshake_key::kPercentile,
                           handshake_key::kMax, handshake_key::kTries, handshake_key::kOverhead,
                           handshake_key::kSendCost, handshake_key::kPassCost}}},
        .experiment = handshake};
}

} // namespace carina::lab
