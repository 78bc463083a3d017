#include "apps/lab/network/carry_command.h"

#include "apps/lab/network/carry_experiment.h"

namespace carina::lab
{
namespace
{

constexpr std::string_view kCarryHelp =
    R"(carry [--mb N] [--seconds T]
    A host shares a tube 60 times a second with a participant, over real sockets on loopback, in
    three phases: with nothing beside it, while the participant fetches an anatomy set again and
    again, and with nothing again.
    --mb N            length of the set in megabytes, 1 to 256 (40)
    --seconds T       length of each phase, 1 to 600 (5)
    schema            "carina.carry/1"
    before, during, after   how old poses were when they came: poses, p50_ms, p95_ms, p99_ms, max_ms
    sets              that came whole
    set_bytes         length of each
    mb_per_s          of those that came whole
)";

Result<int> wholeNumber(const QStringList& arguments, const QString& flag, int standard, int most)
{
    const qsizetype at = arguments.indexOf(flag);
    if (at < 0)
        return standard;
    bool right = false;
    const int value = arguments.value(at + 1).toInt(&right);
    if (!right || value < 1 || value > most)
        return fail(Errc::OutOfRange,
                    flag.toStdString() + ' ' + arguments.value(at + 1).toStdString());
    return value;
}

/// @param sorted ages, of which there is one
QJsonObject spread(const std::vector<Duration>& sorted)
{
    const auto at = [&](double share) {
        return 1e3 * toSeconds(sorted[std::size_t(share * double(sorted.size() - 1))]);
    };
    return {{QStringLiteral("poses"), qint64(sorted.size())},
            {QStringLiteral("p50_ms"), at(0.5)},
            {QStringLiteral("p95_ms"), at(0.95)},
            {QStringLiteral("p99_ms"), at(0.99)},
            {QStringLiteral("max_ms"), at(1.0)}};
}

Result<QJsonObject> carry(const QStringList& arguments)
{
    for (qsizetype i = 0; i < arguments.size(); i += 2)
        if (arguments[i] != QStringLiteral("--mb") && arguments[i] != QStringLiteral("--seconds"))
            return fail(Errc::OutOfRange, "carry does not know " + arguments[i].toStdString());
    const auto megabytes = wholeNumber(arguments, QStringLiteral("--mb"), 40, 256);
    const auto seconds = wholeNumber(arguments, QStringLiteral("--seconds"), 5, 600);
    if (!megabytes || !seconds)
        return tl::unexpected(megabytes ? seconds.error() : megabytes.error());
    const auto figures = measureCarrying({*megabytes, std::chrono::seconds{*seconds}});
    if (!figures)
        return tl::unexpected(figures.error());
    if (figures->before.empty() || figures->during.empty() || figures->after.empty())
        return fail(Errc::HostSilent, "no poses came");
    QJsonObject report{{QStringLiteral("schema"), QStringLiteral("carina.carry/1")},
                       {QStringLiteral("before"), spread(figures->before)},
                       {QStringLiteral("during"), spread(figures->during)},
                       {QStringLiteral("after"), spread(figures->after)},
                       {QStringLiteral("sets"), figures->sets},
                       {QStringLiteral("set_bytes"), qint64(figures->bytes)}};
    if (figures->sets > 0)
        report[QStringLiteral("mb_per_s")] =
            1e-6 * double(figures->bytes) * figures->sets / toSeconds(figures->fetching);
    return report;
}

} // namespace

Command carryCommand() { return {"carry", kCarryHelp, carry}; }

} // namespace carina::lab
