#include "engine/net/devices/igtl_server.h"

#include "engine/core/expects.h"
#include "engine/core/monotonic_clock.h"
#include "engine/net/devices/keep_alive.h"

#include <QHostAddress>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr qint64 kReadAtOnce = 64 * 1024;
constexpr int kLookAtClients_ms = 100;
constexpr Duration kLongestStall = std::chrono::seconds{10};

} // namespace

bool IgtlPlace::isLoopback() const
{
    return QHostAddress{QString::fromStdString(address)}.isLoopback();
}

Result<IgtlPlace> IgtlPlace::read(const std::string& text)
{
    const QString words = QString::fromStdString(text);
    const qsizetype colon = words.lastIndexOf(QLatin1Char{':'});
    bool isNumber = false;
    const int port = words.mid(colon + 1).toInt(&isNumber);
    if (!isNumber || port < 0 || port > 0xFFFF)
        return fail(Errc::WrongAddress, text);
    IgtlPlace place;
    place.port = static_cast<std::uint16_t>(port);
    if (colon < 0)
        return place;
    QString address = words.left(colon);
    if (address.startsWith(QLatin1Char{'['}) && address.endsWith(QLatin1Char{']'}))
        address = address.mid(1, address.size() - 2);
    else if (address.contains(QLatin1Char{':'}))
        return fail(Errc::WrongAddress, text); // its last part may be no port
    if (QHostAddress{address}.isNull())
        return fail(Errc::WrongAddress, text);
    place.address = address.toStdString();
    return place;
}

/// One client and its socket, which closes when this goes.
struct IgtlServer::Client {
    Client(QTcpSocket* accepted, LocalTime now) : socket{accepted}, subscriber{now}, moved{now} {}

    std::unique_ptr<QTcpSocket> socket;
    IgtlSubscriber subscriber;
    LocalTime moved; ///< when it last took something, or nothing was waiting for it
};

/// The socket that listens, and the clients, on the server's thread.
class IgtlServer::Listener : public QObject
{
public:
    explicit Listener(IgtlServer& server) : m_server{server}
    {
        connect(&m_tcp, &QTcpServer::newConnection, this, [this] { welcome(); });
        connect(&m_look, &QTimer::timeout, this, [this] { serveAll(); });
    }

    [[nodiscard]] Result<std::uint16_t> begin(const IgtlPlace& place)
    {
        if (!m_tcp.listen(QHostAddress{QString::fromStdString(place.address)}, place.port))
            return fail(m_tcp.serverError() == QAbstractSocket::AddressInUseError
                            ? Errc::AddressInUse
                            : Errc::WrongAddress,
                        place.address + ":" + std::to_string(place.port));
        m_look.start(kLookAtClients_ms);
        return m_tcp.serverPort();
    }

    void end()
    {
        m_look.stop();
        m_tcp.close();
        for (const auto& client : m_clients)
            client->socket->disconnect(this);
        m_clients.clear();
    }

    void serveAll()
    {
        m_offer = m_server.taken();
        const LocalTime now = monotonicNow();
        for (const auto& client : m_clients)
            serve(*client, now);
        std::erase_if(m_clients, [](const auto& client) {
            return client->socket->state() != QAbstractSocket::ConnectedState;
        });
        m_server.m_clients = int(m_clients.size());
    }

private:
    void welcome()
    {
        while (QTcpSocket* socket = m_tcp.nextPendingConnection()) {
            if (m_clients.size() >= kMostClients) {
                socket->abort();
                socket->deleteLater();
                continue;
            }
            socket->setParent(nullptr);
            socket->setReadBufferSize(kReadAtOnce);
            socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
            keepAlive(*socket);
            auto client = std::make_unique<Client>(socket, monotonicNow());
            connect(socket, &QIODevice::readyRead, this,
                    [this, c = client.get()] { serve(*c, monotonicNow()); });
            connect(socket, &QIODevice::bytesWritten, this,
                    [c = client.get()] { c->moved = monotonicNow(); });
            m_clients.push_back(std::move(client));
        }
        m_server.m_clients = int(m_clients.size());
    }

    void serve(Client& client, LocalTime now)
    {
        QTcpSocket& socket = *client.socket;
        if (socket.state() != QAbstractSocket::ConnectedState)
            return;
        const QByteArray bytes = socket.readAll();
        client.subscriber.take(
            std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}));
        const qint64 waiting = socket.bytesToWrite();
        if (waiting == 0)
            client.moved = now;
        if (client.subscriber.isLost() || now - client.moved > kLongestStall)
            return socket.abort(); // and serveAll() forgets it
        if (!m_offer || waiting > kMostWaiting)
            return;
        const std::vector<std::byte> due = client.subscriber.due(*m_offer, now);
        if (!due.empty())
            socket.write(reinterpret_cast<const char*>(due.data()), qint64(due.size()));
    }

    IgtlServer& m_server;
    QTcpServer m_tcp{this};
    QTimer m_look{this};
    std::shared_ptr<const IgtlOffer> m_offer;
    std::vector<std::unique_ptr<Client>> m_clients;
};

Result<std::unique_ptr<IgtlServer>> IgtlServer::listen(const IgtlPlace& place)
{
    std::unique_ptr<IgtlServer> server{new IgtlServer};
    Result<std::uint16_t> port = 0;
    QMetaObject::invokeMethod(
        server->m_listener.get(),
        [&, listener = server->m_listener.get()] { port = listener->begin(place); },
        Qt::BlockingQueuedConnection);
    if (!port)
        return tl::unexpected(port.error());
    server->m_port = *port;
    return server;
}

IgtlServer::IgtlServer() : m_listener{std::make_unique<Listener>(*this)}
{
    m_thread.setObjectName(QStringLiteral("carina-igtl-out"));
    m_listener->moveToThread(&m_thread);
    m_thread.start();
}

IgtlServer::~IgtlServer()
{
    QMetaObject::invokeMethod(
        m_listener.get(), [listener = m_listener.get()] { listener->end(); },
        Qt::BlockingQueuedConnection);
    m_thread.quit();
    m_thread.wait();
}

void IgtlServer::give(std::shared_ptr<const IgtlOffer> offer)
{
    CARINA_EXPECTS(offer && offer->landmarks);
    {
        const std::lock_guard lock{m_mutex};
        m_offer = std::move(offer);
        if (std::exchange(m_isAnnounced, true))
            return;
    }
    QMetaObject::invokeMethod(m_listener.get(),
                              [listener = m_listener.get()] { listener->serveAll(); });
}

std::shared_ptr<const IgtlOffer> IgtlServer::taken()
{
    const std::lock_guard lock{m_mutex};
    m_isAnnounced = false;
    return m_offer;
}

} // namespace carina
