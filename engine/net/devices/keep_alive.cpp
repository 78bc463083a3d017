#include "engine/net/devices/keep_alive.h"

#include <QAbstractSocket>
#include <QVariant>

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace carina
{
namespace
{

constexpr int kIdleBeforeProbe_s = 4;
constexpr int kBetweenProbes_s = 2;
constexpr int kProbes = 3;
constexpr unsigned kUnacknowledged_ms = 10'000;

} // namespace

void keepAlive(QAbstractSocket& socket)
{
    socket.setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    const auto descriptor = int(socket.socketDescriptor());
    // Each of them may fail without harm: then only the system's own patience holds.
    const auto set = [&](int option, const auto& value) {
        static_cast<void>(setsockopt(descriptor, IPPROTO_TCP, option, &value, sizeof value));
    };
    set(TCP_KEEPIDLE, kIdleBeforeProbe_s);
    set(TCP_KEEPINTVL, kBetweenProbes_s);
    set(TCP_KEEPCNT, kProbes);
    set(TCP_USER_TIMEOUT, kUnacknowledged_ms);
}

} // namespace carina
