#include "apps/lab/command/words.h"
#include "apps/lab/commands.h"
#include "apps/lab/network/carry_experiment.h"

namespace carina::lab
{
namespace
{

namespace carry_option
{
constexpr Option kMegabytes{"mb", "N", "length of the set in megabytes, 1 to 256; 40 unless given"};
constexpr Option kSeconds{"seconds", "T", "length of each phase, 1 to 600; 5 unless given"};
} // namespace carry_option

namespace carry_key
{
constexpr Key kSchema{"schema", "carina.carry/1"};
constexpr Key kBefore{"before", "age of the poses on arrival (latency), before any transfer:"};
constexpr Key kPoses{"poses", "that came", 1};
constexpr Key kMedian{"p50_ms", "median of their ages", 1};
constexpr Key kPercentile95{"p95_ms", "95th percentile", 1};
constexpr Key kPercentile99{"p99_ms", "99th percentile", 1};
constexpr Key kMax{"max_ms", "the oldest", 1};
constexpr Key kDuring{"during", "the same during the transfers of the set"};
constexpr Key kAfter{"after", "the same after the transfers"};
constexpr Key kSets{"sets", "that came whole"};
constexpr Key kSetBytes{"set_bytes", "length of each"};
constexpr Key kRate{"mb_per_s", "of those that came whole; missing where none did"};
} // namespace carry_key

/// @param sorted ages, of which there is one
QJsonObject spread(const std::vector<Duration>& sorted)
{
    const auto at = [&](double share) {
        return 1e3 * toSeconds(sorted[std::size_t(share * double(sorted.size() - 1))]);
    };
    return {{carry_key::kPoses, qint64(sorted.size())},
            {carry_key::kMedian, at(0.5)},
            {carry_key::kPercentile95, at(0.95)},
            {carry_key::kPercentile99, at(0.99)},
            {carry_key::kMax, at(1.0)}};
}

Result<QJsonObject> carry(const Words& words)
{
    const auto megabytes = words.whole(carry_option::kMegabytes, 1, 256, 40);
    const auto seconds = words.whole(carry_option::kSeconds, 1, 600, 5);
    if (!megabytes || !seconds)
        return tl::unexpected(megabytes ? seconds.error() : megabytes.error());
    const auto figures =
        measureCarrying({static_cast<int>(*megabytes), std::chrono::seconds{*seconds}});
    if (!figures)
        return tl::unexpected(figures.error());
    if (figures->before.empty() || figures->during.empty() || figures->after.empty())
        return fail(Errc::HostSilent, "no poses came");
    QJsonObject report{{carry_key::kSchema, QLatin1StringView{carry_key::kSchema.help}},
                       {carry_key::kBefore, spread(figures->before)},
                       {carry_key::kDuring, spread(figures->during)},
                       {carry_key::kAfter, spread(figures->after)},
                       {carry_key::kSets, figures->sets},
                       {carry_key::kSetBytes, qint64(figures->bytes)}};
    if (figures->sets > 0)
        report[carry_key::kRate] =
            1e-6 * double(figures->bytes) * figures->sets / toSeconds(figures->fetching);
    return report;
}

} // namespace

Command carryCommand()
{
    return {
        .name = "carry",
        .theme = "drift and network",
        .summary = "measures the latency of poses while an anatomy set is sent",
        .uses =
            {{.lines = {"[--mb N] [--seconds T]"},
              .text =
                  "A host sends the pose of a tube 60 times a second to a participant, over real "
                  "sockets on loopback, in three phases: without other traffic, while the "
                  "participant fetches an anatomy set repeatedly, and without other traffic again.",
              .options = {carry_option::kMegabytes, carry_option::kSeconds},
              .schema = carry_key::kSchema,
              .keys = {carry_key::kBefore, carry_key::kPoses, carry_key::kMedian,
                       carry_key::kPercentile95, carry_key::kPercentile99, carry_key::kMax,
                       carry_key::kDuring, carry_key::kAfter, carry_key::kSets,
                       carry_key::kSetBytes, carry_key::kRate}}},
        .experiment = carry};
}

} // namespace carina::lab
