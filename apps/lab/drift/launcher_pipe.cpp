#include "apps/lab/drift/launcher_pipe.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <cstdio>

namespace carina::lab
{

std::optional<QByteArray> LauncherPipe::line()
{
    read();
    const qsizetype end = m_bytes.indexOf('\n');
    if (end < 0)
        return std::nullopt;
    const QByteArray line = m_bytes.left(end);
    m_bytes.remove(0, end + 1);
    return line;
}

void LauncherPipe::read()
{
    pollfd input{STDIN_FILENO, POLLIN, 0};
    while (!m_isClosed && ::poll(&input, 1, 0) > 0) {
        std::array<char, 4096> buffer{};
        const ssize_t count = ::read(STDIN_FILENO, buffer.data(), buffer.size());
        m_isClosed = count <= 0;
        if (count > 0)
            m_bytes.append(buffer.data(), count);
    }
}

void LauncherPipe::say(const QByteArray& line)
{
    std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stdout);
    std::fputc('\n', stdout);
    std::fflush(stdout);
}

} // namespace carina::lab
