#pragma once

#include "engine/net/entry/join_code.h"

#include <QProcess>

#include <cstdint>

namespace carina::lab
{

/// People who only take part in a session, in a program of their own (guestsCommand). They stand
/// for other computers, and all have one thread, so as to take little of the host's processors:
/// with a thread each some sixty of them waited for one at a time, each with as much of it as the
/// host.
class Guests
{
public:
    /// Whom the session has as "Guest 0" and so on. @param count 1 or more
    Guests(std::uint16_t port, const JoinCodes& codes, int count);
    /// They go.
    ~Guests();
    Guests(const Guests&) = delete;
    Guests& operator=(const Guests&) = delete;

    /// Whether all have come in.
    [[nodiscard]] bool areIn();
    [[nodiscard]] bool hasEnded() const { return m_process.state() == QProcess::NotRunning; }

    [[nodiscard]] static std::string nameOf(int number)
    {
        return "Guest " + std::to_string(number);
    }

private:
    QProcess m_process;
    bool m_areIn = false;
};

} // namespace carina::lab
