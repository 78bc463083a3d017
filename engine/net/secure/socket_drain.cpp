#include "engine/net/secure/socket_drain.h"

#include "engine/core/monotonic_clock.h"

#include <algorithm>
#include <array>
#include <utility>

#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

namespace carina
{
namespace
{

constexpr int kLook_ms = 20; ///< after which it is looked whether the thread is to end
/// At once, so that it does not go on for ever beside somebody who sends as fast as it reads.
constexpr int kMostAtOnce = 1024;

bool hasSome(int socket)
{
    pollfd wish{.fd = socket, .events = POLLIN, .revents = 0};
    return poll(&wish, 1, kLook_ms) > 0;
}

std::uint16_t portOf(const sockaddr_storage& address)
{
    return ntohs(address.ss_family == AF_INET6
                     ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
                     : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

/// @returns nothing where none is there, or the system reports a fault of an earlier one.
std::optional<RawDatagram> readOne(int socket)
{
    std::array<char, kLongestRaw + 1> buffer;
    sockaddr_storage from{};
    iovec bytes{.iov_base = buffer.data(), .iov_len = buffer.size()};
    msghdr message{};
    message.msg_name = &from;
    message.msg_namelen = sizeof from;
    message.msg_iov = &bytes;
    message.msg_iovlen = 1;
    const ssize_t size = recvmsg(socket, &message, MSG_DONTWAIT);
    if (size < 0)
        return std::nullopt;
    RawDatagram datagram;
    datagram.arrived = monotonicNow();
    datagram.bytes = QByteArray{buffer.data(), size}; // no longer than that: thousands may wait
    datagram.from = normalised(QHostAddress{reinterpret_cast<const sockaddr*>(&from)});
    datagram.port = portOf(from);
    return datagram;
}

} // namespace

SocketDrain::SocketDrain(qintptr socket, std::function<void()> onNews)
    : m_socket{socket},
      m_onNews{std::move(onNews)},
      m_thread{[this](const std::stop_token& stopping) { work(stopping); }}
{
}

void SocketDrain::work(const std::stop_token& stopping)
{
    LocalTime patientFrom{};
    while (!stopping.stop_requested()) {
        if (!hasSome(int(m_socket)))
            continue;
        const LocalTime now = monotonicNow();
        if (now >= patientFrom)
            m_thread.rest(kOwnersTurn, stopping);
        if (drain() >= kMany)
            patientFrom = now + kFlood;
    }
}

int SocketDrain::drain()
{
    int read = 0;
    bool isNews = false;
    for (; read < kMostAtOnce; ++read) {
        const Hold hold{m_mutex};
        const auto kept = readNext();
        if (!kept)
            break;
        if (*kept)
            isNews = isNews || !std::exchange(m_hasTold, true);
    }
    if (isNews)
        m_onNews();
    return read;
}

std::optional<bool> SocketDrain::readNext()
{
    auto datagram = readOne(int(m_socket));
    if (!datagram)
        return std::nullopt;
    if (!isSizeOfRaw(datagram->bytes.size()))
        return false;
    const Endpoint from = endpoint(datagram->from, datagram->port);
    const bool isKnown = std::ranges::binary_search(m_known, from);
    m_read.add(from, *std::move(datagram), isKnown);
    return true;
}

std::vector<RawDatagram> SocketDrain::take(const Hold& /*hold*/)
{
    m_hasTold = false;
    std::vector<RawDatagram> all;
    while (auto datagram = m_read.next())
        all.push_back(*std::move(datagram));
    return all;
}

void SocketDrain::setKnown(std::vector<Endpoint> known, const Hold& /*hold*/)
{
    m_known = std::move(known);
}

} // namespace carina
