#include "evaluation/network/lossy_relay.h"

#include "engine/core/monotonic_clock.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

namespace carina::lossy_relay_test
{
namespace
{

using namespace std::chrono_literals;

const QHostAddress kHere{QHostAddress::LocalHost};

/// A host and a client with a relay between them.
struct Course {
    explicit Course(const LossyRelay::Paths& paths)
    {
        host.bind(kHere, 0);
        client.bind(kHere, 0);
        relay = std::make_unique<LossyRelay>(host.localPort(), paths, 7);
    }
    void sendToHost(const char* text) { client.writeDatagram(text, kHere, relay->port()); }

    QUdpSocket host;
    QUdpSocket client;
    std::unique_ptr<LossyRelay> relay;
};

QByteArray read(QUdpSocket& socket, quint16* port = nullptr)
{
    QByteArray bytes(qsizetype(socket.pendingDatagramSize()), '\0');
    socket.readDatagram(bytes.data(), bytes.size(), nullptr, port);
    return bytes;
}

} // namespace

class LossyRelayTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nothingComesBeforeItsDelay()
    {
        Course course{{{.delay = 20ms}, {.delay = 30ms}}};
        const LocalTime sent = monotonicNow();
        course.sendToHost("there");
        QTRY_VERIFY_WITH_TIMEOUT(course.host.hasPendingDatagrams(), kPatience_ms);
        QVERIFY(monotonicNow() - sent >= 20ms);
        quint16 port = 0;
        QCOMPARE(read(course.host, &port), QByteArray{"there"});
        const LocalTime answered = monotonicNow();
        course.host.writeDatagram("back", kHere, port);
        QTRY_VERIFY_WITH_TIMEOUT(course.client.hasPendingDatagrams(), kPatience_ms);
        QVERIFY(monotonicNow() - answered >= 30ms);
        QCOMPARE(read(course.client), QByteArray{"back"});
        QCOMPARE(course.relay->bytes(), std::uint64_t{9});
    }

    void whatIsDuplicatedComesTwice()
    {
        Course course{{{.duplication = 1.0}, {}}};
        course.sendToHost("twin");
        for (int i = 0; i < 2; ++i) {
            QTRY_VERIFY_WITH_TIMEOUT(course.host.hasPendingDatagrams(), kPatience_ms);
            QCOMPARE(read(course.host), QByteArray{"twin"});
        }
        QCOMPARE(course.relay->toHost().size(), std::size_t{2});
    }

    void pathsBeginWhenTold()
    {
        Course course{{{.cutFrom = 0s, .cutFor = 3600s}, {}}};
        course.sendToHost("before");
        QTRY_VERIFY_WITH_TIMEOUT(course.host.hasPendingDatagrams(), kPatience_ms);
        QCOMPARE(read(course.host), QByteArray{"before"});
        course.relay->beginAt(machineTime(monotonicNow()));
        course.sendToHost("cut");
        QTRY_COMPARE_WITH_TIMEOUT(course.relay->bytes(), std::uint64_t{9}, kPatience_ms);
        QCOMPARE(course.relay->toHost().size(), std::size_t{1});
    }
};

CARINA_TEST(LossyRelayTest)

} // namespace carina::lossy_relay_test

#include "tst_lossy_relay.moc"
