#include "engine/audio/auscultation.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::auscultation_test
{
namespace
{

constexpr Length kFar = millimetres(160.0);

/// On the skin at one place, far from the others.
AuscultationDistances onThe(Length AuscultationDistances::*place)
{
    AuscultationDistances distances{kFar, kFar, kFar, kFar, kFar, {}};
    distances.*place = {};
    return distances;
}

} // namespace

class TestAuscultation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hearsWhatIsBeneath()
    {
        const auto right = auscultate(onThe(&AuscultationDistances::right));
        QCOMPARE(right.right, 1.0);
        QVERIFY(right.left < 0.1 && right.stomach < 0.1 && right.heart < 0.1);
        const auto stomach = auscultate(onThe(&AuscultationDistances::stomach));
        QCOMPARE(stomach.stomach, 1.0);
        QVERIFY(stomach.right < 0.1);
        QCOMPARE(auscultate(onThe(&AuscultationDistances::left)).left, 1.0);
        QCOMPARE(auscultate(onThe(&AuscultationDistances::heart)).heart, 1.0);
        QCOMPARE(auscultate(onThe(&AuscultationDistances::trachea)).trachea, 1.0);
    }

    // The other lung is heard faintly, as at a patient whose left side is not ventilated.
    void hearsTheOtherSideThroughTheChest()
    {
        const auto left = auscultate(onThe(&AuscultationDistances::left));
        QVERIFY(left.right >= kThroughChest && left.right < 0.1);
    }

    void hearsNothingOffTheSkin()
    {
        auto distances = onThe(&AuscultationDistances::right);
        distances.skin = millimetres(14.0);
        QCOMPARE(auscultate(distances).right, 1.0);
        distances.skin = millimetres(16.0);
        QCOMPARE(auscultate(distances), AuscultationGains{});
    }

    void isFainterFartherAway()
    {
        double before = 2.0;
        for (double mm = 0.0; mm < 200.0; mm += 10.0) {
            auto distances = onThe(&AuscultationDistances::heart);
            distances.right = millimetres(mm);
            const double heard = auscultate(distances).right;
            QVERIFY(heard < before);
            before = heard;
        }
    }

    // At a deviation's distance e^-1/2 of what is not heard everywhere.
    void reachesAsFarAsThePatientIsLarge()
    {
        auto distances = onThe(&AuscultationDistances::heart);
        distances.right = 0.4 * kAuscultationReach;
        const double expected = kThroughChest + (1.0 - kThroughChest) * std::exp(-0.5);
        QVERIFY(std::abs(auscultate(distances, 0.4).right - expected) < 1e-12);
        QVERIFY(auscultate(distances, 1.0).right > expected);
    }
};

CARINA_TEST(TestAuscultation)

} // namespace carina::auscultation_test

#include "tst_auscultation.moc"
