#include "engine/lungs/mechanics/body_position.h"

#include "engine/lungs/mechanics/respiratory_fold.h"
#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

namespace carina::body_position_test
{

namespace
{

constexpr double kTolerance_ml = 0.01;
constexpr double kTolerance_cmH2O = 1e-6;

PatientBuild child() { return {metres(1.50), 40.0, 12.0, Sex::Female}; }

RespiratorySystem placed(BodyPosition position, const PatientBuild& build = {})
{
    RespiratorySystem system = healthySystem(build);
    place(system, position, healthySystem(build));
    return system;
}

double gas_ml(const ChestContent& content, std::size_t lung)
{
    return inMillilitres(content[lung].gas);
}
double gas_ml(const ChestContent& content) { return gas_ml(content, 0) + gas_ml(content, 1); }

/// Gas at rest, as the equation of motion has it.
double rest_ml(BodyPosition position, const PatientBuild& build = {})
{
    return gas_ml(restingContent(placed(position, build)));
}

RespiratorySettings quiet(BodyPosition position)
{
    RespiratorySettings settings;
    settings.pattern = restingPattern(settings.build);
    settings.position = position;
    return settings;
}

RespiratoryFold after(const RespiratorySettings& settings, double seconds)
{
    RespiratoryFold fold{settings};
    for (int i = 0; i < seconds / kRespiratoryStep; ++i)
        fold.step();
    return fold;
}

} // namespace

/// Against what was measured in people. Sources: docs/mechanics.md.
class TestBodyPosition : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavesWhoLiesOnTheBack();
    void restsWithTheVolumesMeasured_data();
    void restsWithTheVolumesMeasured();
    void enlargesTheUpperLungAlone();
    void recoilsMoreInSomeoneWhoSits();
    void isStiffestOnTheBack();
    void keepsTheMediastinumInTheMiddle();
    void breathesMoreIntoTheLowerLung_data();
    void breathesMoreIntoTheLowerLung();
    void losesNoRestingVolumeUnderAVentilatorSitting();
    void turnsWithoutAJump();
    void sinksTowardsWhatIsBelow();
};

void TestBodyPosition::leavesWhoLiesOnTheBack()
{
    QVERIFY(placed(BodyPosition::Supine) == healthySystem({}));
}

/// Helium dilution in 13 men: 806 ml (SD 293) more sitting, 350 ml more prone and on a side.
void TestBodyPosition::restsWithTheVolumesMeasured_data()
{
    QTest::addColumn<BodyPosition>("position");
    QTest::addColumn<double>("more_ml");
    QTest::addColumn<double>("tolerance_ml");
    QTest::newRow("sitting") << BodyPosition::Sitting << 806.0 << kTolerance_ml;
    QTest::newRow("prone") << BodyPosition::Prone << 350.0 << kTolerance_ml;
    // Made from what magnetic resonance saw of each lung.
    QTest::newRow("right side") << BodyPosition::RightLateral << 350.0 << 80.0;
    QTest::newRow("left side") << BodyPosition::LeftLateral << 350.0 << 80.0;
}

void TestBodyPosition::restsWithTheVolumesMeasured()
{
    QFETCH(const BodyPosition, position);
    QFETCH(const double, more_ml);
    QFETCH(const double, tolerance_ml);
    VERIFY_WITHIN(rest_ml(position) - rest_ml(BodyPosition::Supine), more_ml, tolerance_ml);
    VERIFY_WITHIN(rest_ml(position, child()) / rest_ml(BodyPosition::Supine, child()),
                  rest_ml(position) / rest_ml(BodyPosition::Supine), 1e-6);
}

/// By a quarter; the lower one keeps its volume.
void TestBodyPosition::enlargesTheUpperLungAlone()
{
    const ChestContent onBack = restingContent(healthySystem({}));
    for (const std::size_t upper : {std::size_t{0}, std::size_t{1}}) {
        const ChestContent onSide = restingContent(
            placed(upper == 0 ? BodyPosition::LeftLateral : BodyPosition::RightLateral));
        VERIFY_WITHIN(gas_ml(onSide, upper), 1.25 * gas_ml(onBack, upper), kTolerance_ml);
        VERIFY_WITHIN(gas_ml(onSide, 1 - upper), gas_ml(onBack, 1 - upper), kTolerance_ml);
    }
}

/// The lung's own curve stays, so its recoil grows with its volume: sitting by 58 % of 7.0 cmH2O.
void TestBodyPosition::recoilsMoreInSomeoneWhoSits()
{
    const auto recoil = [](BodyPosition position) {
        const RespiratorySystem system = placed(position);
        return inCmH2O(-1.0 * chestMoment(system, restingContent(system), {}, {}).pleural[0]);
    };
    QVERIFY(placed(BodyPosition::Sitting).lungs[0].curve == healthySystem({}).lungs[0].curve);
    VERIFY_WITHIN(recoil(BodyPosition::Sitting) - recoil(BodyPosition::Supine), 0.58 * 7.0, 0.5);
}

/// Least compliance lying on the back, most sitting, the others between.
void TestBodyPosition::isStiffestOnTheBack()
{
    const auto compliance = [](BodyPosition position) {
        const RespiratorySystem system = placed(position);
        const ChestContent rest = restingContent(system);
        return inLitresPerCmH2O(system.lungs[0].curve.complianceAt(rest[0].gas))
               + inLitresPerCmH2O(system.lungs[1].curve.complianceAt(rest[1].gas));
    };
    for (const BodyPosition between :
         {BodyPosition::Prone, BodyPosition::RightLateral, BodyPosition::LeftLateral}) {
        QVERIFY(compliance(between) > compliance(BodyPosition::Supine));
        QVERIFY(compliance(between) < compliance(BodyPosition::Sitting));
    }
}

void TestBodyPosition::keepsTheMediastinumInTheMiddle()
{
    for (const BodyPosition position : kBodyPositions) {
        const RespiratorySystem system = placed(position);
        const ChestMoment moment = chestMoment(system, restingContent(system), {}, {});
        VERIFY_WITHIN(inMillilitres(moment.mediastinum), 0.0, kTolerance_ml);
        VERIFY_WITHIN(inCmH2O(moment.alveolar[0]), 0.0, kTolerance_cmH2O);
    }
    // What is below carries the weight.
    QVERIFY(placed(BodyPosition::LeftLateral).mediastinalWeight.si > 0.0);
    QVERIFY(placed(BodyPosition::RightLateral).mediastinalWeight.si < 0.0);
}

/// Electrical impedance in ten people: on the left side the left lung took 57.6 % (SD 7.2), on the
/// right side the right one 64.7 % (SD 6.7).
void TestBodyPosition::breathesMoreIntoTheLowerLung_data()
{
    QTest::addColumn<BodyPosition>("position");
    QTest::addColumn<double>("ofRight");
    QTest::newRow("back") << BodyPosition::Supine << 0.525;
    QTest::newRow("left side") << BodyPosition::LeftLateral << 1.0 - 0.576;
    QTest::newRow("right side") << BodyPosition::RightLateral << 0.647;
}

void TestBodyPosition::breathesMoreIntoTheLowerLung()
{
    constexpr double kWithin = 0.03;
    QFETCH(const BodyPosition, position);
    QFETCH(const double, ofRight);
    const BreathFigures breath = after(quiet(position), 30.0).lastBreath();
    VERIFY_WITHIN(breath.tidalVolumeOfLung[0] / breath.tidalVolume, ofRight, kWithin);
}

/// Anaesthesia takes resting volume from those who lie and not from those who sit.
void TestBodyPosition::losesNoRestingVolumeUnderAVentilatorSitting()
{
    for (const BodyPosition position : kBodyPositions) {
        RespiratorySettings settings = quiet(position);
        settings.ventilator.mode = VentilationMode::VolumeControl;
        const double share = gas_ml(restingContent(systemOf(settings))) / rest_ml(position);
        VERIFY_WITHIN(share, position == BodyPosition::Sitting ? 1.0 : 25.0 / 30.0, 0.005);
    }
}

/// Within a step nothing changes by more than a breath does.
void TestBodyPosition::turnsWithoutAJump()
{
    constexpr double kMostStep_ml = 3.0;
    RespiratoryFold fold = after(quiet(BodyPosition::Supine), 10.0);
    for (const BodyPosition position : {BodyPosition::Sitting, BodyPosition::LeftLateral,
                                        BodyPosition::Prone, BodyPosition::Supine}) {
        fold.set(quiet(position));
        for (int i = 0; i < 5000; ++i) {
            const double before_ml = gas_ml(fold.content());
            fold.step();
            VERIFY_WITHIN(gas_ml(fold.content()), before_ml, kMostStep_ml);
        }
        VERIFY_WITHIN(fold.system().sag, placed(position).sag, 0.01);
    }
}

void TestBodyPosition::sinksTowardsWhatIsBelow()
{
    const auto sag = [](BodyPosition position) { return placed(position).sag; };
    QCOMPARE(sag(BodyPosition::Supine), 0.0);
    QVERIFY(sag(BodyPosition::Prone) < sag(BodyPosition::Sitting));
    QVERIFY(sag(BodyPosition::Sitting) < 0.0);
    QCOMPARE(sag(BodyPosition::LeftLateral), sag(BodyPosition::RightLateral));
}

CARINA_TEST(TestBodyPosition)

} // namespace carina::body_position_test

#include "tst_body_position.moc"
