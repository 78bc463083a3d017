#include "apps/lab/network/handshake_command.h"

#include "apps/lab/network/handshake_experiment.h"

#include <QMap>

namespace carina::lab
{
namespace
{

constexpr std::string_view kHandshakeHelp =
    R"(handshake [--joins N] [--rtt-ms T] [--loss P] [--seed K]
    Lets clients come into a session, one after the other, through a relay that delays and loses
    datagrams, over real sockets on loopback. No key is derived.
    --joins N         how many clients, 1 to 1000 (60)
    --rtt-ms T        round trip, 0 to 1000 (40)
    --loss P          share of the datagrams lost each way, 0 to 0.5 (0.1)
    --seed K          decides which are lost (1)
    schema            "carina.handshake/1"
    p50_ms, p90_ms, max_ms   from the first hello until the path is encrypted
    tries_per_join    handshakes begun
    overhead_bytes    that encryption adds to a datagram
    send_us           processor time to encrypt and send a datagram of 481 bytes
    pass_us           the same, with receiving and decrypting it
)";

Result<double> numberOf(const QMap<QString, QString>& flags, const char* name, double standard,
                        double least, double most)
{
    const QString flag = QStringLiteral("--") + QLatin1String{name};
    if (!flags.contains(flag))
        return standard;
    bool right = false;
    const double value = flags.value(flag).toDouble(&right);
    if (!right || !(value >= least && value <= most))
        return fail(Errc::OutOfRange, flag.toStdString() + ' ' + flags.value(flag).toStdString());
    return value;
}

Result<HandshakeSettings> settingsOf(const QStringList& arguments)
{
    QMap<QString, QString> flags;
    for (qsizetype i = 0; i < arguments.size(); i += 2)
        flags.insert(arguments[i], arguments.value(i + 1));
    for (const QString& flag : flags.keys())
        if (!QStringList{QStringLiteral("--joins"), QStringLiteral("--rtt-ms"),
                         QStringLiteral("--loss"), QStringLiteral("--seed")}
                 .contains(flag))
            return fail(Errc::OutOfRange, "handshake does not know " + flag.toStdString());
    const auto joins = numberOf(flags, "joins", 60, 1, 1000);
    const auto roundTrip = numberOf(flags, "rtt-ms", 40, 0, 1000);
    const auto loss = numberOf(flags, "loss", 0.1, 0, 0.5);
    const auto seed = numberOf(flags, "seed", 1, 0, 1e9);
    for (const auto* value : {&joins, &roundTrip, &loss, &seed})
        if (!*value)
            return tl::unexpected(value->error());
    return HandshakeSettings{
        static_cast<int>(*joins),
        std::chrono::round<Duration>(std::chrono::duration<double, std::milli>{*roundTrip}), *loss,
        static_cast<std::uint32_t>(*seed)};
}

/// The smallest that at least this share is not above.
double quantileMs(const std::vector<Duration>& sorted, double share)
{
    const auto index = static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1));
    return 1e3 * toSeconds(sorted[index]);
}

Result<QJsonObject> handshake(const QStringList& arguments)
{
    const auto settings = settingsOf(arguments);
    if (!settings)
        return tl::unexpected(settings.error());
    const auto figures = measureHandshakes(*settings);
    if (!figures)
        return tl::unexpected(figures.error());
    return QJsonObject{{QStringLiteral("schema"), QStringLiteral("carina.handshake/1")},
                       {QStringLiteral("joins"), settings->joins},
                       {QStringLiteral("rtt_ms"), 1e3 * toSeconds(settings->roundTrip)},
                       {QStringLiteral("loss"), settings->loss},
                       {QStringLiteral("seed"), qint64{settings->seed}},
                       {QStringLiteral("p50_ms"), quantileMs(figures->taken, 0.5)},
                       {QStringLiteral("p90_ms"), quantileMs(figures->taken, 0.9)},
                       {QStringLiteral("max_ms"), 1e3 * toSeconds(figures->taken.back())},
                       {QStringLiteral("tries_per_join"), double(figures->tries) / settings->joins},
                       {QStringLiteral("overhead_bytes"), qint64{figures->overhead}},
                       {QStringLiteral("send_us"), 1e6 * toSeconds(figures->sendCost)},
                       {QStringLiteral("pass_us"), 1e6 * toSeconds(figures->passCost)}};
}

} // namespace

Command handshakeCommand() { return {"handshake", kHandshakeHelp, handshake}; }

} // namespace carina::lab
