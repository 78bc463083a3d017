#include "engine/core/units.h"
#include "tests/support/test_class.h"

#include <numbers>

namespace carina::units_test
{

class UnitsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void convertsEachUnitToSi_data()
    {
        QTest::addColumn<double>("si");
        QTest::addColumn<double>("expected");
        QTest::newRow("metres") << metres(2.5).si << 2.5;
        QTest::newRow("millimetres") << millimetres(250.0).si << 0.25;
        QTest::newRow("radians") << radians(0.5).si << 0.5;
        QTest::newRow("degrees") << degrees(180.0).si << std::numbers::pi;
        QTest::newRow("cubic metres") << cubicMetres(0.003).si << 0.003;
        QTest::newRow("millilitres") << millilitres(280.0).si << 280e-6;
        QTest::newRow("litres") << litres(2.5).si << 0.0025;
        QTest::newRow("cmH2O") << cmH2O(10.0).si << 980.665;
        QTest::newRow("litres per second") << litresPerSecond(0.5).si << 0.0005;
        QTest::newRow("litres per cmH2O") << litresPerCmH2O(0.0980665).si << 1e-6;
        QTest::newRow("cmH2O seconds per litre") << cmH2OSecondsPerLitre(2.0).si << 196133.0;
        QTest::newRow("hertz") << hertz(60.0).si << 60.0;
        QTest::newRow("per minute") << perMinute(30.0).si << 0.5;
    }
    void convertsEachUnitToSi()
    {
        QFETCH(double, si);
        QTEST(si, "expected");
    }

    void givesBackWhatItWasMadeFrom()
    {
        QCOMPARE(inMillimetres(millimetres(12.5)), 12.5);
        QCOMPARE(inDegrees(degrees(37.0)), 37.0);
        QCOMPARE(inMillilitres(millilitres(540.0)), 540.0);
        QCOMPARE(inPerMinute(perMinute(19.0)), 19.0);
        QCOMPARE(inLitres(litres(2.31)), 2.31);
        QCOMPARE(inCmH2O(cmH2O(11.3)), 11.3);
        QCOMPARE(inLitresPerSecond(litresPerSecond(0.6)), 0.6);
        QCOMPARE(inLitresPerCmH2O(litresPerCmH2O(0.1)), 0.1);
        QCOMPARE(inCmH2OSecondsPerLitre(cmH2OSecondsPerLitre(1.575)), 1.575);
    }

    void addsScalesAndCompares()
    {
        QCOMPARE(metres(1.0) + millimetres(500.0), metres(1.5));
        QCOMPARE(metres(1.0) - millimetres(500.0), metres(0.5));
        QCOMPARE(3.0 * metres(2.0), metres(6.0));
        QCOMPARE(metres(2.0) * 3.0, metres(6.0));
        QCOMPARE(metres(3.0) / metres(2.0), 1.5);
        QVERIFY(millimetres(999.0) < metres(1.0));
        QVERIFY(degrees(181.0) > radians(std::numbers::pi));
    }
};

CARINA_TEST(UnitsTest)

} // namespace carina::units_test

#include "tst_units.moc"
