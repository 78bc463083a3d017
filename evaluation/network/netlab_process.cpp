#include "evaluation/network/netlab_process.h"

#include "engine/io/files/whole_file.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

constexpr int kStart_ms = 15000;
constexpr int kEnd_ms = 5000;

QString nanoseconds(Duration time) { return QString::number(time.count()) + QStringLiteral("ns"); }

QString jitterOf(const PathProfile& leg)
{
    switch (leg.jitter) {
    case PathProfile::Jitter::Exponential:
        return QStringLiteral("exp:") + nanoseconds(leg.jitterScale);
    case PathProfile::Jitter::Pareto:
        return QStringLiteral("pareto:") + nanoseconds(leg.jitterScale);
    case PathProfile::Jitter::Uniform:
        return QStringLiteral("uniform:") + nanoseconds(leg.jitterScale);
    case PathProfile::Jitter::None:
        break;
    }
    return QStringLiteral("none");
}

} // namespace

QString netlabWay(const PathProfile& leg, bool hasStepped, const std::filesystem::path& trace)
{
    const Duration delay = leg.delay + (hasStepped ? leg.stepBy : Duration{});
    QStringList words{
        QStringLiteral("order=free"),
        QStringLiteral("delay=") + nanoseconds(delay),
        QStringLiteral("jitter=") + jitterOf(leg),
        QStringLiteral("loss=%1").arg(leg.loss),
        QStringLiteral("dup=%1").arg(leg.duplication),
        QStringLiteral("reorder=%1:%2").arg(leg.reordering).arg(nanoseconds(leg.heldUp))};
    if (leg.burst)
        words << QStringLiteral("ge=%1:%2").arg(leg.burst->enter).arg(leg.burst->leave);
    if (leg.bitsPerSecond > 0.0)
        words << QStringLiteral("rate=%1").arg(leg.bitsPerSecond)
              << QStringLiteral("queue=%1").arg(leg.queueBytes);
    if (leg.trace)
        words << QStringLiteral("trace=") + QString::fromStdString(trace.string());
    return words.join(QLatin1Char{' '});
}

NetlabProcess::~NetlabProcess()
{
    // The lab lasts as long as its command, and that as long as its input.
    m_lab.closeWriteChannel();
    if (m_lab.state() != QProcess::NotRunning && !m_lab.waitForFinished(kEnd_ms))
        m_lab.terminate();
    m_lab.waitForFinished(kEnd_ms);
}

std::filesystem::path NetlabProcess::folder() const
{
    return std::filesystem::path{m_folder.path().toStdString()};
}

Result<void> NetlabProcess::start(const QStringList& lines)
{
    m_name = QStringLiteral("carina%1").arg(QCoreApplication::applicationPid());
    const std::filesystem::path file = folder() / "lab.conf";
    if (const auto kept =
            writePrivateFile(file, lines.join(QLatin1Char{'\n'}).toStdString() + '\n');
        !kept)
        return kept;
    m_lab.setProcessChannelMode(QProcess::MergedChannels);
    m_lab.start(m_program,
                {QStringLiteral("run"), QString::fromStdString(file.string()), QStringLiteral("-n"),
                 m_name, QStringLiteral("--rt"), QStringLiteral("--spin"), QStringLiteral("60us"),
                 QStringLiteral("--"), QStringLiteral("cat")});
    QByteArray said;
    while (m_lab.waitForReadyRead(kStart_ms)) {
        said += m_lab.readAll();
        if (said.contains(" up: "))
            return {};
    }
    return fail(Errc::NotPermitted, "netlab has not started. " + said.trimmed().toStdString());
}

QStringList NetlabProcess::inPlace(const QString& host, const QStringList& program) const
{
    return QStringList{m_program, QStringLiteral("exec"), QStringLiteral("-n"), m_name, host}
           + program;
}

void NetlabProcess::tell(const QString& statement) const
{
    QProcess control;
    control.setProgram(m_program);
    control.setArguments(QStringList{QStringLiteral("ctl"), QStringLiteral("-n"), m_name}
                         + statement.split(QLatin1Char{' '}));
    control.setStandardOutputFile(QProcess::nullDevice()); // ours is for the figures
    control.startDetached();
}

} // namespace carina
