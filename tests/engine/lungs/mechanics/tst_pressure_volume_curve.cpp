#include "engine/lungs/mechanics/pressure_volume_curve.h"

#include "tests/engine/lungs/mechanics/within.h"
#include "tests/support/test_class.h"

namespace carina::pressure_volume_curve_test
{

namespace
{

constexpr double kTolerance_l = 1e-12;
constexpr double kTolerance_cmH2O = 1e-9;

/// A right lung with its side of the chest, patient of 77 kg (a = 0.646 L, b = 2.588 L, c = 11.3,
/// d = 8.9 cmH2O).
PressureVolumeCurve rightSide() { return {litres(0.646), litres(2.588), cmH2O(11.3), cmH2O(8.9)}; }

double volumeAt_l(const PressureVolumeCurve& curve, double p)
{
    return inLitres(curve.volumeAt(cmH2O(p)));
}

} // namespace

class TestPressureVolumeCurve : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isVenegasSigmoid();
    void givesThePublishedFiguresOfARightLung();
    void findsTheCurveThroughAPoint_data();
    void findsTheCurveThroughAPoint();
    void undoesItself();
    void isMostCompliantAtItsCentre();
    void goesStraightOnBeyondItsEnds_data();
    void goesStraightOnBeyondItsEnds();
};

/// a + b / (1 + e^-(P - c)/d): half of the span at the centre, 1/(1+e) of it a width below.
void TestPressureVolumeCurve::isVenegasSigmoid()
{
    VERIFY_WITHIN(volumeAt_l(rightSide(), 11.3), 0.646 + 1.294, kTolerance_l);
    VERIFY_WITHIN(volumeAt_l(rightSide(), 2.4), 0.646 + 2.588 / (1.0 + std::exp(1.0)),
                  kTolerance_l);
    VERIFY_WITHIN(volumeAt_l(rightSide(), 20.2), 0.646 + 2.588 / (1.0 + std::exp(-1.0)),
                  kTolerance_l);
}

/// Rest at no pressure and 52.5 % of 2.31 L, 0.05 L/cmH2O there, and 37 cmH2O for 95 % of the vital
/// capacity of 2.588 L.
void TestPressureVolumeCurve::givesThePublishedFiguresOfARightLung()
{
    const PressureVolumeCurve curve = rightSide();
    VERIFY_WITHIN(volumeAt_l(curve, 0.0), 0.525 * 2.31, 0.002);
    VERIFY_WITHIN(inLitresPerCmH2O(curve.complianceAt(litres(0.525 * 2.31))), 0.050, 0.0005);
    VERIFY_WITHIN(inCmH2O(curve.pressureAt(litres(0.646 + 0.95 * 2.588))), 37.0, 0.6);
}

void TestPressureVolumeCurve::findsTheCurveThroughAPoint_data()
{
    QTest::addColumn<double>("volume_l");
    QTest::addColumn<double>("compliance");
    QTest::newRow("low") << 0.5 << 0.08;
    QTest::newRow("middle") << 1.65 << 0.15;
    QTest::newRow("high") << 2.9 << 0.02;
}

void TestPressureVolumeCurve::findsTheCurveThroughAPoint()
{
    QFETCH(const double, volume_l);
    QFETCH(const double, compliance);
    const auto curve = PressureVolumeCurve::through(litres(0.3), litres(3.0), litres(volume_l),
                                                    cmH2O(5.0), litresPerCmH2O(compliance));
    QCOMPARE(curve.floor, litres(0.3));
    VERIFY_WITHIN(inLitres(curve.span), 2.7, kTolerance_l);
    VERIFY_WITHIN(volumeAt_l(curve, 5.0), volume_l, kTolerance_l);
    // The slope as a central difference.
    constexpr double kStep_cmH2O = 1e-4;
    const double slope =
        (volumeAt_l(curve, 5.0 + kStep_cmH2O) - volumeAt_l(curve, 5.0 - kStep_cmH2O))
        / (2.0 * kStep_cmH2O);
    VERIFY_WITHIN(slope, compliance, 1e-9);
    VERIFY_WITHIN(inLitresPerCmH2O(curve.complianceAt(litres(volume_l))), compliance, 1e-12);
}

void TestPressureVolumeCurve::undoesItself()
{
    const PressureVolumeCurve curve = rightSide();
    for (double p = -60.0; p <= 90.0; p += 1.5)
        VERIFY_WITHIN(inCmH2O(curve.pressureAt(curve.volumeAt(cmH2O(p)))), p, kTolerance_cmH2O);
}

/// b / (4 d) at the centre, less on both sides of it.
void TestPressureVolumeCurve::isMostCompliantAtItsCentre()
{
    const PressureVolumeCurve curve = rightSide();
    const Volume centre = litres(0.646 + 1.294);
    VERIFY_WITHIN(inLitresPerCmH2O(curve.complianceAt(centre)), 2.588 / (4.0 * 8.9), 1e-12);
    QVERIFY(curve.complianceAt(centre - litres(0.1)) < curve.complianceAt(centre));
    QVERIFY(curve.complianceAt(centre + litres(0.1)) < curve.complianceAt(centre));
}

void TestPressureVolumeCurve::goesStraightOnBeyondItsEnds_data()
{
    QTest::addColumn<double>("end"); // where the straight part begins, as a share of the span
    QTest::addColumn<double>("beyond");
    QTest::newRow("empty") << 0.01 << -0.2;
    QTest::newRow("full") << 0.99 << 1.2;
}

void TestPressureVolumeCurve::goesStraightOnBeyondItsEnds()
{
    QFETCH(const double, end);
    QFETCH(const double, beyond);
    const PressureVolumeCurve curve = rightSide();
    const auto pressureAtShare = [&](double share) {
        return inCmH2O(curve.pressureAt(litres(0.646 + share * 2.588)));
    };
    const double atEnd = 11.3 + 8.9 * std::log(end / (1.0 - end));
    VERIFY_WITHIN(pressureAtShare(end), atEnd, kTolerance_cmH2O);
    const double slope = 8.9 / (end * (1.0 - end)); // cmH2O for the whole span
    VERIFY_WITHIN(pressureAtShare(beyond), atEnd + slope * (beyond - end), 1e-6);
    VERIFY_WITHIN(volumeAt_l(curve, atEnd + slope * (beyond - end)), 0.646 + beyond * 2.588, 1e-9);
    VERIFY_WITHIN(inLitresPerCmH2O(curve.complianceAt(litres(0.646 + beyond * 2.588))),
                  2.588 * end * (1.0 - end) / 8.9, 1e-12);
}

CARINA_TEST(TestPressureVolumeCurve)

} // namespace carina::pressure_volume_curve_test

#include "tst_pressure_volume_curve.moc"
