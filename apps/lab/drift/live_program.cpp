#include "apps/lab/drift/live_program.h"

#include <QJsonDocument>

namespace carina::lab
{
namespace
{

constexpr int kLastWords_ms = 3000;

} // namespace

LiveProgram::LiveProgram(std::string who, const QStringList& words, const LiveOrders& orders)
    : m_who{std::move(who)}
{
    m_process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    m_process.start(words.first(), words.mid(1));
    m_process.write(lineOf(orders));
}

LiveProgram::~LiveProgram()
{
    m_process.closeWriteChannel();
    if (!hasEnded() && !m_process.waitForFinished(kLastWords_ms)) {
        m_process.kill();
        m_process.waitForFinished();
    }
}

void LiveProgram::listen()
{
    while (!m_isReady && m_process.canReadLine()) {
        const QByteArray line = m_process.readLine().trimmed();
        if (line.startsWith("port "))
            m_port = line.mid(5).toUShort();
        m_isReady = line == "ready";
    }
    if (m_isReady)
        m_said += m_process.readAllStandardOutput();
}

void LiveProgram::begin(LocalTime machine)
{
    m_process.write("start " + QByteArray::number(qint64{machine.time_since_epoch().count()})
                    + '\n');
}

Result<QJsonObject> LiveProgram::log()
{
    listen();
    const QJsonObject log = QJsonDocument::fromJson(m_said).object();
    if (log.isEmpty())
        return fail(Errc::FileMalformed, m_who + " left no log.");
    return log;
}

} // namespace carina::lab
