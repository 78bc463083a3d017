#pragma once

#include "evaluation/network/lossy_relay.h"

#include <QTcpServer>
#include <QTcpSocket>

#include <memory>

namespace carina::anatomy_test
{

/// Passes a session on from a port of its own: datagrams as they come, and of the connection over
/// which a set is fetched only so many bytes towards the client.
class HeldTransfer
{
public:
    HeldTransfer(std::uint16_t hostPort, qint64 bytes) : m_hostPort{hostPort}, m_bytes{bytes}
    {
        do
            m_datagrams = std::make_unique<LossyRelay>(hostPort, LossyRelay::Paths{}, 1);
        while (!m_server.listen(QHostAddress{QHostAddress::LocalHost}, m_datagrams->port()));
        QObject::connect(&m_server, &QTcpServer::newConnection, [this] {
            while (QTcpSocket* client = m_server.nextPendingConnection())
                pass(*client);
        });
    }

    [[nodiscard]] QString port() const { return QString::number(m_server.serverPort()); }

private:
    void pass(QTcpSocket& client)
    {
        auto* host = new QTcpSocket{&client};
        host->setReadBufferSize(kBuffer);
        QObject::connect(host, &QTcpSocket::connected, &client, [&client, host] {
            host->write(client.readAll());
            QObject::connect(&client, &QTcpSocket::readyRead, host,
                             [&client, host] { host->write(client.readAll()); });
        });
        QObject::connect(host, &QTcpSocket::readyRead, &client, [this, &client, host] {
            const QByteArray some = host->read(m_bytes); // the rest stays where it is
            m_bytes -= some.size();
            client.write(some);
        });
        QObject::connect(&client, &QTcpSocket::disconnected, &client, &QObject::deleteLater);
        host->connectToHost(QHostAddress{QHostAddress::LocalHost}, m_hostPort);
    }

    static constexpr qint64 kBuffer = 65'536;

    std::uint16_t m_hostPort;
    qint64 m_bytes; ///< that may still pass
    std::unique_ptr<LossyRelay> m_datagrams;
    QTcpServer m_server;
};

} // namespace carina::anatomy_test
