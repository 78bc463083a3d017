#include "apps/lab/attack/attack_figures.h"
#include "apps/lab/attack/attackers/attendee.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace carina::attack_figures_test
{
namespace
{

using namespace std::chrono_literals;
using namespace carina::lab;

using Fault = std::function<void(AttackFigures&)>;

constexpr double kSmallestBlock_bytes = 32.0; ///< that glibc hands out
constexpr double kBytesOfKb = 1024.0;

const AttackKind& kindOf(std::string_view name)
{
    return *std::ranges::find(attackKinds(), name, &AttackKind::name);
}

/// A tube that was shown so far from where it was.
ShownPlaces seenPlaces(double drift_mm = 0.0)
{
    ShownPlaces places;
    for (SessionTime t{1s}; t < SessionTime{2s}; t += 20ms)
        places.shown(t, Vec3{1e-3 * drift_mm, 0.0, 0.0},
                     [](SessionTime) { return std::optional<Vec3>{Vec3::Zero()}; });
    return places;
}

/// A tube that was shown where it was, and was elsewhere from one sample to the next.
ShownPlaces jumpedPlaces()
{
    ShownPlaces places = seenPlaces();
    PoseSample sample;
    for (const double x : {0.0, 1.0}) {
        sample.time += 16ms;
        sample.X_FO = RigidTransform::translation(Vec3{x, 0.0, 0.0});
        places.heard(sample, sample.time);
    }
    return places;
}

/// Of an attack that did what it is for, on a session that held.
AttackFigures heldAgainst(const AttackKind& kind)
{
    AttackFigures figures{.kind = &kind, .length = 5s};
    figures.sent = static_cast<std::int64_t>(kind.leastSent);
    figures.usual = seenPlaces();
    figures.during.places = seenPlaces();
    for (const Role role : {Role::Trainee, Role::Observer, Role::Instructor})
        figures.joined[role] = 20ms;
    figures.measured = {{"something", 1.0, 0.5, 2.0},
                        {"another", 1.0, 0.5, std::numeric_limits<double>::infinity()}};
    figures.facts = static_cast<std::int64_t>(std::ceil(leastFactsOf(figures)));
    figures.memory_kb = {0.0, 0.0};
    return figures;
}

} // namespace

class TestAttackFigures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void seesEachFault_data()
    {
        QTest::addColumn<Fault>("fault");
        const auto row = [](const char* name, Fault fault) { QTest::newRow(name) << fault; };
        row("taken for another", [](AttackFigures& f) { f.isTakenForAnother = true; });
        row("somebody honest is put out", [](AttackFigures& f) { f.putOut = 1; });
        row("an object of another moved", [](AttackFigures& f) { f.moved = 1; });
        row("a gap", [](AttackFigures& f) { f.during.largestGap = 101ms; });
        row("a drift", [](AttackFigures& f) { f.during.places = seenPlaces(0.21); });
        row("a jump", [](AttackFigures& f) { f.during.places = jumpedPlaces(); });
        row("no tube seen", [](AttackFigures& f) { f.during.places = {}; });
        row("an instructor comes in late",
            [](AttackFigures& f) { f.joined[Role::Instructor] = 2001ms; });
        row("an observer does not come in",
            [](AttackFigures& f) { f.joined[Role::Observer] = std::nullopt; });
        row("too many facts", [](AttackFigures& f) { f.facts = 100'000; });
        row("too few facts", [](AttackFigures& f) { --f.facts; });
        row("too few datagrams", [](AttackFigures& f) { --f.sent; });
        row("too little of what was measured",
            [](AttackFigures& f) { f.measured.front().figure = 0.4; });
        row("too much of it", [](AttackFigures& f) { f.measured.front().figure = 2.1; });
        row("memory of the console that was not measured",
            [](AttackFigures& f) { f.memory_kb[0] = std::nullopt; });
        row("memory of the trainee that was not measured",
            [](AttackFigures& f) { f.memory_kb[1] = std::nullopt; });
        row("no memory measured", [](AttackFigures& f) { f.memory_kb.clear(); });
        row("memory of the console", [](AttackFigures& f) { f.memory_kb[0] = 1e5; });
        row("memory of the trainee", [](AttackFigures& f) { f.memory_kb[1] = 1e5; });
    }
    void seesEachFault()
    {
        QFETCH(Fault, fault);
        AttackFigures figures = heldAgainst(kindOf("crowd"));
        QVERIFY(holds(figures));
        fault(figures);
        QVERIFY(!holds(figures));
    }

    /// Memory that an attack needs for the first time is not lost; what each needs is.
    void takesTheMemoryOfASecondAttack()
    {
        AttackFigures figures = heldAgainst(kindOf("crowd"));
        figures.memory_kb = {1e5, 1e5};
        QVERIFY(!holdsMemory(figures));
        figures.memoryAgain_kb = {0.0, 1e5};
        QVERIFY(!holdsMemory(figures));
        figures.memoryAgain_kb = {0.0, std::nullopt};
        QVERIFY(!holdsMemory(figures));
        figures.memoryAgain_kb = {0.0, 0.0};
        QVERIFY(holdsMemory(figures));
    }

    /// Of the smallest block for each datagram too much is left.
    void seesABlockOfEachDatagram()
    {
        for (const char* name : {"garbage", "steady"}) {
            AttackFigures figures = heldAgainst(kindOf(name));
            QVERIFY(holds(figures));
            QVERIFY(leastLeakOf_bytes(figures) < kSmallestBlock_bytes);
            figures.memory_kb[0] = double(figures.sent) * kSmallestBlock_bytes / kBytesOfKb;
            QVERIFY(!holds(figures));
        }
    }

    /// Not those that the attacker's budget allows.
    void boundsTheMemoryByTheFactsThatThereAre()
    {
        AttackFigures figures = heldAgainst(kindOf("crowd"));
        const auto few = mostMemoryOf_kb(figures);
        figures.facts += 100;
        const auto more = mostMemoryOf_kb(figures);
        for (std::size_t i = 0; i < few.size(); ++i) {
            QCOMPARE(more[i], few[i] + 100.0);
            figures.memory_kb[i] = few[i] + 100.0;
        }
        QVERIFY(holds(figures));
        figures.facts -= 1;
        QVERIFY(!holds(figures));
    }

    /// As many as there were, of which the host keeps 64, of one who opens any.
    void boundsTheMemoryOfTheHostByThePathsThatThereWere()
    {
        constexpr double kPath_kb = 64.0;
        AttackFigures figures = heldAgainst(kindOf("paths"));
        const auto none = mostMemoryOf_kb(figures);
        figures.paths = 3;
        QCOMPARE(mostMemoryOf_kb(figures)[0], none[0] + 3.0 * kPath_kb);
        QCOMPARE(mostMemoryOf_kb(figures)[1], none[1]);
        figures.paths = 400;
        QCOMPARE(mostMemoryOf_kb(figures)[0], none[0] + 64.0 * kPath_kb);
        figures.kind = &kindOf("crowd");
        QCOMPARE(mostMemoryOf_kb(figures)[0], none[0]);
    }

    /// Twice what is usual in the same run; as little as it is, 0.2 mm is enough.
    void boundsTheDriftByTheUsual_data()
    {
        QTest::addColumn<double>("usual_mm");
        QTest::addColumn<double>("during_mm");
        QTest::addColumn<bool>("isHeld");
        QTest::newRow("none usual") << 0.0 << 0.19 << true;
        QTest::newRow("none usual, and some") << 0.0 << 0.21 << false;
        QTest::newRow("twice") << 0.3 << 0.59 << true;
        QTest::newRow("more than twice") << 0.3 << 0.61 << false;
        QTest::newRow("of what once was the largest") << 0.15 << 0.6 << false;
    }
    void boundsTheDriftByTheUsual()
    {
        QFETCH(const double, usual_mm);
        QFETCH(const double, during_mm);
        QFETCH(const bool, isHeld);
        AttackFigures figures = heldAgainst(kindOf("crowd"));
        figures.usual = seenPlaces(usual_mm);
        figures.during.places = seenPlaces(during_mm);
        QCOMPARE(holds(figures), isHeld);
    }

    /// A tube jumps when another patient is laid, and not oftener.
    void allowsAJumpForEachPatientThatTheAttackerHadLaid()
    {
        AttackFigures figures = heldAgainst(kindOf("instructing"));
        figures.during.places = jumpedPlaces();
        QCOMPARE(figures.during.places.jumps(), 1);
        QVERIFY(!holds(figures));
        figures.patientsLaid = 1;
        QCOMPARE(mostJumpsOf(figures), std::int64_t{1});
        QVERIFY(holds(figures));
    }

    void boundsTheGapBesideGuestsToo()
    {
        AttackFigures figures = heldAgainst(kindOf("together"));
        figures.guests = 234;
        figures.during.largestGap = 100ms;
        QVERIFY(holds(figures));
        figures.during.largestGap = 101ms;
        QVERIFY(!holds(figures));
    }

    void allThatCanActAtOnceDo()
    {
        QCOMPARE(std::size_t(std::ranges::count_if(attackKinds(), actsBesideOthers)),
                 kAttackersAtOnce);
        for (const char* name : {"together", "messages", "new-codes", "gallery"})
            QVERIFY2(!actsBesideOthers(kindOf(name)), name);
    }

    /// Who comes new in the next attack would be kept out by the one before.
    void nothingFollowsWhatSpoilsARole()
    {
        const auto spoils = [](const AttackKind& kind) { return kind.spoils.has_value(); };
        QVERIFY(std::ranges::any_of(attackKinds(), spoils));
        QVERIFY(std::ranges::is_partitioned(attackKinds(), std::not_fn(spoils)));
    }

    void eachNameDrawsItsOwnIds()
    {
        QVERIFY(randomOf("Ina")() != randomOf("Ida")());
        QCOMPARE(randomOf("Ina")(), randomOf("Ina")());
    }
};

CARINA_TEST(TestAttackFigures)

} // namespace carina::attack_figures_test

#include "tst_attack_figures.moc"
