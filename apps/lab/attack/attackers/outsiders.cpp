#include "apps/lab/attack/attackers/outsiders.h"

#include "engine/core/monotonic_clock.h"

#include <algorithm>
#include <array>
#include <utility>

namespace carina::lab
{
namespace
{

class ClientHellos : public Attack
{
public:
    explicit ClientHellos(const Target& target) : m_port{target.port}
    {
        // The first datagram of a handshake, sent to a socket of our own.
        QUdpSocket ear;
        ear.bind(QHostAddress::LocalHost);
        m_socket.bind(QHostAddress::LocalHost);
        QDtls dtls{QSslSocket::SslClientMode};
        dtls.setPeer(QHostAddress{QHostAddress::LocalHost}, ear.localPort());
        prepareDtls(dtls, QByteArray{});
        dtls.doHandshake(&m_socket);
        if (ear.waitForReadyRead(1000))
            if (const auto datagram = readRaw(ear))
                m_hello = datagram->bytes;
    }

    void step() override
    {
        const QHostAddress host{QHostAddress::LocalHost};
        for (int i = 0; i < kHellos && !m_hello.isEmpty(); ++i)
            m_sent += m_socket.writeDatagram(m_hello, host, m_port) == m_hello.size() ? 1 : 0;
        while (readRaw(m_socket))
            ++m_answered;
    }
    [[nodiscard]] std::int64_t sent() const override { return m_sent; }
    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        static_cast<void>(length);
        return {atLeast(kLeastAnswered, "ClientHellos that the host answered", m_answered)};
    }

private:
    static constexpr double kLeastAnswered = 100.0;
    static constexpr int kHellos = 5;
    std::uint16_t m_port;
    QUdpSocket m_socket;
    QByteArray m_hello;
    std::int64_t m_sent = 0;
    std::int64_t m_answered = 0; ///< with a cookie
};

class IdlePaths : public Attack
{
public:
    explicit IdlePaths(const Target& target)
        : m_target{target},
          m_credentials{Role::Observer, target.codes.at(Role::Observer),
                        TokenFolder{{}, Role::Observer, "Intruder"}, target.derive}
    {
    }

    void step() override
    {
        const LocalTime now = monotonicNow();
        std::int64_t open = 0;
        for (Idle& idle : m_paths) {
            idle.path->serve([](std::span<const std::byte>, LocalTime) {});
            if (idle.path->state() != ClientPath::State::Encrypted)
                continue;
            ++open;
            m_opened += std::exchange(idle.wasOpen, true) ? 0 : 1;
        }
        m_mostOpen = std::max(m_mostOpen, open);
        if (now < m_next)
            return;
        m_next = now + std::chrono::milliseconds{15};
        if (m_paths.size() == kPaths)
            m_paths.erase(m_paths.begin());
        m_paths.push_back({std::make_unique<ClientPath>(
            QHostAddress{QHostAddress::LocalHost}, m_target.port, m_credentials, m_nothing, [] {},
            now, HostPlace::Told, m_target.from)});
    }
    [[nodiscard]] std::int64_t sent() const override { return m_opened; }
    [[nodiscard]] std::int64_t mostPaths() const override { return m_mostOpen; }

private:
    static constexpr std::size_t kPaths = 400;

    struct Idle {
        std::unique_ptr<ClientPath> path;
        bool wasOpen = false;
    };

    Target m_target;
    ClientCredentials m_credentials;
    std::optional<ExpectedCertificate> m_nothing;
    std::vector<Idle> m_paths;
    LocalTime m_next{};
    std::int64_t m_opened = 0; ///< that came to be encrypted
    std::int64_t m_mostOpen = 0;
};

class Strangers : public Attack
{
public:
    explicit Strangers(const Target& target) : m_way{wayIn(target, Role::Observer)} {}

    void step() override
    {
        for (std::unique_ptr<Intruder>& path : m_paths) {
            if (path && path->ended() > 0) {
                ++m_ended;
                m_before += std::exchange(path, nullptr)->sent();
            }
            if (!path)
                path = std::make_unique<Intruder>(m_way);
            if (path->isIn())
                path->send(std::array<WireRecord, 1>{FactAck{}});
        }
        const auto open = std::ranges::count_if(
            m_paths, [](const std::unique_ptr<Intruder>& path) { return path && path->isIn(); });
        m_mostOpen = std::max<std::int64_t>(m_mostOpen, open);
    }
    [[nodiscard]] std::int64_t sent() const override
    {
        std::int64_t sum = m_before;
        for (const auto& path : m_paths)
            sum += path ? path->sent() : 0;
        return sum;
    }
    [[nodiscard]] std::int64_t mostPaths() const override { return m_mostOpen; }

    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        static_cast<void>(length);
        return {atLeast(double(kPaths), "paths that the host ended", m_ended)};
    }

private:
    static constexpr std::size_t kPaths = 16;
    WayIn m_way;
    std::array<std::unique_ptr<Intruder>, kPaths> m_paths;
    std::int64_t m_before = 0; ///< over paths that were ended
    std::int64_t m_ended = 0;
    std::int64_t m_mostOpen = 0;
};

} // namespace

std::unique_ptr<Attack> beginClientHellos(const Target& target)
{
    return std::make_unique<ClientHellos>(target);
}

std::unique_ptr<Attack> beginIdlePaths(const Target& target)
{
    return std::make_unique<IdlePaths>(target);
}

std::unique_ptr<Attack> beginStrangers(const Target& target)
{
    return std::make_unique<Strangers>(target);
}

} // namespace carina::lab
