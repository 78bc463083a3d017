#include "engine/net/secure/socket_drain.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>

namespace carina::socket_drain_test
{
namespace
{

constexpr int kFits = 100; ///< datagrams that any system keeps of a socket
constexpr int kRounds = 6;
const QHostAddress kHere{QHostAddress::LocalHost};

/// A socket that nobody reads but its drain.
struct Drained {
    QUdpSocket socket;
    std::atomic<int> news = 0;
    std::unique_ptr<SocketDrain> drain;
    std::vector<RawDatagram> taken;

    Drained()
    {
        socket.bind(kHere);
        drain = std::make_unique<SocketDrain>(socket.socketDescriptor(), [this] { ++news; });
        drain->start();
    }
    [[nodiscard]] quint16 port() const { return socket.localPort(); }
    void know(std::initializer_list<std::reference_wrapper<const QUdpSocket>> sources)
    {
        std::vector<Endpoint> known;
        for (const QUdpSocket& source : sources)
            known.push_back(endpoint(kHere, source.localPort()));
        drain->setKnown(known, drain->hold());
    }
    /// Takes what there is. @returns how many came from this port in all
    std::size_t take(quint16 from)
    {
        for (RawDatagram& datagram : drain->take(drain->hold()))
            taken.push_back(std::move(datagram));
        return std::size_t(std::ranges::count(taken, from, &RawDatagram::port));
    }
};

} // namespace

class TestSocketDrain : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Six hundred come from one, more than a queue keeps of it, and nobody reads; then one of
    /// another.
    void keepsTheOneOfAnotherWhileItsOwnerDoesNotRead()
    {
        Drained drained;
        QUdpSocket flooder;
        QVERIFY(flooder.bind(kHere));
        drained.know({flooder});
        int number = 0;
        for (int round = 0; round < kRounds; ++round) {
            for (int i = 0; i < kFits; ++i)
                flooder.writeDatagram(QByteArray::number(number++), kHere, drained.port());
            QTRY_VERIFY_WITH_TIMEOUT(!drained.socket.hasPendingDatagrams(), kPatience_ms);
        }
        QUdpSocket other;
        QVERIFY(other.bind(kHere));
        other.writeDatagram("one", kHere, drained.port());
        QTRY_VERIFY_WITH_TIMEOUT(drained.take(other.localPort()) > 0, kPatience_ms);

        std::vector<QByteArray> flood;
        std::vector<QByteArray> others;
        for (const RawDatagram& datagram : drained.taken) {
            QCOMPARE(datagram.from, kHere);
            (datagram.port == flooder.localPort() ? flood : others).push_back(datagram.bytes);
        }
        QCOMPARE(others, std::vector<QByteArray>{"one"});
        QCOMPARE(flood.size(), ArrivalQueue::kMostOfOne);
        for (std::size_t i = 0; i < flood.size(); ++i) // the newest, in their order
            QCOMPARE(flood[i].toInt(), number - int(flood.size()) + int(i));
    }

    /// Whoever forges addresses has as many as they like.
    void strangersDoNotPushOutWhoIsKnown()
    {
        Drained drained;
        QUdpSocket friendly;
        QVERIFY(friendly.bind(kHere));
        drained.know({friendly});
        for (int i = 0; i < 2; ++i)
            friendly.writeDatagram("known", kHere, drained.port());
        for (int i = 0; i < 45 * kFits; ++i) { // more than the queue has places
            QUdpSocket stranger;
            stranger.writeDatagram("strange", kHere, drained.port());
            if (i % kFits == 0)
                QTRY_VERIFY_WITH_TIMEOUT(!drained.socket.hasPendingDatagrams(), kPatience_ms);
        }
        QTRY_COMPARE_WITH_TIMEOUT(drained.take(friendly.localPort()), std::size_t{2}, kPatience_ms);
    }

    /// A host that is busy is not called for each of them.
    void tellsOnceUntilItIsAsked()
    {
        Drained drained;
        QUdpSocket sender;
        for (int i = 0; i < 5; ++i) {
            sender.writeDatagram("news", kHere, drained.port());
            QTRY_VERIFY_WITH_TIMEOUT(!drained.socket.hasPendingDatagrams(), kPatience_ms);
        }
        QTRY_COMPARE_WITH_TIMEOUT(drained.news.load(), 1, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(drained.take(sender.localPort()), std::size_t{5}, kPatience_ms);
        const int before = drained.news;
        sender.writeDatagram("more", kHere, drained.port());
        QTRY_VERIFY_WITH_TIMEOUT(drained.news > before, kPatience_ms);
    }

    void leavesOutWhatNobodySends()
    {
        Drained drained;
        QUdpSocket sender;
        sender.writeDatagram({}, kHere, drained.port());
        sender.writeDatagram(QByteArray(kLongestRaw + 1, 'x'), kHere, drained.port());
        sender.writeDatagram(QByteArray(kLongestRaw, 'y'), kHere, drained.port());
        QTRY_VERIFY_WITH_TIMEOUT(drained.take(sender.localPort()) > 0, kPatience_ms);
        QCOMPARE(drained.taken.size(), std::size_t{1});
        QCOMPARE(drained.taken.front().bytes, QByteArray(kLongestRaw, 'y'));
    }
};

CARINA_TEST(TestSocketDrain)

} // namespace carina::socket_drain_test

#include "tst_socket_drain.moc"
