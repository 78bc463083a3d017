#include "models/respiration/breath_trace.h"
#include "models/respiration/checkpoint_keeper.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <cmath>

namespace carina::breath_trace_test
{

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::FakeSessionNode;

/// What goes from the fold to a screen and into the log.
class TestBreathTrace : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void samplesEvery20Milliseconds();
    void tracesAnotherStation();
    void showsWhatTheFoldHas();
    void beginsEachBreathAtNoVolume();
    void isSilentWhileTheSessionDoesNotRun();
    void makesNoLongGapGood();
    void tellsTheFiguresOfTheLastBreath();
    void tellsSidesThatMakeTheBreath();
    void roundsSidesSoThatTheyMakeTheBreath_data();
    void roundsSidesSoThatTheyMakeTheBreath();
    void tellsOfNoBreathInApnoea();
    void tellsThePressuresOfAVentilator();
    void keepsCheckpointsThatChangeNothing();
    void keepsNoneWhileTheSessionDoesNotRun();
};

namespace
{

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    BreathTrace trace{session, FakeSessionNode::kStation};
    std::vector<BreathTrace::Sample> samples;

    Desk()
    {
        QObject::connect(&trace, &BreathTrace::sampled,
                         [this](const BreathTrace::Sample& s) { samples.push_back(s); });
    }
    void start() { node.decide(fact::PhaseChanged{SessionPhase::Running}); }
    void run(Duration time, Duration step = milliseconds{37})
    {
        for (Duration gone{}; gone < time; gone += step) {
            node.advance(step);
            trace.sample();
        }
    }
    [[nodiscard]] RespirationTimeline timeline() const
    {
        return node.state()->stations().at(FakeSessionNode::kStation).respiration;
    }
};

} // namespace

void TestBreathTrace::samplesEvery20Milliseconds()
{
    Desk desk;
    desk.start();
    desk.run(seconds{3});
    QVERIFY(desk.samples.size() > 140);
    for (std::size_t i = 0; i < desk.samples.size(); ++i) {
        const double twentieths = desk.samples[i].time_s / 0.02;
        QVERIFY(std::abs(twentieths - std::round(twentieths)) < 1e-6);
        if (i > 0)
            QVERIFY(std::abs(desk.samples[i].time_s - desk.samples[i - 1].time_s - 0.02) < 1e-6);
    }
}

void TestBreathTrace::tracesAnotherStation()
{
    constexpr StationId kRoom{1};
    Desk desk;
    desk.node.addStation("Room 5");
    desk.node.decideAt(kRoom, fact::BreathingRateSet{perMinute(40.0)});
    desk.start();
    desk.run(seconds{20});
    QSignalSpy afresh{&desk.trace, &BreathTrace::startedAfresh};
    desk.trace.setStation(FakeSessionNode::kStation);
    QCOMPARE(afresh.count(), 0); // it is this one
    desk.trace.setStation(kRoom);
    QCOMPARE(afresh.count(), 1);
    QVERIFY(!desk.trace.lastBreath());
    desk.run(seconds{10});
    QVERIFY2(std::abs(desk.trace.lastBreath()->rate_perMin - 40.0) < 1.0,
             qPrintable(QString::number(desk.trace.lastBreath()->rate_perMin)));
}

void TestBreathTrace::showsWhatTheFoldHas()
{
    Desk desk;
    fact::VentilatorSet ventilator;
    ventilator.settings.mode = VentilationMode::VolumeControl;
    desk.node.decide(ventilator);
    desk.start();
    desk.run(seconds{8});
    const BreathTrace::Sample& last = desk.samples.back();
    PatientRun run{desk.timeline(), SessionTime::min()};
    run.advanceTo(desk.timeline(), SessionTime{fromSeconds(last.time_s)});
    QVERIFY(std::abs(last.pressure_cmH2O - inCmH2O(run.fold().moment().opening)) < 1e-9);
    QVERIFY(std::abs(last.flow_lPerMin - 6e4 * run.fold().moment().airwayFlow.si) < 1e-9);
    QVERIFY(last.pressure_cmH2O >= 4.9);
}

void TestBreathTrace::beginsEachBreathAtNoVolume()
{
    Desk desk;
    desk.start();
    desk.run(seconds{10}); // the first breaths come from rest
    desk.samples.clear();
    desk.run(seconds{10});
    double least = 1e9;
    double greatest = -1e9;
    for (const BreathTrace::Sample& sample : desk.samples) {
        least = std::min(least, sample.volume_ml);
        greatest = std::max(greatest, sample.volume_ml);
    }
    QVERIFY2(std::abs(greatest - 280.0) < 10.0, qPrintable(QString::number(greatest)));
    QVERIFY2(std::abs(least) < 5.0, qPrintable(QString::number(least)));
}

void TestBreathTrace::isSilentWhileTheSessionDoesNotRun()
{
    Desk desk;
    desk.run(seconds{1});
    QVERIFY(desk.samples.empty());
    desk.start();
    desk.run(seconds{1});
    const std::size_t before = desk.samples.size();
    QVERIFY(before > 0);
    desk.node.decide(fact::PhaseChanged{SessionPhase::Paused});
    desk.run(milliseconds{200});
    const std::size_t paused = desk.samples.size();
    desk.run(seconds{2});
    QCOMPARE(desk.samples.size(), paused);
    desk.node.loseClock();
    desk.trace.sample();
    QCOMPARE(desk.samples.size(), paused);
}

void TestBreathTrace::makesNoLongGapGood()
{
    Desk desk;
    desk.start();
    desk.run(seconds{1});
    std::size_t before = desk.samples.size();
    desk.node.advance(seconds{9});
    desk.trace.sample();
    QCOMPARE(desk.samples.size(), before + 450);
    before = desk.samples.size();
    desk.node.advance(seconds{11});
    desk.trace.sample();
    QCOMPARE(desk.samples.size(), before + 1);
}

void TestBreathTrace::tellsTheFiguresOfTheLastBreath()
{
    Desk desk;
    desk.start();
    desk.run(seconds{1});
    QVERIFY(!desk.trace.lastBreath());
    desk.run(seconds{15});
    const auto breath = desk.trace.lastBreath();
    QVERIFY(breath.has_value());
    QVERIFY(std::abs(breath->rate_perMin - 19.0) < 0.05);
    QVERIFY(std::abs(breath->tidalVolume_ml - 280.0) < 2.8);
    QVERIFY(std::abs(breath->right_ml + breath->left_ml - breath->tidalVolume_ml) < 2.0);
    QVERIFY(breath->right_ml > breath->left_ml);
    QVERIFY(!breath->airway); // nobody pushes
    QVERIFY(breath->alveolarVentilation_lPerMin > 2.5 && breath->alveolarVentilation_lPerMin < 5.3);
    QVERIFY(std::abs(breath->functionalResidual_ml - 30.0 * 40.0) < 1.0); // 30 ml/kg
}

/// Also in the breaths in which the patient changes, and gas swings between the lungs.
void TestBreathTrace::tellsSidesThatMakeTheBreath()
{
    constexpr double kRounding_ml = 1e-6;
    Desk desk;
    desk.start();
    desk.run(seconds{10});
    desk.node.decide(
        fact::LungConditionsSet{{{ConditionKind::SimplePneumothorax, 0.9, ConditionSide::Right}}});
    std::optional<double> last_ml;
    int breaths = 0;
    for (int look = 0; look < 400; ++look) {
        desk.run(milliseconds{50});
        const auto breath = desk.trace.lastBreath();
        QVERIFY(breath.has_value());
        const double off_ml = breath->right_ml + breath->left_ml - breath->tidalVolume_ml;
        QVERIFY2(std::abs(off_ml) < kRounding_ml, qPrintable(QString::number(off_ml)));
        QVERIFY(breath->right_ml >= 0.0 && breath->left_ml >= 0.0);
        breaths += last_ml != breath->tidalVolume_ml ? 1 : 0;
        last_ml = breath->tidalVolume_ml;
    }
    QVERIFY(breaths > 4);
}

void TestBreathTrace::roundsSidesSoThatTheyMakeTheBreath_data()
{
    QTest::addColumn<double>("right_ml");
    QTest::addColumn<double>("left_ml");
    QTest::addColumn<int>("wholeRight_ml");
    QTest::addColumn<int>("wholeLeft_ml");
    QTest::newRow("both would be rounded down") << 183.4 << 166.3 << 184 << 166;
    QTest::newRow("both would be rounded up") << 182.6 << 165.7 << 182 << 166;
    QTest::newRow("each by itself") << 182.9 << 165.8 << 183 << 166;
    QTest::newRow("one") << 182.9 << 166.1 << 183 << 166;
    QTest::newRow("nothing to give") << 182.1 << 166.2 << 182 << 166;
    QTest::newRow("a closed side") << 0.0 << 166.6 << 0 << 167;
}

void TestBreathTrace::roundsSidesSoThatTheyMakeTheBreath()
{
    QFETCH(double, right_ml);
    QFETCH(double, left_ml);
    const BreathTrace::WholeBreath whole = BreathTrace::inWhole(
        {.tidalVolume_ml = right_ml + left_ml, .right_ml = right_ml, .left_ml = left_ml});
    QCOMPARE(whole.tidalVolume_ml, qRound(right_ml + left_ml));
    QCOMPARE(whole.right_ml + whole.left_ml, whole.tidalVolume_ml);
    QTEST(whole.right_ml, "wholeRight_ml");
    QTEST(whole.left_ml, "wholeLeft_ml");
}

void TestBreathTrace::tellsOfNoBreathInApnoea()
{
    Desk desk;
    desk.start();
    desk.run(seconds{10});
    QVERIFY(desk.trace.lastBreath() && !desk.trace.hasStopped());
    desk.node.decide(fact::BreathingStopped{true, seconds{4}});
    desk.run(seconds{3});
    QVERIFY(!desk.trace.hasStopped());
    desk.run(seconds{3});
    QVERIFY(!desk.trace.lastBreath() && desk.trace.hasStopped());
    desk.node.decide(fact::BagSqueezed{{perMinute(12.0), millilitres(300.0)}});
    desk.run(seconds{20});
    QVERIFY(!desk.trace.hasStopped());
    QVERIFY(desk.trace.lastBreath()->airway.has_value());
    QVERIFY(std::abs(desk.trace.lastBreath()->tidalVolume_ml - 300.0) < 5.0);
}

void TestBreathTrace::tellsThePressuresOfAVentilator()
{
    Desk desk;
    desk.start();
    desk.run(seconds{10});
    fact::VentilatorSet ventilator;
    ventilator.settings.mode = VentilationMode::VolumeControl;
    desk.node.decide(ventilator);
    desk.run(seconds{10});
    const auto breath = desk.trace.lastBreath();
    QVERIFY(breath && breath->airway);
    QVERIFY(breath->airway->peak_cmH2O > breath->airway->plateau_cmH2O);
    QVERIFY(breath->airway->plateau_cmH2O > 5.0); // of PEEP
    // Relaxed under a ventilator: towards 25 ml/kg, of which seconds have reached most.
    QVERIFY(std::abs(breath->functionalResidual_ml - 25.0 * 40.0) < 20.0);
}

void TestBreathTrace::keepsCheckpointsThatChangeNothing()
{
    FakeSessionNode node{FakeSessionNode::kHost};
    CheckpointKeeper keeper{node};
    node.decide(fact::PhaseChanged{SessionPhase::Running});
    const auto timeline = [&] {
        return node.state()->stations().at(FakeSessionNode::kStation).respiration;
    };
    node.advance(seconds{7});
    keeper.keep();
    const auto with = timeline();
    const RespirationState* checkpoint = with.checkpointBefore(*node.now());
    QVERIFY(checkpoint);
    QVERIFY(*node.now() - checkpoint->at < milliseconds{2});
    PatientRun late{with, *node.now()};
    QVERIFY(late.at() == checkpoint->at);
    PatientRun whole{with, SessionTime::min()};
    late.advanceTo(with, *node.now() + seconds{3});
    whole.advanceTo(with, *node.now() + seconds{3});
    QVERIFY(late.fold().state() == whole.fold().state());
    QVERIFY(late.body().state() == whole.body().state());
}

void TestBreathTrace::keepsNoneWhileTheSessionDoesNotRun()
{
    FakeSessionNode node{FakeSessionNode::kHost};
    CheckpointKeeper keeper{node};
    keeper.keep();
    node.loseClock();
    keeper.keep();
    QCOMPARE(node.proposed, 0);
}

CARINA_TEST(TestBreathTrace)

} // namespace carina::breath_trace_test

#include "tst_breath_trace.moc"
