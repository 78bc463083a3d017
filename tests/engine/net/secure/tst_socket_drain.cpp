#include "engine/net/secure/socket_drain.h"
#include "tests/support/test_class.h"

#include <atomic>

namespace carina::socket_drain_test
{
namespace
{

constexpr int kSoonMs = 5000;
constexpr int kFits = 100; ///< datagrams that any system keeps of a socket
constexpr int kRounds = 6;
const QHostAddress kHere{QHostAddress::LocalHost};

} // namespace

class TestSocketDrain : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Six times as many as fit come from one, and nobody reads; then one of another.
    void keepsTheOneOfAnotherWhileItsOwnerDoesNotRead()
    {
        QUdpSocket socket;
        QVERIFY(socket.bind(kHere));
        std::atomic<int> news = 0;
        SocketDrain drain{socket.socketDescriptor(), [&news] { ++news; }};
        drain.start();

        QUdpSocket flooder;
        QVERIFY(flooder.bind(kHere));
        int number = 0;
        for (int round = 0; round < kRounds; ++round) {
            for (int i = 0; i < kFits; ++i)
                flooder.writeDatagram(QByteArray::number(number++), kHere, socket.localPort());
            QTRY_VERIFY_WITH_TIMEOUT(!socket.hasPendingDatagrams(), kSoonMs);
        }
        QUdpSocket other;
        QVERIFY(other.bind(kHere));
        const int before = news;
        other.writeDatagram("one", kHere, socket.localPort());
        QTRY_VERIFY_WITH_TIMEOUT(news > before, kSoonMs);

        std::vector<QByteArray> flood;
        std::vector<QByteArray> others;
        for (const RawDatagram& datagram : drain.take()) {
            QCOMPARE(datagram.from, kHere);
            (datagram.port == flooder.localPort() ? flood : others).push_back(datagram.bytes);
        }
        QCOMPARE(others, std::vector<QByteArray>{"one"});
        QCOMPARE(flood.size(), ArrivalQueue::kMostOfOne);
        for (std::size_t i = 0; i < flood.size(); ++i) // the newest, in their order
            QCOMPARE(flood[i].toInt(), number - int(flood.size()) + int(i));
        QVERIFY(drain.take().empty());
    }

    void leavesOutWhatNobodySends()
    {
        QUdpSocket socket;
        QVERIFY(socket.bind(kHere));
        std::atomic<int> news = 0;
        SocketDrain drain{socket.socketDescriptor(), [&news] { ++news; }};
        drain.start();
        QUdpSocket sender;
        sender.writeDatagram({}, kHere, socket.localPort());
        sender.writeDatagram(QByteArray(kLongestRaw + 1, 'x'), kHere, socket.localPort());
        sender.writeDatagram(QByteArray(kLongestRaw, 'y'), kHere, socket.localPort());
        std::vector<RawDatagram> taken;
        const auto take = [&] {
            for (RawDatagram& datagram : drain.take())
                taken.push_back(std::move(datagram));
            return taken.size();
        };
        QTRY_VERIFY_WITH_TIMEOUT(take() >= 1, kSoonMs);
        QCOMPARE(taken.size(), std::size_t{1});
        QCOMPARE(taken.front().bytes, QByteArray(kLongestRaw, 'y'));
    }
};

CARINA_TEST(TestSocketDrain)

} // namespace carina::socket_drain_test

#include "tst_socket_drain.moc"
