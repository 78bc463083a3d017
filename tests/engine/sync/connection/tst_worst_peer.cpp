#include "engine/sync/connection/shown_relay.h"
#include "engine/sync/wire/datagram_codec.h"
#include "tests/engine/sync/actions/acted_world.h"
#include "tests/support/test_class.h"

namespace carina::worst_peer_test
{
namespace
{

constexpr ObjectId kTube{1};

/// A log of so many facts, of a time before anybody came.
void fill(TestSession& session, std::uint64_t facts)
{
    for (std::uint64_t number = 1; number <= facts; ++number)
        session.disk.push_back({FactNumber{number}, ProposalId{number}, ParticipantId{1},
                                StationId{}, SessionTime{}, SessionTime{},
                                TestSession::body("40 bytes of what was long ago, or so ...")});
}

/// A datagram that the program at a site would not send.
void sendFrom(SessionWorld& world, std::size_t site, std::span<const WireRecord> records)
{
    static std::uint32_t sequence = 1U << 20;
    BundleHeader header;
    header.connection = world.site(site).client->link().connection();
    header.sequence = ++sequence;
    for (const auto& bytes : packDatagrams(records, [&] { return header; }))
        world.host().receive(world.site(site).address, bytes, world.hostTime());
}

std::ptrdiff_t factsOf(const SessionWorld& world, const std::string& text)
{
    return std::ranges::count(world.session.disk, TestSession::body(text), &FactRecord::body);
}

} // namespace

/// What the worst of those who are inside can do to the others, and to the log.
class TestWorstPeer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// One person under twelve names, each of which keeps within its own budget, beside another
    /// program at the same address.
    void manyNamesFromOnePlaceHaveOneBudget()
    {
        constexpr std::size_t kNames = 12;
        constexpr int kSeconds = 10;
        SessionWorld world{51};
        world.session.limits.proposals = 20.0;
        world.session.shared = std::make_shared<SharedBudget>(
            SharedLimits{.datagrams = 1e5, .bytes = 1e8, .proposals = 40.0});
        world.startHost();
        for (std::size_t i = 0; i <= kNames; ++i)
            world.startClient(world.addSite(kCalm), "name " + std::to_string(i));
        world.run(1s);
        QCOMPARE(world.host().peers().size(), kNames + 1);
        QCOMPARE(world.session.shared->members(), kNames + 1);
        int turn = 0;
        world.run(kSeconds * 1s, 55ms, [&] { // 18 a second
            for (std::size_t i = 0; i < kNames; ++i)
                world.propose(i, "flood");
            if (turn++ % 20 == 0)
                world.propose(kNames, "honest");
        });
        world.run(200ms);
        // What each had saved up, and twice 40 a second. By their own budgets it were 2160.
        const auto most =
            std::ptrdiff_t(kNames * SharedBudget::kSavedProposals) + 2 * 40 * (kSeconds + 2);
        QVERIFY2(factsOf(world, "flood") <= most,
                 qPrintable(QString::number(factsOf(world, "flood"))));
        QCOMPARE(factsOf(world, "honest"), std::ptrdiff_t{(turn + 19) / 20});
        QVERIFY(world.site(kNames).refused.empty());
    }

    /// Each coming is a fact, and so is each going.
    void comingAndGoingIsChargedTogether()
    {
        constexpr int kSeconds = 20;
        SessionWorld world{52};
        world.session.limits.comings = 1.0;
        world.startHost();
        world.addSite(kCalm);
        for (int i = 0; i < kSeconds * 10; ++i) {
            world.startClient(0, "anna");
            world.run(80ms);
            world.site(0).client->leave(world.site(0).clock.at(world.now()));
            world.run(20ms);
        }
        const std::size_t facts = world.session.disk.size() + world.session.departures.size();
        QVERIFY2(facts <= 2U * (kSeconds + 2) + 2, qPrintable(QString::number(facts)));
    }

    /// Whoever says that it knows nothing is sent the whole log, once.
    void whoAsksForTheLogOverAndOverIsSentItSlowly()
    {
        constexpr std::uint64_t kFacts = 60'000;
        constexpr int kSeconds = 20;
        SessionWorld world{61};
        fill(world.session, kFacts);
        world.startHost();
        world.addSite(kCalm);
        world.addSite(kCalm);
        world.startClient(1, "honest");
        world.run(2s);
        const std::size_t before = world.site(0).fromHost.sent();
        world.run(kSeconds * 1s, 1s, [&] {
            world.startClient(0, "hungry");
            world.propose(1, "news");
        });
        const double bytes = 1200.0 * double(world.site(0).fromHost.sent() - before);
        const double most =
            PeerBudget::kLogBytesAtOnce + PeerBudget::kLogBytes * (kSeconds + 2) + 2e6;
        QVERIFY2(bytes < most, qPrintable(QString::number(bytes / 1e6)));
        QVERIFY(world.site(1).client->waiting().empty());
    }

    /// Many who come late at once, and one more: each gets its part of what is sent.
    void whoComesLateIsNotLastForEver()
    {
        constexpr std::size_t kHungry = 24;
        constexpr std::uint64_t kFacts = 20'000;
        SessionWorld world{62};
        fill(world.session, kFacts);
        world.startHost();
        for (std::size_t i = 0; i <= kHungry; ++i)
            world.addSite(kCalm);
        for (std::size_t i = 0; i <= kHungry; ++i)
            world.startClient(i, "late " + std::to_string(i));
        world.run(1s);
        std::size_t least = world.site(0).log.size();
        std::size_t most = least;
        for (std::size_t i = 0; i <= kHungry; ++i) {
            least = std::min(least, world.site(i).log.size());
            most = std::max(most, world.site(i).log.size());
        }
        QVERIFY2(double(least) > 0.5 * double(most),
                 qPrintable(QStringLiteral("%1 %2").arg(least).arg(most)));
        QVERIFY(most < kFacts); // or nothing was shared out
    }

    /// Another program of the same participant, whose joining is on its way to the disk.
    void whoIsBarredDoesNotComeInOverAnotherPath()
    {
        SessionWorld world{63};
        world.session.limits.proposals = 10.0;
        world.startHost();
        world.addSite(kCalm);
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(1s);
        world.session.isFast = false;
        world.startClient(1, "anna");
        world.run(3s, 20ms, [&] {
            for (int i = 0; i < 10; ++i)
                world.propose(0, "flood");
        });
        for (std::size_t i = world.host().log().size(); i < world.session.disk.size(); ++i)
            world.host().append(world.session.disk[i]);
        world.run(1s);
        QCOMPARE(world.host().peers().size(), std::size_t{0});
        QCOMPARE(world.site(0).client->helloRefused()->code, Errc::TooMuchSent);
        QCOMPARE(world.site(1).client->helloRefused()->code, Errc::TooMuchSent);
    }

    void repeatsOfWhatIsSettledAreLookedUpWithinALimit()
    {
        SessionWorld world{53};
        world.addSite(kCalm);
        world.startClient(0, "anna");
        world.run(500ms);
        const std::vector<WireRecord> repeats(20, world.proposal("once"));
        world.session.lookUps = 0;
        for (int i = 0; i < 1000; ++i)
            sendFrom(world, 0, repeats);
        QCOMPARE(factsOf(world, "once"), std::ptrdiff_t{1});
        QVERIFY2(world.session.lookUps <= int(2.0 * PeerBudget::kHeardProposals) + 1,
                 qPrintable(QString::number(world.session.lookUps)));
        QVERIFY(!world.host().peers().begin()->second.budget.isFarExceeded());
    }

    /// Its path is slow, or it answers late on purpose: nobody can tell.
    void whoAnswersLateDatesNothingFarAhead()
    {
        ActedWorld world{54, 1, {400ms, 0ms, 0.0, 0.0}};
        world.run(3s);
        const ParticipantId owner = world.self(0);
        world.host().share(kTube, {owner, 1});
        std::uint16_t sequence = 0;
        const auto isTaken = [&](Duration ahead) {
            StreamGroup group{owner, world.host().peers().begin()->second.epoch, StationId{}, {}};
            StreamCpo cpo;
            cpo.object = kTube;
            cpo.sequence = ++sequence;
            cpo.time = world.trueSessionTime() + ahead;
            group.streams.push_back(cpo);
            const WireRecord record = group;
            sendFrom(world, 0, std::span{&record, 1});
            return !world.host().take().streams.empty();
        };
        QVERIFY(!isTaken(56ms));
        QVERIFY(isTaken(54ms));
    }

    void whoOnlyWatchesPutsOffNoChangeForLong()
    {
        SessionWorld world{55};
        world.addSite({900ms, 0ms, 0.0, 0.0});
        world.startClient(0, "late");
        world.run(6s);
        QVERIFY(std::chrono::abs(world.host().slowestPath() - 900ms) < 5ms);
        world.session.observers.insert(world.site(0).client->self());
        QCOMPARE(world.host().slowestPath(), SyncHost::kLongestPathOfWatchers);
    }

    void whoOnlyWatchesAddsNothingToTheLag_data()
    {
        QTest::addColumn<bool>("watches");
        QTest::addColumn<int>("lag_ms");
        // The way of the owner, the farthest other's, and the margin.
        QTest::newRow("one who acts") << false << 5 + 60 + 2;
        QTest::newRow("one who watches") << true << 5 + 5 + 2;
    }
    void whoOnlyWatchesAddsNothingToTheLag()
    {
        QFETCH(const bool, watches);
        QFETCH(const int, lag_ms);
        ActedWorld world{56, 2, kCalm};
        world.addLateSite({60ms, 0ms, 0.0, 0.0});
        world.run(1s);
        if (watches)
            world.session.observers.insert(world.self(2));
        const StrategyChoice lag{.kind = StrategyKind::LocalLag, .longestLag = kLongestLocalLag};
        world.host().setStrategy(lag, world.hostTime());
        world.site(0).client->setStrategy(lag, world.local(0));
        world.run(3s);
        const SessionTime before = world.trueSessionTime();
        QVERIFY(world.turn(0));
        const Duration delayed = world.newest(0)->start - before;
        QVERIFY2(std::chrono::abs(delayed - lag_ms * 1ms) < 3ms,
                 qPrintable(QString::number(toSeconds(delayed))));
    }

    void shownPosesGoOnTwiceAPeriodAtMost()
    {
        ActedWorld world{57, 2, kCalm};
        world.run(500ms);
        const std::size_t before = world.site(1).fromHost.sent();
        SessionTime newest{};
        world.run(2s, [&] {
            newest = world.trueSessionTime();
            world.site(0).client->tellShown({kModel, newest, {}});
        });
        world.run(200ms);
        const auto& shown = world.site(1).shown;
        QVERIFY2(shown.size() >= 16 && shown.size() <= 18,
                 qPrintable(QString::number(shown.size())));
        QVERIFY(shown.back().at >= newest - 2ms); // the newest is not lost
        QVERIFY(world.site(1).fromHost.sent() - before < 100);
    }

    void whatTheMutedShowDoesNotGoOn()
    {
        ActedWorld world{58, 2, kCalm};
        world.session.observers.insert(world.self(0));
        world.site(0).client->tellShown({kModel, world.trueSessionTime(), {}});
        world.run(200ms);
        QVERIFY(world.site(1).shown.empty());
        world.session.observers.clear();
        world.site(0).client->tellShown({kModel, world.trueSessionTime(), {}});
        world.run(200ms);
        QCOMPARE(world.site(1).shown.size(), std::size_t{1});
    }

    /// What honest programs send, four times a second an object, is not put off.
    void shownPosesOfManyObjectsGoOnAtOnce()
    {
        ShownRelay relay;
        const LocalTime now{1h};
        for (int period = 0; period < 8; ++period) {
            const LocalTime then = now + period * ViewComparison::kPeriod;
            for (std::uint16_t object = 1; object <= 8; ++object)
                relay.take({ObjectId{object}, SessionTime{then.time_since_epoch()}, {}},
                           ParticipantId{1}, then);
            QVERIFY(relay.nextDue() <= then);
            QCOMPARE(relay.takeDue(then).size(), std::size_t{8});
            QCOMPARE(relay.nextDue(), LocalTime::max());
        }
    }

    /// One person under many names shows hundreds; an honest one, as often as its program does.
    void shownPosesOfVeryManyObjectsAreBoundedTogetherAndInTurn()
    {
        constexpr std::uint16_t kMany = 1600;
        constexpr std::uint16_t kHonest = kMany + 1;
        ShownRelay relay;
        const LocalTime begin{1h};
        std::ptrdiff_t passed = 0;
        std::ptrdiff_t honest = 0;
        for (LocalTime now = begin; now < begin + 10s; now += 10ms) {
            const SessionTime shown{now.time_since_epoch()};
            for (std::uint16_t object = 1; object <= kMany; ++object)
                relay.take({ObjectId{object}, shown, {}}, ParticipantId{1}, now);
            relay.take({ObjectId{kHonest}, shown, {}}, ParticipantId{2}, now);
            const auto due = relay.takeDue(now);
            passed += std::ssize(due);
            honest += std::ranges::count(due, ParticipantId{2}, &ShownRelay::Passed::from);
        }
        QVERIFY(passed <= 128 + 10 * 512);
        QVERIFY(passed > 10 * 512 - 128);
        QVERIFY2(honest >= 3 && honest <= 4, qPrintable(QString::number(honest)));
    }

    /// Four hundred changes in a second are allowed; the others are sent the newest 64 times.
    void rapidActionsGoOnTogether()
    {
        ActedWorld world{59, 2, kCalm};
        QVERIFY(world.turn(0));
        world.run(500ms);
        const std::size_t before = world.site(1).fromHost.sent();
        int acted = 0;
        world.SessionWorld::run(5s, 2500us, [&] { acted += world.turn(0) ? 1 : 0; });
        QVERIFY(acted >= 1900);
        // The burst, then those at once and those together.
        const auto most = std::size_t(2.0 * HostActions::kAtOnce + 5.0 * HostActions::kAtOnce
                                      + 5000.0 / 16.0 + 50.0);
        const std::size_t sent = world.site(1).fromHost.sent() - before;
        QVERIFY2(sent <= most, qPrintable(QString::number(sent)));
        world.run(100ms);
        QVERIFY(world.allHave(*world.newest(0)));
    }

    void actionsOfAHandGoOnAtOnce()
    {
        ActedWorld world{60, 2, kCalm};
        Duration slowest{};
        for (int i = 0; i < 300; ++i) { // 60 a second, for 5 s
            QVERIFY(world.turn(0));
            const EventCpo acted = *world.newest(0);
            Duration taken{};
            for (; !world.newest(1) || !isSame(*world.newest(1), acted); taken += 1ms) {
                QVERIFY(taken < 100ms);
                world.SessionWorld::run(1ms);
            }
            slowest = std::max(slowest, taken);
            world.SessionWorld::run(16ms - std::min(Duration{16ms}, taken));
        }
        QVERIFY2(slowest <= 12ms, qPrintable(QString::number(toSeconds(slowest))));
    }
};

CARINA_TEST(TestWorstPeer)

} // namespace carina::worst_peer_test

#include "tst_worst_peer.moc"
