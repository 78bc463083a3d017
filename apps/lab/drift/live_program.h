#pragma once

#include "apps/lab/drift/live_log.h"
#include "apps/lab/drift/live_orders.h"

#include <QProcess>

namespace carina::lab
{

/// Another program of a live session, started from this one (see driftNodeCommand).
class LiveProgram
{
public:
    /// @param words the program and its arguments
    LiveProgram(std::string who, const QStringList& words, const LiveOrders& orders);
    /// Ends it.
    ~LiveProgram();
    LiveProgram(const LiveProgram&) = delete;
    LiveProgram& operator=(const LiveProgram&) = delete;

    /// Takes what it said. To be called often.
    void listen();
    void begin(LocalTime machine);

    [[nodiscard]] std::uint16_t port() const { return m_port; } ///< 0 until it is known
    [[nodiscard]] bool isReady() const { return m_isReady; }
    [[nodiscard]] bool hasEnded() const { return m_process.state() == QProcess::NotRunning; }
    /// @returns FileMalformed, naming who, if it left none. @pre hasEnded()
    [[nodiscard]] Result<QJsonObject> log();
    [[nodiscard]] const std::string& who() const { return m_who; }

private:
    std::string m_who;
    QProcess m_process;
    QByteArray m_said; // since it is ready: its log
    std::uint16_t m_port = 0;
    bool m_isReady = false;
};

} // namespace carina::lab
