#include "engine/net/devices/igtl_server.h"

#include "tests/engine/net/devices/igtl_offers.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <QElapsedTimer>
#include <QTcpSocket>

#include <deque>

namespace carina::igtl_server_test
{
namespace
{

using test::soon;
using test::tubeOffer;

constexpr std::size_t kMostRead = 8U << 20U;

std::unique_ptr<IgtlServer> anyServer() { return IgtlServer::listen({"127.0.0.1", 0}).value(); }

/// A client that reads what comes, unless it is slow.
class Client
{
public:
    explicit Client(const IgtlServer& server, bool isSlow = false) : m_isSlow{isSlow}
    {
        if (isSlow)
            m_socket.setReadBufferSize(1);
        m_socket.connectToHost(QStringLiteral("127.0.0.1"), server.port());
    }

    /// The stamp of the newest transform; 0 before there is one.
    std::uint64_t newest()
    {
        if (m_isSlow)
            return 0;
        const QByteArray bytes = m_socket.readAll();
        m_reader.take(std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}));
        while (const auto message = m_reader.next())
            if (*message && std::holds_alternative<IgtlTransform>((*message)->content))
                m_newest = (*message)->stamp;
        return m_newest;
    }
    void send(const QByteArray& bytes) { m_socket.write(bytes); }
    [[nodiscard]] bool isConnected() const
    {
        return m_socket.state() == QAbstractSocket::ConnectedState;
    }
    [[nodiscard]] bool isClosed() const
    {
        return m_socket.state() == QAbstractSocket::UnconnectedState;
    }

private:
    bool m_isSlow;
    QTcpSocket m_socket;
    IgtlReader m_reader{kMostRead};
    std::uint64_t m_newest = 0;
};

} // namespace

class IgtlServerTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsAPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("address"); // empty: it is none
        QTest::addColumn<int>("port");
        QTest::addColumn<bool>("isLoopback");
        const auto row = [](const char* text, const char* address, int port, bool isLoopback) {
            QTest::newRow(text) << QByteArray{text} << QByteArray{address} << port << isLoopback;
        };
        row("18944", "127.0.0.1", 18944, true);
        row("127.0.0.1:1", "127.0.0.1", 1, true);
        row("0.0.0.0:18944", "0.0.0.0", 18944, false);
        row("192.0.2.7:18944", "192.0.2.7", 18944, false);
        row("[::1]:18944", "::1", 18944, true);
        row("[::]:18944", "::", 18944, false);
        for (const char* text :
             {"", "x", "-1", "65536", ":1", "host:1", "::1", "192.0.2.7", "[::1]"})
            row(text, "", 0, false);
    }

    void readsAPlace()
    {
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArray, address);
        QFETCH(const int, port);
        QFETCH(const bool, isLoopback);
        const auto place = IgtlPlace::read(text.toStdString());
        QCOMPARE(place.has_value(), !address.isEmpty());
        if (!place) {
            QCOMPARE(place.error().code, Errc::WrongAddress);
            return;
        }
        QCOMPARE(place->address, address.toStdString());
        QCOMPARE(int(place->port), port);
        QCOMPARE(place->isLoopback(), isLoopback);
    }

    void saysThatThePortIsTaken()
    {
        const auto first = anyServer();
        const auto second = IgtlServer::listen({"127.0.0.1", first->port()});
        QVERIFY(!second);
        QCOMPARE(second.error().code, Errc::AddressInUse);
        const auto elsewhere = IgtlServer::listen({"192.0.2.7", 0}); // of no computer (RFC 5737)
        QVERIFY(!elsewhere);
        QCOMPARE(elsewhere.error().code, Errc::WrongAddress);
    }

    void listensOnThisComputerOnlyUnlessToldOtherwise() { QVERIFY(IgtlPlace{}.isLoopback()); }

    /// The surface is of 1.2 MB, and ten a second are sent: one that reads nothing is owed more
    /// than any socket holds.
    void letsNobodyWaitForASlowClient()
    {
        const auto server = anyServer();
        Client slow{*server, true};
        Client quick{*server};
        QVERIFY(soon([&] { return server->clients() == 2; }));
        std::uint64_t stamp = 0;
        QElapsedTimer running;
        running.start();
        QVERIFY(soon(
            [&] {
                server->give(tubeOffer(++stamp, 0.0, 100'000));
                return running.elapsed() > 3000 && quick.newest() > 0;
            },
            std::chrono::seconds{20}));
        const std::uint64_t last = stamp;
        QVERIFY(soon([&] { return quick.newest() >= last; }));
        QVERIFY(slow.isConnected());
    }

    void turnsAwayTooManyClients()
    {
        const auto server = anyServer();
        std::deque<Client> clients;
        for (int i = 0; i < IgtlServer::kMostClients; ++i)
            clients.emplace_back(*server);
        QVERIFY(soon([&] { return server->clients() == IgtlServer::kMostClients; }));
        Client another{*server};
        QVERIFY(soon([&] { return another.isClosed(); }));
        clients.pop_back();
        QVERIFY(soon([&] { return server->clients() == IgtlServer::kMostClients - 1; }));
        Client next{*server};
        QVERIFY(soon([&] { return server->clients() == IgtlServer::kMostClients; }));
        QVERIFY(soon([&] { return next.isConnected(); }));
    }

    void disconnectsWhoSendsSomethingElse()
    {
        const auto server = anyServer();
        server->give(tubeOffer(1));
        Client client{*server};
        QVERIFY(soon([&] { return client.isConnected(); }));
        client.send("GET / HTTP/1.1\r\nHost: somewhere.example\r\nAccept: */*\r\n\r\n\r\n\r\n");
        QVERIFY(soon([&] { return client.isClosed(); }));
    }
};

CARINA_TEST(IgtlServerTest)

} // namespace carina::igtl_server_test

#include "tst_igtl_server.moc"
