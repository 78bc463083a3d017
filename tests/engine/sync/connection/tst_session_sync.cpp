#include "tests/engine/sync/connection/session_world.h"
#include "tests/support/test_class.h"

namespace carina::session_sync_test
{
namespace
{

using namespace std::chrono_literals;

const SimulatedLink::Path kCalm{5ms, 0ms, 0.0, 0.0};
/// Every fault at once: datagrams are lost, doubled and overtake each other.
const SimulatedLink::Path kStorm{20ms, 15ms, 0.2, 0.1};

std::string numbered(std::string text, std::size_t number)
{
    return text.append(std::to_string(number));
}

std::string textOf(const FactRecord& fact)
{
    return {reinterpret_cast<const char*>(fact.body.data()), fact.body.size()};
}

std::size_t count(const std::vector<FactRecord>& log, const std::string& text)
{
    return static_cast<std::size_t>(
        std::ranges::count_if(log, [&](const FactRecord& f) { return textOf(f) == text; }));
}

/// The texts of one author's facts, without joins.
std::vector<std::string> textsBy(const std::vector<FactRecord>& log, ParticipantId author)
{
    std::vector<std::string> texts;
    for (const FactRecord& fact : log)
        if (fact.author == author && textOf(fact).front() != 'J')
            texts.push_back(textOf(fact));
    return texts;
}

} // namespace

class TestSessionSync : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void joinsAndSharesTheLog()
    {
        SessionWorld world{1};
        world.addSite(kCalm);
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.startClient(1, "ben");
        world.run(1s);
        world.propose(0, "rate 20");
        world.run(100ms);
        QCOMPARE(world.session.disk.size(), std::size_t{3});
        QVERIFY(world.site(0).log == world.session.disk);
        QVERIFY(world.site(1).log == world.session.disk);
        QCOMPARE(world.site(0).client->self(), ParticipantId{1});
        QCOMPARE(world.site(1).client->self(), ParticipantId{2});
        QCOMPARE(world.session.disk[2].author, ParticipantId{1});
        QVERIFY(world.site(0).client->waiting().empty());
        QVERIFY(world.site(0).client->isCaughtUp());
        QCOMPARE(world.site(0).client->state(), SyncClient::State::Connected);
    }

    void everyNodeEndsWithTheSameLog_data()
    {
        QTest::addColumn<std::uint32_t>("seed");
        for (std::uint32_t seed = 1; seed <= 8; ++seed)
            QTest::addRow("storm %u", seed) << seed;
    }

    void everyNodeEndsWithTheSameLog()
    {
        QFETCH(std::uint32_t, seed);
        constexpr std::size_t kSites = 4;
        SessionWorld world{seed};
        for (std::size_t i = 0; i < kSites; ++i) {
            world.addSite(kStorm, {std::chrono::seconds{i * 7}, static_cast<int>(i) * 30 - 50});
            world.startClient(i, numbered("site ", i));
        }
        world.run(1s);
        std::vector<std::vector<std::string>> said(kSites);
        std::mt19937 random{seed};
        std::size_t call = 0;
        // Two minutes of session, in which the host dies twice and each site is cut off once.
        world.run(120s, 50ms, [&] {
            ++call;
            if (call == 500 || call == 1500)
                world.crashHost();
            if (call == 520 || call == 1540)
                world.startHost();
            const std::size_t i = random() % kSites;
            world.site(i).toHost.setCut(call % 2000 > 1000 && call % 2000 < 1100 && i == 1);
            world.site(i).fromHost.setCut(call % 1700 > 900 && call % 1700 < 990 && i == 2);
            if (call % 3 == 0) {
                said[i].push_back(numbered("s", call));
                world.propose(i, said[i].back());
            }
        });
        for (std::size_t i = 0; i < kSites; ++i) {
            world.site(i).toHost.setCut(false);
            world.site(i).fromHost.setCut(false);
        }
        world.run(15s);
        for (std::size_t i = 0; i < kSites; ++i) {
            QVERIFY(world.site(i).log == world.session.disk);
            QVERIFY(world.site(i).client->waiting().empty());
            // Everything that was said is there, once and in the order in which it was said.
            const ParticipantId self = world.site(i).client->self();
            QVERIFY(textsBy(world.session.disk, self) == said[i]);
        }
    }

    void sameSeedGivesTheSameRun()
    {
        std::vector<FactRecord> logs[2];
        std::size_t bytes[2]{};
        for (int run = 0; run < 2; ++run) {
            SessionWorld world{99};
            world.addSite(kStorm);
            world.addSite(kStorm);
            world.startClient(0, "a");
            world.startClient(1, "b");
            std::size_t call = 0;
            world.run(20s, 100ms, [&] {
                world.propose(call % 2, numbered("p", call));
                ++call;
            });
            logs[run] = world.session.disk;
            bytes[run] = world.site(0).fromHost.sentBytes() + world.site(1).toHost.sentBytes();
        }
        QVERIFY(logs[0] == logs[1]);
        QCOMPARE(bytes[0], bytes[1]);
    }

    void lateJoinerGetsTheWholeLog()
    {
        SessionWorld world{3};
        world.addSite(kCalm);
        world.startClient(0, "early");
        world.run(500ms);
        for (std::size_t i = 0; i < 500; ++i)
            world.propose(0, numbered("fact ", i));
        world.run(10s);
        QCOMPARE(world.session.disk.size(), std::size_t{501});
        world.addSite(kStorm);
        world.startClient(1, "late");
        world.run(10s);
        QVERIFY(world.site(1).log == world.session.disk);
    }

    void proposalWhileTheHostIsAwayArrivesOnce()
    {
        SessionWorld world{4};
        world.addSite(kStorm);
        world.addSite(kStorm);
        world.startClient(0, "anna");
        world.startClient(1, "ben");
        world.run(2s);
        world.crashHost();
        world.propose(0, "while away");
        world.run(10s);
        QCOMPARE(world.site(0).client->state(), SyncClient::State::Away);
        QCOMPARE(world.site(0).client->waiting().size(), std::size_t{1});
        world.startHost();
        world.run(3s);
        QCOMPARE(count(world.session.disk, "while away"), std::size_t{1});
        QVERIFY(world.site(0).log == world.session.disk);
        QVERIFY(world.site(1).log == world.session.disk);
        QVERIFY(world.site(0).client->waiting().empty());
        QCOMPARE(world.site(0).timesStartedAfresh, 0);
    }

    void refusedProposalComesBackWithItsReason()
    {
        SessionWorld world{14};
        world.addSite(kStorm);
        world.startClient(0, "anna");
        world.run(1s);
        world.propose(0, "X impossible");
        world.propose(0, "possible");
        world.run(3s);
        QCOMPARE(world.site(0).refused.size(), std::size_t{1});
        QVERIFY(world.site(0).refused[0].proposal.body == TestSession::body("X impossible"));
        QCOMPARE(world.site(0).refused[0].reason, Errc::OutOfRange);
        QVERIFY(world.site(0).client->waiting().empty());
        QCOMPARE(count(world.site(0).log, "possible"), std::size_t{1});
    }

    void anotherSessionStartsAfresh()
    {
        SessionWorld world{15};
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(1s);
        world.propose(0, "of the first session");
        world.run(1s);
        world.crashHost();
        world.propose(0, "never sent");
        world.run(5s);
        world.session.disk.clear();
        world.startHost(std::byte{2});
        world.run(2s);
        QCOMPARE(world.site(0).timesStartedAfresh, 1);
        QVERIFY(world.site(0).log == world.session.disk);
        QCOMPARE(world.session.disk.size(), std::size_t{1});
        QVERIFY(world.site(0).client->waiting().empty());
    }

    void proposalsFromBeforeTheWelcomeArrive()
    {
        SessionWorld world{16};
        world.addSite(kStorm);
        world.crashHost();
        world.startClient(0, "anna");
        world.propose(0, "early");
        world.run(5s);
        world.startHost();
        world.run(3s);
        QCOMPARE(count(world.session.disk, "early"), std::size_t{1});
        QCOMPARE(world.site(0).timesStartedAfresh, 0);
    }

    void largestProposalsArriveInOrder()
    {
        SessionWorld world{17};
        world.addSite(kStorm);
        world.startClient(0, "anna");
        world.run(1s);
        std::vector<std::string> said;
        for (char letter = 'a'; letter <= 'z'; ++letter) {
            said.emplace_back(kLargestFactBody - (letter % 3) * 500U, letter);
            world.propose(0, said.back());
        }
        world.run(30s);
        QVERIFY(textsBy(world.session.disk, ParticipantId{1}) == said);
        QVERIFY(world.site(0).log == world.session.disk);
    }

    void manyParticipantsGetWhatIsNewTogether_data()
    {
        QTest::addColumn<int>("participants");
        QTest::addColumn<bool>("together");
        QTest::newRow("few") << 8 << false;
        QTest::newRow("many") << 40 << true;
    }

    /// A fact every 4 ms for a second, of which all are sent within a tick and a round trip.
    void manyParticipantsGetWhatIsNewTogether()
    {
        QFETCH(const int, participants);
        QFETCH(const bool, together);
        constexpr int kFacts = 250;
        SessionWorld world{18};
        for (int i = 0; i < participants; ++i)
            world.startClient(world.addSite(kCalm), "name " + std::to_string(i));
        world.run(3s);
        const std::size_t before = world.site(1).fromHost.sent();
        int said = 0;
        world.run(1s, 4ms, [&] { world.propose(0, "fact " + std::to_string(++said)); });
        const std::size_t datagrams = world.site(1).fromHost.sent() - before;
        QVERIFY(said >= kFacts - 1);
        world.run(50ms);
        for (int i = 1; i < participants; ++i)
            QVERIFY(world.site(std::size_t(i)).log == world.session.disk);
        if (together)
            QVERIFY2(datagrams <= 62, qPrintable(QString::number(datagrams)));
        else
            QVERIFY2(datagrams >= kFacts - 5, qPrintable(QString::number(datagrams)));
    }
};

CARINA_TEST(TestSessionSync)

} // namespace carina::session_sync_test

#include "tst_session_sync.moc"
