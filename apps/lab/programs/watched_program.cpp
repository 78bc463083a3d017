#include "apps/lab/programs/watched_program.h"

#include <QDir>
#include <QFile>

namespace carina::lab
{
namespace
{

constexpr int kFarewell_ms = 5000;

} // namespace

std::optional<Footprint> footprintOf(std::int64_t processId)
{
    const QDir folder{QStringLiteral("/proc/%1").arg(processId)};
    QFile status{folder.filePath(QStringLiteral("status"))};
    if (processId == 0 || !status.open(QIODevice::ReadOnly))
        return std::nullopt;
    Footprint footprint;
    bool hasMemory = false; // one that has ended, and that nobody has waited for, has none
    for (const QByteArray& line : status.readAll().split('\n')) {
        const QByteArray value = line.simplified().split(' ').value(1);
        if (line.startsWith("RssAnon:"))
            footprint.memory_kb = value.toDouble(&hasMemory);
        if (line.startsWith("Threads:"))
            footprint.threads = value.toInt();
    }
    if (!hasMemory)
        return std::nullopt;
    const QDir open{folder.filePath(QStringLiteral("fd"))};
    footprint.descriptors = static_cast<int>(
        open.entryList(QDir::NoDotAndDotDot | QDir::AllEntries | QDir::System | QDir::Hidden)
            .size());
    return footprint;
}

WatchedProgram::WatchedProgram(std::string name, const QStringList& words) : m_name{std::move(name)}
{
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_process.setStandardOutputFile(QProcess::nullDevice());
    m_process.start(words.first(), words.mid(1));
    m_process.waitForStarted();
}

WatchedProgram::~WatchedProgram()
{
    m_process.terminate();
    if (!hasEnded() && !m_process.waitForFinished(kFarewell_ms)) {
        m_process.kill();
        m_process.waitForFinished();
    }
}

} // namespace carina::lab
