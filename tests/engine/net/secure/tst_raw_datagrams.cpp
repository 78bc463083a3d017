#include "engine/net/secure/dtls.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

namespace carina::raw_datagrams_test
{
namespace
{

const QHostAddress kHere{QHostAddress::LocalHost};

} // namespace

/// A socket that counts what it got.
struct Ear {
    QUdpSocket socket;
    int heard = 0;

    Ear() { socket.bind(kHere); }
    void readAll()
    {
        while (readRaw(socket))
            ++heard;
    }
    void send(const QByteArray& bytes)
    {
        QUdpSocket sender;
        sender.writeDatagram(bytes, kHere, socket.localPort());
    }
};

class TestRawDatagrams : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A turn that something else began takes the datagram, and the signal comes for nothing.
    void signalComesAgainWhereItsDatagramWasTakenBefore()
    {
        Ear ear;
        connect(&ear.socket, &QUdpSocket::readyRead, &ear.socket, [&ear] { ear.readAll(); });
        for (int round = 1; round <= 5; ++round) {
            ear.send("taken by the turn");
            QMetaObject::invokeMethod(
                &ear.socket, [&ear] { ear.readAll(); }, Qt::QueuedConnection);
            QTRY_COMPARE_WITH_TIMEOUT(ear.heard, 3 * round - 2, kPatience_ms);
            for (int next = 1; next <= 2; ++next) {
                ear.send("told by the signal");
                QTRY_COMPARE_WITH_TIMEOUT(ear.heard, 3 * round - 2 + next, kPatience_ms);
            }
        }
    }

    void emptyAndLongOnesAreSkipped()
    {
        Ear ear;
        ear.send({});
        ear.send(QByteArray(1201, 'x'));
        ear.send(QByteArray(1200, 'y'));
        QTRY_VERIFY_WITH_TIMEOUT(ear.socket.hasPendingDatagrams(), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT((ear.readAll(), ear.heard), 1, kPatience_ms);
    }

    void nothingIsReadWhereNothingIs()
    {
        Ear ear;
        QVERIFY(!readRaw(ear.socket));
        QVERIFY(!readRaw(ear.socket));
    }

    /// The answer of a port that nobody listens at is no datagram, and hides none.
    void refusalOfAPeerHidesNoDatagram()
    {
        Ear ear;
        quint16 closed = 0;
        {
            QUdpSocket other;
            other.bind(kHere);
            closed = other.localPort();
        }
        ear.socket.writeDatagram("anybody?", kHere, closed);
        ear.send("hello");
        QTRY_COMPARE_WITH_TIMEOUT((ear.readAll(), ear.heard), 1, kPatience_ms);
    }
};

CARINA_TEST(TestRawDatagrams)

} // namespace carina::raw_datagrams_test

#include "tst_raw_datagrams.moc"
