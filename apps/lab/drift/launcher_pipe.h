#pragma once

#include <QByteArray>

#include <optional>

namespace carina::lab
{

/// The other end of a program's standard input and output, at which the one that started it sits.
class LauncherPipe
{
public:
    /// The next line, without its end, if it is there whole; never waits.
    [[nodiscard]] std::optional<QByteArray> line();
    /// Nothing comes any more: the other end is closed.
    [[nodiscard]] bool isClosed() const { return m_isClosed; }
    static void say(const QByteArray& line);

private:
    void read();

    QByteArray m_bytes;
    bool m_isClosed = false;
};

} // namespace carina::lab
