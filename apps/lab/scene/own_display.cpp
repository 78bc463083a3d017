#include "apps/lab/scene/own_display.h"

namespace carina::lab
{
namespace
{

constexpr int kServerStart_ms = 20'000;
constexpr int kServerEnd_ms = 3000;

} // namespace

OwnDisplay::~OwnDisplay()
{
    m_server.terminate();
    if (m_server.state() != QProcess::NotRunning && !m_server.waitForFinished(kServerEnd_ms)) {
        m_server.kill();
        m_server.waitForFinished();
    }
}

Result<void> OwnDisplay::start(const QSize& size)
{
    m_server.setStandardErrorFile(QProcess::nullDevice());
    m_server.start(QStringLiteral("Xvfb"),
                   {QStringLiteral("-displayfd"), QStringLiteral("1"), QStringLiteral("-screen"),
                    QStringLiteral("0"),
                    QStringLiteral("%1x%2x24").arg(size.width()).arg(size.height()),
                    QStringLiteral("+extension"), QStringLiteral("GLX"),
                    QStringLiteral("-nolisten"), QStringLiteral("tcp")});
    while (!m_number.endsWith('\n') && m_server.waitForReadyRead(kServerStart_ms))
        m_number += m_server.readAllStandardOutput();
    if (!m_number.endsWith('\n'))
        return fail(Errc::NoGraphics, "Xvfb does not start.");
    m_number = m_number.trimmed();
    return {};
}

QStringList OwnDisplay::on(const QStringList& program) const
{
    return QStringList{
               QStringLiteral("env"), QStringLiteral("DISPLAY=:") + QString::fromLatin1(m_number),
               QStringLiteral("QT_QPA_PLATFORM=xcb"), QStringLiteral("LIBGL_ALWAYS_SOFTWARE=1"),
               QStringLiteral("CARINA_UNATTENDED=1")}
           + program;
}

} // namespace carina::lab
