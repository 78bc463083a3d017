#include "engine/registration/fit/manikin_scale.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::manikin_scale_test
{
namespace
{

constexpr int kRegistrations = 1000;
constexpr Length kFle = millimetres(1.0);
constexpr double kExact = 1e-12;

/// Touches of a manikin of that size, which lies anywhere.
std::vector<LandmarkPair> touched(test::Hand& hand, int count, double size, Length fle)
{
    const RigidTransform X_MA = hand.pose();
    std::vector<LandmarkPair> pairs;
    for (const Vec3& p_AQ : test::firstLandmarks(count))
        pairs.push_back({p_AQ, X_MA * Vec3{size * p_AQ + fle.si / std::sqrt(3.0) * hand.unit()}});
    return pairs;
}

int calledOff(int count, double size, unsigned seed)
{
    test::Hand hand{seed};
    int off = 0;
    for (int i = 0; i < kRegistrations; ++i)
        off += manikinScale(touched(hand, count, size, kFle))->isOff() ? 1 : 0;
    return off;
}

} // namespace

class TestManikinScale : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheSizeOfExactTouches()
    {
        test::Hand hand{151};
        for (const double size : {0.9, 0.97, 1.0, 1.005, 1.03, 1.2}) {
            const auto found = manikinScale(touched(hand, 8, size, {}));
            QVERIFY(found && std::abs(found->scale - size) < kExact);
            QVERIFY(found->deviation < 1e-7);
            QCOMPARE(found->degrees, 17.0);
            QCOMPARE(found->isOff(), std::abs(size - 1.0) > kNoticedScale);
        }
    }

    /// The standard error is that of many registrations: FLE / sqrt(3 sum |d|^2).
    void knowsHowSureItIs_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {4, 6, 8})
            QTest::addRow("%d landmarks", count) << count;
    }

    void knowsHowSureItIs()
    {
        QFETCH(int, count);
        const std::vector<Vec3> p_A = test::firstLandmarks(count);
        Vec3 mean = Vec3::Zero();
        for (const Vec3& p : p_A)
            mean += p / count;
        double spread = 0.0;
        for (const Vec3& p : p_A)
            spread += (p - mean).squaredNorm();
        const double expected = kFle.si / std::sqrt(3.0 * spread);
        test::Hand hand{157};
        double sum = 0.0;
        double squares = 0.0;
        double variances = 0.0;
        for (int i = 0; i < kRegistrations; ++i) {
            const auto found = manikinScale(touched(hand, count, 1.03, kFle));
            sum += (found->scale - 1.03) / kRegistrations;
            squares += std::pow(found->scale - 1.03, 2) / kRegistrations;
            variances += std::pow(found->deviation, 2) / kRegistrations;
        }
        QVERIFY(std::abs(sum) < 4.0 * expected / std::sqrt(double(kRegistrations)));
        QVERIFY(std::abs(std::sqrt(squares) / expected - 1.0) < 0.08);
        QVERIFY(std::abs(std::sqrt(variances) / expected - 1.0) < 0.08);
    }

    /// A manikin 3 % larger or smaller is found, one of the right size seldom called wrong.
    void findsAManikinOfAnotherSize_data()
    {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("fewestFound"); // of 1,000
        QTest::newRow("four landmarks") << 4 << 950;
        QTest::newRow("six landmarks") << 6 << 990;
        QTest::newRow("eight landmarks") << 8 << 990;
    }

    void findsAManikinOfAnotherSize()
    {
        QFETCH(int, count);
        QFETCH(int, fewestFound);
        const int larger = calledOff(count, 1.03, 163);
        const int smaller = calledOff(count, 0.97, 167);
        const int falseAlarms = calledOff(count, 1.0, 173);
        qInfo("%d landmarks: 3 %% larger found in %d, 3 %% smaller in %d, false alarms %d of %d",
              count, larger, smaller, falseAlarms, kRegistrations);
        QVERIFY(larger >= fewestFound);
        QVERIFY(smaller >= fewestFound);
        QVERIFY(falseAlarms <= 0.02 * kRegistrations);
    }

    void isOneAfterThePatientWasMadeToSize()
    {
        test::Hand hand{179};
        const auto pairs = touched(hand, 8, 1.03, kFle);
        const auto found = manikinScale(pairs);
        const auto again = manikinScale(withAnatomyScaled(pairs, found->scale));
        QVERIFY(std::abs(again->scale - 1.0) < kExact);
    }

    void refusesWhatTellsNothing()
    {
        test::Hand hand{181};
        QCOMPARE(manikinScale(touched(hand, 3, 1.0, kFle)).error().code, Errc::TooFewLandmarks);
        auto line = touched(hand, 4, 1.0, {});
        for (std::size_t i = 0; i < line.size(); ++i)
            line[i] = {double(i) * Vec3::UnitX() / 10.0, double(i) * Vec3::UnitY() / 10.0};
        QCOMPARE(manikinScale(line).error().code, Errc::DegenerateLandmarks);
    }
};

CARINA_TEST(TestManikinScale)

} // namespace carina::manikin_scale_test

#include "tst_manikin_scale.moc"
