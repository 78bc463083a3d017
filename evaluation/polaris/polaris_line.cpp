#include "evaluation/polaris/polaris_line.h"

#include "engine/core/monotonic_clock.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <cstdlib>
#include <fcntl.h>
#include <map>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>
#include <utility>

namespace carina
{
namespace
{

constexpr Duration kTurn = std::chrono::milliseconds{10};

} // namespace

Result<PolarisLine> PolarisLine::terminal(const std::filesystem::path& link)
{
    PolarisLine line;
    line.m_line = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK);
    std::array<char, 128> name{};
    if (line.m_line < 0 || ::grantpt(line.m_line) != 0 || ::unlockpt(line.m_line) != 0
        || ::ptsname_r(line.m_line, name.data(), name.size()) != 0)
        return fail(Errc::FileUnwritable, "a pseudo-terminal");
    line.m_held = ::open(name.data(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    termios settings{};
    ::tcgetattr(line.m_held, &settings);
    ::cfmakeraw(&settings);
    ::tcsetattr(line.m_held, TCSANOW, &settings);
    std::error_code error;
    std::filesystem::remove(link, error);
    std::filesystem::create_symlink(name.data(), link, error);
    if (error)
        return fail(Errc::FileUnwritable, link.string());
    line.m_link = link;
    return line;
}

Result<PolarisLine> PolarisLine::tcp(std::uint16_t port)
{
    PolarisLine line;
    line.m_listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    const int yes = 1;
    ::setsockopt(line.m_listener, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    if (::bind(line.m_listener, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0
        || ::listen(line.m_listener, 1) != 0)
        return fail(Errc::AddressInUse, std::to_string(port));
    return line;
}

PolarisLine::PolarisLine(PolarisLine&& other) noexcept
    : m_listener{std::exchange(other.m_listener, -1)},
      m_line{std::exchange(other.m_line, -1)},
      m_held{std::exchange(other.m_held, -1)},
      m_link{std::exchange(other.m_link, {})}
{
}

PolarisLine::~PolarisLine()
{
    for (const int file : {m_listener, m_line, m_held})
        if (file >= 0)
            ::close(file);
    std::error_code ignored;
    if (!m_link.empty())
        std::filesystem::remove(m_link, ignored);
}

/// That the program set at its end of the terminal.
int PolarisLine::rate() const
{
    static const std::map<speed_t, int> kRates{
        {B9600, 9600},     {B19200, 19200},   {B38400, 38400},   {B57600, 57600},
        {B115200, 115200}, {B230400, 230400}, {B921600, 921600},
    };
    termios settings{};
    if (m_held < 0 || ::tcgetattr(m_held, &settings) != 0)
        return 0;
    const auto rate = kRates.find(::cfgetospeed(&settings));
    return rate == kRates.end() ? 0 : rate->second;
}

void PolarisLine::accept()
{
    const int connection = ::accept4(m_listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK);
    if (connection < 0)
        return;
    if (m_line >= 0)
        ::close(m_line);
    m_line = connection;
    const int yes = 1;
    ::setsockopt(m_line, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
}

std::string PolarisLine::read()
{
    std::array<char, 4096> buffer{};
    const ssize_t count = ::read(m_line, buffer.data(), buffer.size());
    if (count == 0 && m_listener >= 0) {
        ::close(m_line); // the program has left; another may come
        m_line = -1;
    }
    return {buffer.data(), std::size_t(std::max<ssize_t>(0, count))};
}

void PolarisLine::write(const std::string& bytes) const
{
    // What a program does not read is lost, as at a serial port.
    if (m_line >= 0)
        static_cast<void>(::write(m_line, bytes.data(), bytes.size()) < 0);
}

PolarisTraffic PolarisLine::serve(PolarisDevice& device,
                                  const std::function<bool(LocalTime now)>& everyTurn)
{
    PolarisTraffic traffic;
    std::vector<PolarisDevice::Reply> underWay;
    for (LocalTime now = monotonicNow(); everyTurn(now); now = monotonicNow()) {
        for (const PolarisDevice::Reply& reply : underWay)
            if (reply.at <= now) {
                write(reply.bytes);
                ++traffic.replies;
                traffic.bytesSent += reply.bytes.size();
            }
        std::erase_if(underWay, [now](const auto& reply) { return reply.at <= now; });
        LocalTime wake = now + kTurn;
        for (const PolarisDevice::Reply& reply : underWay)
            wake = std::min(wake, reply.at);
        const auto left = std::max(Duration{0}, wake - now).count();
        std::array<pollfd, 2> files{{{m_line, POLLIN, 0}, {m_listener, POLLIN, 0}}};
        const timespec patience{left / 1'000'000'000, left % 1'000'000'000};
        if (::ppoll(files.data(), files.size(), &patience, nullptr) <= 0)
            continue;
        if ((files[1].revents & POLLIN) != 0)
            accept();
        if ((files[0].revents & POLLIN) == 0)
            continue;
        const std::string bytes = read();
        traffic.bytesReceived += bytes.size();
        for (PolarisDevice::Reply& reply :
             device.take(std::as_bytes(std::span{bytes}), rate(), monotonicNow()))
            underWay.push_back(std::move(reply));
    }
    return traffic;
}

} // namespace carina
