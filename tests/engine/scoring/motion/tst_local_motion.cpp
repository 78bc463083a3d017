#include "engine/scoring/motion/local_motion.h"

#include "tests/support/test_class.h"

#include <array>
#include <cmath>
#include <vector>

namespace carina::local_motion_test
{
namespace
{

constexpr double kRounding = 1e-9;

/// What derivative `order` makes of a 1 at one of evenly spaced points and 0 at all others.
double coefficient(std::size_t points, std::size_t one, int order)
{
    std::vector<TimedPoint> samples(points);
    for (std::size_t i = 0; i < points; ++i)
        samples[i].seconds = double(i) - 0.5 * double(points - 1);
    samples[one].p_F.x() = 1.0;
    const LocalMotion motion = motionAtZero(samples);
    return std::array{motion.p_F.x(), motion.v_F.x(), motion.a_F.x(), motion.j_F.x()}.at(
        std::size_t(order));
}

} // namespace

class TestLocalMotion : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasTheCoefficientsOfSavitzkyAndGolay_data();
    void hasTheCoefficientsOfSavitzkyAndGolay();
    void isThatOfACubicWhateverTheTimes();
};

/// Their tables I, IV, VI and X, with the misprints of the first edition corrected.
void TestLocalMotion::hasTheCoefficientsOfSavitzkyAndGolay_data()
{
    QTest::addColumn<int>("order");
    QTest::addColumn<QList<double>>("numerators");
    QTest::addColumn<double>("norm");
    QTest::newRow("position, 5 points") << 0 << QList<double>{-3, 12, 17, 12, -3} << 35.0;
    QTest::newRow("position, 7 points") << 0 << QList<double>{-2, 3, 6, 7, 6, 3, -2} << 21.0;
    QTest::newRow("first derivative, 5 points") << 1 << QList<double>{1, -8, 0, 8, -1} << 12.0;
    QTest::newRow("first derivative, 7 points")
        << 1 << QList<double>{22, -67, -58, 0, 58, 67, -22} << 252.0;
    QTest::newRow("second derivative, 7 points")
        << 2 << QList<double>{5, 0, -3, -4, -3, 0, 5} << 42.0;
    QTest::newRow("third derivative, 7 points")
        << 3 << QList<double>{-1, 1, 1, 0, -1, -1, 1} << 6.0;
}

void TestLocalMotion::hasTheCoefficientsOfSavitzkyAndGolay()
{
    QFETCH(const int, order);
    QFETCH(const QList<double>, numerators);
    QFETCH(const double, norm);
    for (qsizetype i = 0; i < numerators.size(); ++i) {
        const double found = coefficient(std::size_t(numerators.size()), std::size_t(i), order);
        QVERIFY(std::abs(found - numerators[i] / norm) < kRounding);
    }
}

void TestLocalMotion::isThatOfACubicWhateverTheTimes()
{
    const Vec3 p_F{0.3, -0.1, 0.7};
    const Vec3 v_F{0.2, 0.0, -0.5};
    const Vec3 a_F{-1.0, 2.0, 0.4};
    const Vec3 j_F{6.0, -12.0, 3.0};
    std::vector<TimedPoint> samples;
    for (const double t : {-0.21, -0.19, -0.08, -0.07, 0.02, 0.11, 0.2})
        samples.push_back({t, p_F + t * v_F + t * t / 2.0 * a_F + t * t * t / 6.0 * j_F});
    const LocalMotion motion = motionAtZero(samples);
    QVERIFY((motion.p_F - p_F).norm() < kRounding);
    QVERIFY((motion.v_F - v_F).norm() < kRounding);
    QVERIFY((motion.a_F - a_F).norm() < kRounding);
    QVERIFY((motion.j_F - j_F).norm() < 10.0 * kRounding);
}

CARINA_TEST(TestLocalMotion)

} // namespace carina::local_motion_test

#include "tst_local_motion.moc"
