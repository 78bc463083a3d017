#include "engine/sync/connection/host_budgets.h"
#include "tests/engine/sync/connection/session_world.h"
#include "tests/support/test_class.h"

namespace carina::peer_budget_test
{
namespace
{

using namespace std::chrono_literals;

constexpr LocalTime kStart{100s};
constexpr PeerLimits kLimits{.datagrams = 100.0,
                             .bytes = 1e4,
                             .comings = 1.0,
                             .proposals = 10.0,
                             .events = 20.0,
                             .samples = 60.0};

} // namespace

/// What the host takes from a participant.
class TestPeerBudget : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bucketHoldsTwoSecondsWorthAndFills()
    {
        TokenBucket bucket;
        int taken = 0;
        for (int i = 0; i < 100; ++i)
            taken += bucket.take(1.0, 10.0, kStart) ? 1 : 0;
        QCOMPARE(taken, 20);
        QVERIFY(!bucket.take(1.0, 10.0, kStart + 99ms));
        QVERIFY(bucket.take(1.0, 10.0, kStart + 100ms));
        for (int i = 0; i < 100; ++i)
            taken += bucket.take(1.0, 10.0, kStart + 1h) ? 1 : 0;
        QCOMPARE(taken, 40);
    }

    void clockThatGoesBackFillsNothing()
    {
        TokenBucket bucket;
        QVERIFY(bucket.take(20.0, 10.0, kStart));
        QVERIFY(!bucket.take(1.0, 10.0, kStart - 1h));
        QVERIFY(!bucket.take(1.0, 10.0, kStart));
    }

    void nothingIsTakenWhereNothingIsAllowed()
    {
        TokenBucket bucket;
        QVERIFY(!bucket.take(1.0, 0.0, kStart));
        PeerBudget budget{PeerLimits{}};
        QVERIFY(!budget.takesEvent(kStart));
    }

    void eachKindHasItsOwnBucket()
    {
        PeerBudget budget{kLimits};
        while (budget.takesProposal(kStart) == PeerBudget::Verdict::Taken) {}
        QVERIFY(budget.takesEvent(kStart) && budget.takesSamples(60, kStart)
                && budget.takesDatagram(100, kStart));
        QVERIFY(!budget.takesSamples(61, kStart));
        QVERIFY(!budget.takesDatagram(20'000, kStart));
    }

    /// One and a half times the limit is only slowed; ten times is found within two seconds.
    void onlyWhoGoesFarOverTheLimitIsDisconnected()
    {
        PeerBudget slow{kLimits};
        int taken = 0;
        for (int i = 0; i < 60 * 15; ++i)
            taken += slow.takesProposal(kStart + i * (1'000'000'000ns / 15))
                             == PeerBudget::Verdict::Taken
                         ? 1
                         : 0;
        QVERIFY(!slow.isFarExceeded());
        QVERIFY(taken >= 600 && taken <= 621);
        PeerBudget flood{kLimits};
        for (int i = 0; i < 200; ++i)
            static_cast<void>(flood.takesProposal(kStart + i * 10ms));
        QVERIFY(flood.isFarExceeded());
    }

    /// What was decided is repeated until it has come back: on a slow disk, often.
    void repeatsOfWhatIsSettledAreNotCharged()
    {
        SessionWorld world{38};
        world.session.limits = kLimits;
        world.session.limits.proposals = 2.0; // 4 at once
        world.startHost();
        world.addSite({5ms, 0ms, 0.0, 0.0});
        world.startClient(0, "anna");
        world.run(1100ms); // until what coming in costs is there again
        world.session.isFast = false;
        for (int i = 0; i < 4; ++i)
            world.propose(0, "patient");
        world.run(5s); // repeated 50 times
        QVERIFY(world.site(0).refused.empty());
        QVERIFY(!world.host().peers().begin()->second.budget.isFarExceeded());
        QCOMPARE(world.session.disk.size(), std::size_t{5});
        for (std::size_t i = 1; i < 5; ++i)
            world.host().append(world.session.disk[i]);
        world.run(50ms);
        QVERIFY(world.site(0).client->waiting().empty());
        QCOMPARE(world.site(0).log.size(), std::size_t{5});
    }

    void burstIsHeldHoweverSlowlyTheBucketFills()
    {
        TokenBucket bucket;
        QVERIFY(bucket.takeOf(8.0, 8.0, 0.1, kStart));
        QVERIFY(!bucket.takeOf(8.0, 1.0, 0.1, kStart + 9s));
        QVERIFY(bucket.takeOf(8.0, 1.0, 0.1, kStart + 10s));
        bucket.putBack(1.0, 0.1);
        QVERIFY(bucket.takeOf(8.0, 1.0, 0.1, kStart + 10s));
    }

    /// Others decide how many answers they ask for.
    void answersToProbesUseUpNothingElse()
    {
        PeerBudget budget{{.messages = 10.0}};
        int answers = 0;
        while (budget.takesProbeAnswer(kStart))
            ++answers;
        QCOMPARE(answers, 20);
        QVERIFY(budget.takesMessage(kStart));
        QVERIFY(!budget.isFarExceeded());
    }

    /// What its place exceeds is put off, and neither told nor held against it.
    void whatIsSharedPutsOffAndRefusesNothing()
    {
        PeerBudget budget{kLimits};
        const auto shared = std::make_shared<SharedBudget>(
            SharedLimits{.datagrams = 10.0, .bytes = 1e4, .proposals = 1.0});
        budget.comes(shared, kStart);
        int taken = 0;
        for (int i = 0; i < 1000; ++i) {
            const auto verdict = budget.takesProposal(kStart);
            QVERIFY(verdict != PeerBudget::Verdict::Refused);
            taken += verdict == PeerBudget::Verdict::Taken ? 1 : 0;
        }
        QCOMPARE(taken, int(SharedBudget::kSavedProposals) + 2); // its share, and the pot
        int datagrams = 0;
        for (int i = 0; i < 100; ++i)
            datagrams += budget.takesDatagram(1, kStart) ? 1 : 0;
        QCOMPARE(datagrams, 20 + 20);
        QVERIFY(!budget.isFarExceeded());
    }

    /// A class behind one router: each sends its streams and acknowledgements, and shares what it
    /// holds when it comes in, all at the same time.
    void aClassOfThirtyTwoBehindOneAddressIsNotHurt()
    {
        constexpr PeerLimits kTrainee{
            .datagrams = 2000.0, .bytes = 5e5, .comings = 2.0, .proposals = 20.0};
        const auto shared = std::make_shared<SharedBudget>(
            SharedLimits{.datagrams = 16000.0, .bytes = 4e6, .proposals = 40.0});
        shared->setMembers(32, kStart);
        std::vector<PeerBudget> pupils(32, PeerBudget{kTrainee});
        for (PeerBudget& pupil : pupils) {
            pupil.comes(shared, kStart);
            QCOMPARE(pupil.takesComing(kStart), PeerBudget::Verdict::Taken);
            for (int object = 0; object < 4; ++object)
                QCOMPARE(pupil.takesProposal(kStart), PeerBudget::Verdict::Taken);
        }
        for (int i = 0; i < 10 * 130; ++i)
            for (PeerBudget& pupil : pupils)
                QVERIFY(pupil.takesDatagram(200, kStart + i * (1'000'000'000ns / 130)));
    }

    /// An observer's first proposal is refused for what it is, not for having come in.
    void comingInUsesUpNoProposal()
    {
        PeerBudget budget{PeerLimits{.comings = 1.0, .proposals = 2.0}};
        budget.comes(std::make_shared<SharedBudget>(SharedLimits{.proposals = 40.0}), kStart);
        QCOMPARE(budget.takesComing(kStart), PeerBudget::Verdict::Taken);
        QCOMPARE(budget.takesComing(kStart), PeerBudget::Verdict::Taken);
        QCOMPARE(budget.takesComing(kStart), PeerBudget::Verdict::Refused);
        for (int i = 0; i < 4; ++i)
            QCOMPARE(budget.takesProposal(kStart), PeerBudget::Verdict::Taken);
        QCOMPARE(budget.takesProposal(kStart), PeerBudget::Verdict::Refused);
        QCOMPARE(budget.takesComing(kStart + 1s), PeerBudget::Verdict::Taken);
    }

    /// Each coming makes two facts, which all from one place share.
    void comingsOfManyNamesAreBoundedTogether()
    {
        const auto shared = std::make_shared<SharedBudget>(SharedLimits{.proposals = 4.0});
        shared->setMembers(12, kStart);
        std::vector<PeerBudget> names(12, PeerBudget{PeerLimits{.comings = 100.0}});
        int comings = 0;
        for (PeerBudget& name : names) {
            name.comes(shared, kStart);
            while (name.takesComing(kStart) == PeerBudget::Verdict::Taken)
                ++comings;
        }
        QCOMPARE(comings, (12 * int(SharedBudget::kSavedProposals) + 8) / 2);
    }

    /// One person under many names, each of which is there for a tenth of a second and gone again:
    /// their shares fill no faster than that of one who stays.
    void namesThatTakeTurnsHaveNoMoreThanOne()
    {
        constexpr int kNames = 100;
        constexpr int kTurns = 600;
        const auto shared = std::make_shared<SharedBudget>(SharedLimits{.proposals = 40.0});
        std::vector<PeerBudget> names(kNames, PeerBudget{{.comings = 2.0, .proposals = 20.0}});
        int facts = 0;
        LocalTime now = kStart;
        for (int turn = 0; turn < kTurns; ++turn, now += 100ms) {
            PeerBudget& name = names[std::size_t(turn % kNames)];
            name.comes(shared, now);
            shared->setMembers(1, now);
            facts += name.takesComing(now) == PeerBudget::Verdict::Taken ? 2 : 0;
            for (int i = 0; i < 20; ++i)
                facts += name.takesProposal(now + i * 4ms) == PeerBudget::Verdict::Taken ? 1 : 0;
            name.goes(now + 99ms);
        }
        const int most = kNames * int(SharedBudget::kSavedProposals) + (60 + 2) * 2 * 40;
        QVERIFY2(facts <= most && facts > most - 600, qPrintable(QString::number(facts)));
    }

    /// A crowd that is there for a moment does not let each of its members fill as one alone would.
    void aShareFillsByHowManyWereThere()
    {
        const auto shared = std::make_shared<SharedBudget>(SharedLimits{.proposals = 10.0});
        PeerBudget budget{{.proposals = 1000.0}};
        budget.comes(shared, kStart);
        shared->setMembers(100, kStart);
        while (budget.takesProposal(kStart) == PeerBudget::Verdict::Taken) {}
        shared->setMembers(1, kStart + 1s); // a tenth of a fact until here; the pot has ten
        int facts = 0;
        while (budget.takesProposal(kStart + 1s) == PeerBudget::Verdict::Taken)
            ++facts;
        QCOMPARE(facts, 10);
    }

    /// Neither a new connection nor a new run of the program brings a new budget.
    void whoComesAgainHasTheBudgetItHad()
    {
        SessionWorld world{39};
        world.session.limits = kLimits;
        world.session.limits.proposals = 2.0; // 4 at once
        world.startHost();
        world.addSite({5ms, 0ms, 0.0, 0.0});
        for (int run = 0; run < 10; ++run) {
            world.startClient(0, "anna");
            world.run(100ms);
            for (int i = 0; i < 4; ++i)
                world.propose(0, "patient");
            world.run(100ms);
        }
        const auto entered = std::ptrdiff_t(world.session.disk.size());
        QVERIFY2(entered <= 10, qPrintable(QString::number(entered))); // 4 + 2 s of 2, and one more
    }

    /// Else one who is barred over and over would have what each may have saved up each time.
    void whoWasBarredHasTheShareItHad()
    {
        constexpr ParticipantId kAnna{1};
        const auto shared = std::make_shared<SharedBudget>(SharedLimits{.proposals = 1.0});
        const auto limits = [](ParticipantId) { return kLimits; };
        HostBudgets budgets;
        const auto taken = [&](LocalTime now) {
            PeerBudget& budget = budgets.comesIn(kAnna, limits, shared, now);
            int facts = 0;
            while (budget.takesProposal(now) == PeerBudget::Verdict::Taken)
                ++facts;
            static_cast<void>(budget.takesSamples(100'000, now));
            const bool isExceeded = budget.isFarExceeded();
            budget.goes(now);
            budgets.bar(kAnna, now);
            return isExceeded ? facts : -1;
        };
        constexpr int kPot = 2;
        constexpr int kComing = 2;
        QCOMPARE(taken(kStart), int(SharedBudget::kSavedProposals) - kComing + kPot);
        QVERIFY(budgets.isBarred(kAnna, kStart + HostBudgets::kBarred - 1ns));
        QVERIFY(!budgets.isBarred(kAnna, kStart + HostBudgets::kBarred));
        QVERIFY(!budgets.known(kAnna)->isFarExceeded());
        QCOMPARE(taken(kStart + HostBudgets::kBarred), kPot);
    }

    /// A participant who floods: the log grows by its budget alone, it is told why, and it stays
    /// out for half a minute; the other's proposals go on.
    void floodIsEndedAndTheOthersGoOn()
    {
        SessionWorld world{37};
        world.session.limits = kLimits;
        world.startHost();
        world.addSite({5ms, 0ms, 0.0, 0.0});
        world.addSite({5ms, 0ms, 0.0, 0.0});
        world.startClient(0, "anna");
        world.startClient(1, "ben");
        world.run(500ms);
        const std::size_t before = world.session.disk.size();
        for (int i = 0; i < 100; ++i) {
            for (int k = 0; k < 20; ++k)
                world.propose(0, "flood");
            if (i % 20 == 0)
                world.propose(1, "ben's");
            world.run(50ms);
        }
        QVERIFY2(world.session.disk.size() - before <= 20 + 50 + 5,
                 qPrintable(QString::number(world.session.disk.size() - before)));
        QCOMPARE(world.site(0).client->helloRefused()->code, Errc::TooMuchSent);
        QVERIFY(world.site(1).client->helloRefused() == std::nullopt);
        const auto bens = std::ranges::count_if(world.site(1).log, [](const FactRecord& fact) {
            return fact.body == TestSession::body("ben's");
        });
        QCOMPARE(bens, 5);
        world.startClient(0, "anna");
        world.run(20s);
        QCOMPARE(world.site(0).client->helloRefused()->code, Errc::TooMuchSent);
        world.run(11s);
        QVERIFY(world.site(0).client->helloRefused() == std::nullopt);
        QCOMPARE(world.host().peers().size(), std::size_t{2});
    }

    /// Each action goes to everybody: those of many names from one place are limited together.
    void actionsOfOnePlaceAreLimitedTogether()
    {
        constexpr int kNames = 20;
        const PeerLimits own{.datagrams = 1e4, .bytes = 1e7, .comings = 1.0, .events = 400.0};
        const auto shared =
            std::make_shared<SharedBudget>(SharedLimits{.proposals = 40.0, .events = 100.0});
        std::vector<PeerBudget> budgets(kNames, PeerBudget{own});
        for (PeerBudget& budget : budgets)
            budget.comes(shared, kStart);
        shared->setMembers(kNames, kStart);
        int taken = 0;
        constexpr int kSeconds = 10;
        for (int i = 0; i < kSeconds * 100; ++i) // each a hundred in a second
            for (PeerBudget& budget : budgets)
                taken += budget.takesEvent(kStart + i * 10ms) ? 1 : 0;
        // The shares and the pot, each a hundred in a second and a burst of two seconds.
        QVERIFY2(taken <= 2 * 100 * (kSeconds + 2), qPrintable(QString::number(taken)));
        QVERIFY2(taken >= 2 * 100 * (kSeconds - 1), qPrintable(QString::number(taken)));
        for (const PeerBudget& budget : budgets)
            QVERIFY(!budget.isFarExceeded());
        PeerBudget alone{own};
        QVERIFY(alone.takesEvent(kStart));
    }
};

CARINA_TEST(TestPeerBudget)

} // namespace carina::peer_budget_test

#include "tst_peer_budget.moc"
