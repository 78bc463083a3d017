#include "engine/lungs/drawing/volume_cubic.h"
#include "tests/support/test_class.h"

namespace carina::volume_cubic_test
{

namespace
{

constexpr AmplitudeRange kRange{-1.0, 7.0};

/// k (s - r0)(s - r1)(s - r2).
VolumeCubic withRoots(double k, double r0, double r1, double r2)
{
    return {{-k * r0 * r1 * r2, k * (r0 * r1 + r1 * r2 + r2 * r0), -k * (r0 + r1 + r2), k}};
}

constexpr double kAmplitudeTolerance = 1e-9;

} // namespace

class TestVolumeCubic : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheRootNearestToTheLast_data();
    void findsTheRootNearestToTheLast();
    void reachesBothEndsOfTheRangeAndNothingBeyond();
    void findsRootsWhereThereIsNoCubicTerm_data();
    void findsRootsWhereThereIsNoCubicTerm();
    void touchesATurningPoint();
    void refusesWhatIsNotANumber();
};

void TestVolumeCubic::findsTheRootNearestToTheLast_data()
{
    QTest::addColumn<VolumeCubic>("cubic");
    QTest::addColumn<double>("nearest");
    QTest::addColumn<double>("root");
    const VolumeCubic wide = withRoots(1.0, 1.0, 2.0, 4.0);
    QTest::newRow("below all") << wide << -1.0 << 1.0;
    QTest::newRow("nearly in the middle of two, lower") << wide << 1.49 << 1.0;
    QTest::newRow("nearly in the middle of two, upper") << wide << 1.51 << 2.0;
    QTest::newRow("upper two, lower") << wide << 2.99 << 2.0;
    QTest::newRow("upper two, upper") << wide << 3.01 << 4.0;
    QTest::newRow("above all") << wide << 100.0 << 4.0;
    const VolumeCubic narrow = withRoots(-3.0, 1.0, 1.1, 1.2);
    QTest::newRow("narrow and falling, first") << narrow << 0.0 << 1.0;
    QTest::newRow("narrow and falling, second") << narrow << 1.11 << 1.1;
    QTest::newRow("narrow and falling, third") << narrow << 1.16 << 1.2;
    const VolumeCubic aroundRest = withRoots(2.0, -0.5, 0.0, 0.5);
    QTest::newRow("no square term, first") << aroundRest << -0.3 << -0.5;
    QTest::newRow("no square term, second") << aroundRest << 0.1 << 0.0;
    QTest::newRow("no square term, third") << aroundRest << 0.3 << 0.5;
    QTest::newRow("others outside the range") << withRoots(1.0, -2.0, 3.0, 8.0) << -1.0 << 3.0;
    QTest::newRow("two below the range") << withRoots(1.0, -3.0, -2.0, 6.0) << -1.0 << 6.0;
    QTest::newRow("two above the range") << withRoots(1.0, 0.5, 8.0, 9.0) << 7.0 << 0.5;
    QTest::newRow("one real root") << VolumeCubic{{-8.0, 0.0, 0.0, 1.0}} << 0.0 << 2.0;
    QTest::newRow("one real root, no turning point")
        << VolumeCubic{{-14.0, 3.0, 0.0, 1.0}} << 0.0 << 2.0;
}

void TestVolumeCubic::findsTheRootNearestToTheLast()
{
    QFETCH(VolumeCubic, cubic);
    QFETCH(double, nearest);
    QFETCH(double, root);
    const Result<double> s = amplitudeFor(cubic, cubicMetres(0.0), nearest, kRange);
    QVERIFY(s.has_value());
    QVERIFY2(std::abs(*s - root) < kAmplitudeTolerance, qPrintable(QString::number(*s, 'g', 15)));
    // The same cubic raised, asked for a volume raised as much.
    VolumeCubic raised = cubic;
    raised.c[0] += 0.25;
    const Result<double> same = amplitudeFor(raised, cubicMetres(0.25), nearest, kRange);
    QVERIFY(same && std::abs(*same - root) < kAmplitudeTolerance);
}

void TestVolumeCubic::reachesBothEndsOfTheRangeAndNothingBeyond()
{
    const VolumeCubic rising{{0.0, 1.0, 0.0, 0.0}};
    QCOMPARE(amplitudeFor(rising, cubicMetres(-1.0), 0.0, kRange).value(), -1.0);
    QCOMPARE(amplitudeFor(rising, cubicMetres(7.0), 0.0, kRange).value(), 7.0);
    for (const double beyond : {-1.000001, 7.000001}) {
        const Result<double> s = amplitudeFor(rising, cubicMetres(beyond), 0.0, kRange);
        QVERIFY(!s);
        QCOMPARE(s.error().code, Errc::VolumeUnreachable);
    }
    const Result<double> tooMuch = amplitudeFor(rising, cubicMetres(9.0), 0.0, kRange);
    QVERIFY(tooMuch.error().detail.find("9000000.0") != std::string::npos);
}

void TestVolumeCubic::findsRootsWhereThereIsNoCubicTerm_data()
{
    QTest::addColumn<VolumeCubic>("cubic");
    QTest::addColumn<double>("nearest");
    QTest::addColumn<double>("root");
    QTest::newRow("falling line") << VolumeCubic{{6.0, -2.0, 0.0, 0.0}} << 0.0 << 3.0;
    QTest::newRow("parabola, left") << VolumeCubic{{5.0, -6.0, 1.0, 0.0}} << 2.9 << 1.0;
    QTest::newRow("parabola, right") << VolumeCubic{{5.0, -6.0, 1.0, 0.0}} << 3.1 << 5.0;
    QTest::newRow("parabola at rest, left") << VolumeCubic{{-0.25, 0.0, 1.0, 0.0}} << -0.1 << -0.5;
    QTest::newRow("parabola at rest, right") << VolumeCubic{{0.25, 0.0, -1.0, 0.0}} << 0.1 << 0.5;
}

void TestVolumeCubic::findsRootsWhereThereIsNoCubicTerm() { findsTheRootNearestToTheLast(); }

void TestVolumeCubic::touchesATurningPoint()
{
    const VolumeCubic parabola{{4.0, -4.0, 1.0, 0.0}}; // (s - 2)^2
    QCOMPARE(amplitudeFor(parabola, cubicMetres(0.0), 0.0, kRange).value(), 2.0);
    QVERIFY(!amplitudeFor(parabola, cubicMetres(-1e-9), 0.0, kRange));
}

void TestVolumeCubic::refusesWhatIsNotANumber()
{
    const VolumeCubic rising{{0.0, 1.0, 0.0, 0.0}};
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    for (const auto& [volume, nearest] : {std::pair{nan, 0.0}, {inf, 0.0}, {1.0, nan}, {1.0, inf}})
        QCOMPARE(amplitudeFor(rising, cubicMetres(volume), nearest, kRange).error().code,
                 Errc::NotFinite);
}

CARINA_TEST(TestVolumeCubic)

} // namespace carina::volume_cubic_test

#include "tst_volume_cubic.moc"
