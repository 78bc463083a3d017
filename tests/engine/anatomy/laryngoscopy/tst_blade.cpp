#include "engine/anatomy/laryngoscopy/blade.h"
#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::blade_test
{

class TestBlade : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isFoundByItsName_data() { blades(); }
    void isFoundByItsName();
    void hasTheLengthOfItsSize_data();
    void hasTheLengthOfItsSize();
    void hasASagOfAnEleventhWhereItIsAMacintosh();
    void turnsAsMuchAsIsSaidWhereItIsHyperangulated();
    void seesItsTipInTheUpperHalfOfThePicture_data() { blades(); }
    void seesItsTipInTheUpperHalfOfThePicture();
    void looksBetweenTeethAndBlade();

private:
    static void blades()
    {
        QTest::addColumn<BladeKind>("kind");
        for (const BladeKind kind : kBladeKinds)
            QTest::newRow(bladeOf(kind).name.data()) << kind;
    }
};

void TestBlade::isFoundByItsName()
{
    QFETCH(const BladeKind, kind);
    QVERIFY(bladeFromName(bladeOf(kind).name) == kind);
    QVERIFY(!bladeFromName("macintosh-7"));
}

// As catalogues of makers have them.
void TestBlade::hasTheLengthOfItsSize_data()
{
    QTest::addColumn<BladeKind>("kind");
    QTest::addColumn<double>("length_mm");
    QTest::newRow("macintosh-0") << BladeKind::Macintosh0 << 80.0;
    QTest::newRow("macintosh-1") << BladeKind::Macintosh1 << 90.0;
    QTest::newRow("macintosh-2") << BladeKind::Macintosh2 << 105.0;
    QTest::newRow("macintosh-3") << BladeKind::Macintosh3 << 130.0;
    QTest::newRow("macintosh-4") << BladeKind::Macintosh4 << 155.0;
    QTest::newRow("miller-0") << BladeKind::Miller0 << 78.0;
    QTest::newRow("miller-1") << BladeKind::Miller1 << 102.0;
    QTest::newRow("miller-2") << BladeKind::Miller2 << 155.0;
}

void TestBlade::hasTheLengthOfItsSize()
{
    QFETCH(const BladeKind, kind);
    QFETCH(const double, length_mm);
    QVERIFY(std::abs(1e3 * bladeOf(kind).form.reach - length_mm) < 1e-9);
}

void TestBlade::hasASagOfAnEleventhWhereItIsAMacintosh()
{
    constexpr double kTolerance = 0.001;
    for (const BladeKind kind :
         {BladeKind::Macintosh0, BladeKind::Macintosh1, BladeKind::Macintosh2,
          BladeKind::Macintosh3, BladeKind::Macintosh4}) {
        const BladeForm& form = bladeOf(kind).form;
        QVERIFY(std::abs(form.sag / form.reach - 0.09) < kTolerance);
    }
    QVERIFY(bladeOf(BladeKind::Miller2).form.sag < 0.02 * bladeOf(BladeKind::Miller2).form.reach);
}

// Between the directions of short pieces of its middle line.
void TestBlade::turnsAsMuchAsIsSaidWhereItIsHyperangulated()
{
    constexpr double kTolerance_deg = 1.0;
    const BladeForm& form = bladeOf(BladeKind::Hyperangulated).form;
    const auto direction_deg = [&form](double share) {
        constexpr double kHalf = 1e-4;
        const Vec3 piece = middleOfBlade(form, share + kHalf) - middleOfBlade(form, share - kHalf);
        return inDegrees(radians(std::atan2(piece.y(), -piece.z())));
    };
    const double whole_deg = direction_deg(1.0) - direction_deg(0.0);
    const double half_deg = direction_deg(0.75) - direction_deg(0.25);
    qInfo("%.1f degrees, %.1f within its middle half", whole_deg, half_deg);
    QVERIFY(std::abs(whole_deg - 76.0) < kTolerance_deg);
    QVERIFY(std::abs(half_deg - 42.0) < kTolerance_deg);
}

void TestBlade::seesItsTipInTheUpperHalfOfThePicture()
{
    QFETCH(const BladeKind, kind);
    const Blade& blade = bladeOf(kind);
    const RigidTransform X_DL = cameraOnBlade(blade).inverse();
    const Vec3 tip = X_DL * middleOfBlade(blade.form, 1.0);
    QVERIFY(tip.z() < 0.0);
    QCOMPARE(std::abs(tip.x()) < 1e-12, true);
    const double up = tip.y() / -tip.z() / std::tan(0.5 * kScopeFieldOfView.si);
    QVERIFY2(up > 0.1 && up < 0.9, qPrintable(QString::number(up)));
    // The camera is on the underside, and no part of the blade is before it in the lower half.
    for (double share = 1.0 - blade.cameraToTip.si / blade.form.reach; share <= 1.0; share += 0.01)
        QVERIFY((X_DL * middleOfBlade(blade.form, share)).y() > 0.0);
}

// A straight blade in the plane y = 0 of A, 10 mm above the teeth; the target is 70 mm behind them.
void TestBlade::looksBetweenTeethAndBlade()
{
    const Blade& blade = bladeOf(BladeKind::Miller2);
    const Vec3 p_A_incisors{0.0, -0.012, -0.05};
    const Vec3 p_A_target{0.0, -0.012, -0.12};
    const RigidTransform X_AD = eyePastBlade(blade, {}, p_A_incisors, p_A_target);
    const Vec3 way = X_AD.rotation() * -Vec3::UnitZ();
    QVERIFY(std::abs((p_A_target - X_AD.translation()).norm() - 0.37) < 1e-3);
    QVERIFY((p_A_target - X_AD.translation()).normalized().isApprox(way));
    const double share = (p_A_incisors.z() - X_AD.translation().z()) / way.z();
    const double y = X_AD.translation().y() + share * way.y();
    QVERIFY(y > p_A_incisors.y());
    QVERIFY(y < middleOfBlade(blade.form, 0.05 / blade.form.reach).y() - kBladeHalfThickness);
}

CARINA_TEST(TestBlade)

} // namespace carina::blade_test

#include "tst_blade.moc"
