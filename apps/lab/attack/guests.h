#pragma once

#include "engine/net/entry/join_code.h"

#include <QProcess>

#include <cstdint>

namespace carina::lab
{

/// People who only take part in a session, in a program of their own (guestsCommand), which makes
/// way for all others: they stand for other computers, that do not take the processors of the host.
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
