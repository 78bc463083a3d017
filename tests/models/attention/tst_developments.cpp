#include "models/attention/developments.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::developments_test
{
namespace
{

using std::chrono::seconds;
using test::FakeSessionNode;

struct Ward {
    FakeSessionNode node;
    DevelopmentWatch watch;

    explicit Ward(const LungConditions& conditions)
    {
        VentilatorSettings ventilator;
        ventilator.mode = VentilationMode::VolumeControl;
        node.decide(fact::VentilatorSet{ventilator});
        node.decide(fact::TubePlaced{{TubeSeat::Trachea, millimetres(6.5)}});
        node.decide(fact::LungConditionsSet{conditions});
        node.decide(fact::PhaseChanged{SessionPhase::Running});
    }
    /// What develops after so many seconds, looked at in each.
    std::vector<Development> after(int lasting_s)
    {
        std::vector<Development> found;
        for (int second = 0; second < lasting_s; ++second) {
            node.advance(seconds{1});
            found = watch.at(*node.state(), *node.now());
        }
        return found;
    }
};

constexpr LungCondition kTension{ConditionKind::TensionPneumothorax, 0.5, ConditionSide::Right};

} // namespace

class TestDevelopments : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// The gas closes the lung, and only then moves the mediastinum far.
    void followsATensionPneumothoraxToItsFullExtent()
    {
        Ward ward{{kTension}};
        const auto early = ward.after(6);
        QCOMPARE(early.size(), std::size_t{1});
        QVERIFY(early[0].condition == kTension);
        QVERIFY(early[0].share < 0.9);
        const auto closed = ward.after(20);
        QCOMPARE(closed.size(), std::size_t{1});
        QVERIFY(closed[0].isClosed && !early[0].isClosed);
        QCOMPARE(closed[0].share, 0.95); // the rest stays open, and breathes
        QVERIFY(closed[0].shift > early[0].shift);
        const auto later = ward.after(20);
        QCOMPARE(later.size(), std::size_t{1});
        QVERIFY(later[0].isClosed);
        QVERIFY(inMillimetres(later[0].shift) > inMillimetres(closed[0].shift) + 5.0);
        QVERIFY(ward.after(1500).empty()); // it has come to rest
    }

    /// However far the breath is: the shift that a breath takes back is not told.
    void tellsTheFarthestShiftOfABreath()
    {
        Ward ward{{{ConditionKind::TensionPneumothorax, 0.5, ConditionSide::Left}}};
        static_cast<void>(ward.after(20));
        Length before;
        for (int second = 0; second < 12; ++second) {
            const auto found = ward.after(1);
            QCOMPARE(found.size(), std::size_t{1});
            QVERIFY(inMillimetres(found[0].shift) > inMillimetres(before) - 1.0);
            before = found[0].shift;
        }
        QVERIFY(before.si > 0.0); // to whichever side
    }

    void followsTheLungThatATubeLeavesOut()
    {
        Ward ward{{{ConditionKind::MainstemIntubation, 1.0, ConditionSide::Right}}};
        const auto early = ward.after(60);
        QCOMPARE(early.size(), std::size_t{1});
        const auto later = ward.after(60);
        QCOMPARE(later.size(), std::size_t{1});
        QVERIFY(later[0].share > early[0].share + 0.05);
    }

    void doesNotFollowWhatIsThereAtOnce()
    {
        Ward ward{{{ConditionKind::Ards, 0.6, ConditionSide::Both}}};
        QVERIFY(ward.after(10).empty());
    }

    void waitsDuringAPause()
    {
        Ward ward{{kTension}};
        const auto before = ward.after(12);
        ward.node.decide(fact::PhaseChanged{SessionPhase::Paused});
        const auto during = ward.after(30);
        QCOMPARE(during.size(), std::size_t{1});
        QVERIFY(std::abs(during[0].share - before[0].share) < 0.05);
        ward.node.decide(fact::PhaseChanged{SessionPhase::Running});
        QCOMPARE(ward.after(3).size(), std::size_t{1});
    }

    /// As of a console that resumes a session in a pause.
    void announcesInAPauseWhatItHasNotFollowed()
    {
        Ward ward{{kTension}};
        const auto before = ward.after(12);
        ward.node.decide(fact::PhaseChanged{SessionPhase::Paused});
        static_cast<void>(ward.after(2));
        ward.watch = {};
        const auto resumed = ward.after(1);
        QCOMPARE(resumed.size(), std::size_t{1});
        QVERIFY(std::abs(resumed[0].share - before[0].share) < 0.05);
    }

    void saysNothingBeforeTheSessionRuns()
    {
        FakeSessionNode node;
        node.decide(fact::LungConditionsSet{{kTension}});
        node.advance(seconds{1});
        DevelopmentWatch watch;
        QVERIFY(watch.at(*node.state(), *node.now()).empty());
    }

    void beginsAnewWithAnotherLung()
    {
        Ward ward{{kTension}};
        ward.node.decide(fact::LungConditionsSet{});
        QVERIFY(ward.after(2).empty());
        ward.node.decide(fact::LungConditionsSet{
            {{ConditionKind::TensionPneumothorax, 0.5, ConditionSide::Left}}});
        const auto found = ward.after(8);
        QCOMPARE(found.size(), std::size_t{1});
        QVERIFY(found[0].condition.side == ConditionSide::Left);
    }
};

CARINA_TEST(TestDevelopments)

} // namespace carina::developments_test

#include "tst_developments.moc"
