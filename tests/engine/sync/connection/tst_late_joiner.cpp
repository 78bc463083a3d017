#include "tests/engine/sync/connection/session_world.h"
#include "tests/support/test_class.h"

namespace carina::late_joiner_test
{
namespace
{

using namespace std::chrono_literals;

constexpr std::uint64_t kFacts = 60'000;

std::vector<FactRecord> longLog()
{
    std::vector<FactRecord> log;
    for (std::uint64_t number = 1; number <= kFacts; ++number)
        log.push_back({FactNumber{number}, ProposalId{number}, ParticipantId{1}, StationId{},
                       SessionTime{}, SessionTime{}, TestSession::body("12 bytes at a")});
    return log;
}

} // namespace

/// Who joins a session of 60 000 facts.
class TestLateJoiner : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void longLogComesInTwoSeconds_data()
    {
        QTest::addColumn<double>("loss");
        QTest::addColumn<int>("most_ms");
        QTest::newRow("round trip of 40 ms") << 0.0 << 2000;
        QTest::newRow("and a datagram in a thousand lost") << 0.001 << 6000;
    }

    void longLogComesInTwoSeconds()
    {
        QFETCH(const double, loss);
        QFETCH(const int, most_ms);
        SessionWorld world{71};
        world.session.disk = longLog();
        world.startHost();
        world.addSite({20ms, 0ms, loss, 0.0});
        world.startClient(0, "late");
        Duration waited{};
        while (waited < 60s && world.site(0).log.size() <= kFacts) {
            world.run(20ms);
            waited += 20ms;
        }
        qInfo("%.2f s, %zu datagrams", toSeconds(waited), world.site(0).fromHost.sent());
        QVERIFY(world.site(0).log == world.session.disk);
        QVERIFY(waited <= std::chrono::milliseconds{most_ms});
    }
};

CARINA_TEST(TestLateJoiner)

} // namespace carina::late_joiner_test

#include "tst_late_joiner.moc"
