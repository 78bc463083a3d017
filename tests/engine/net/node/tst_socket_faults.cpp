#include "tests/engine/net/node/nodes.h"
#include "tests/support/patience.h"
#include "tests/support/socket_faults.h"
#include "tests/support/test_class.h"

#include <QUdpSocket>

#include <cerrno>

namespace carina::socket_faults_test
{
namespace
{

namespace faults = test::socket_faults;

constexpr int kMany = 15; // about four seconds of a client that nobody answers

/// A second instructor joins and changes the rate; all is over when both have it as a fact.
void change(SessionNode& host, SessionNode& second, double perMinuteRate)
{
    second.propose(kStation, fact::BreathingRateSet{perMinute(perMinuteRate)});
    QTRY_VERIFY_WITH_TIMEOUT(second.pending().empty(), kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(host), perMinuteRate, kPatience_ms);
    QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(second), perMinuteRate, kPatience_ms);
}

void session(const faults::Plan& plan)
{
    MemoryDisk disk;
    auto instructor = host(disk);
    QVERIFY(instructor);
    faults::begin(plan);
    auto second = join(*instructor, "Dr Rolland", Role::Instructor);
    QTRY_VERIFY_WITH_TIMEOUT(isIn(*second), kPatience_ms);
    change(*instructor, *second, 17.0);
    change(*instructor, *second, 23.0);
    QCOMPARE(second->state()->lastApplied(), instructor->state()->lastApplied());
    QVERIFY(!instructor->refusal());
    QVERIFY(!second->refusal());
    QCOMPARE(faults::struck(), plan.calls);
    faults::begin({});
}

} // namespace

/// Host and client while calls that send or receive fail: nothing crashes, nobody is locked out,
/// and each change becomes a fact at both.
class TestSocketFaults : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { faults::begin({}); }

    void sessionHoldsWhicheverCallFails_data()
    {
        QTest::addColumn<int>("error");
        QTest::newRow("no buffers") << ENOBUFS;
        QTest::newRow("would block") << EAGAIN;
        QTest::newRow("refused by the peer's computer") << ECONNREFUSED;
        QTest::newRow("forbidden") << EPERM;
        QTest::newRow("network is down") << ENETDOWN;
        QTest::newRow("input and output error") << EIO;
    }

    void sessionHoldsWhicheverCallFails()
    {
        QFETCH(int, error);
        constexpr int kFirstCalls = 30; // handshake, join and the first change
        for (int first = 1; first <= kFirstCalls; ++first) {
            session({.first = first, .calls = 1, .error = error});
            if (QTest::currentTestFailed())
                QFAIL(qPrintable(QStringLiteral("call %1").arg(first)));
        }
    }

    void sessionHoldsWhereManyCallsFail_data() { sessionHoldsWhicheverCallFails_data(); }

    void sessionHoldsWhereManyCallsFail()
    {
        QFETCH(int, error);
        for (const int first : {1, 9, 30}) {
            session({.first = first, .calls = kMany, .error = error});
            if (QTest::currentTestFailed())
                QFAIL(qPrintable(QStringLiteral("from call %1 on").arg(first)));
        }
    }

    void theFaultsAreStruck()
    {
        session({.first = 5, .calls = 3, .error = ENOBUFS});
        faults::begin({.first = 2, .calls = 2, .error = ENOBUFS});
        QUdpSocket socket;
        QVERIFY(socket.bind(QHostAddress::LocalHost));
        int refused = 0;
        for (int i = 0; i < 4; ++i)
            refused +=
                socket.writeDatagram("a", 1, QHostAddress::LocalHost, socket.localPort()) < 0;
        QCOMPARE(refused, 2);
        QCOMPARE(faults::struck(), 2);
    }
};

CARINA_TEST(TestSocketFaults)

} // namespace carina::socket_faults_test

#include "tst_socket_faults.moc"
