#include "engine/lungs/drawing/chest_pose.h"
#include "tests/support/test_class.h"

namespace carina::chest_pose_test
{

namespace
{

constexpr double kSame_m = 1e-12;

/// A chest of the size of an adult's.
ChestField adultChest()
{
    Box lungs_A;
    lungs_A.include(Vec3{-0.13, -0.10, -0.15});
    lungs_A.include(Vec3{0.13, 0.09, 0.10});
    return {lungs_A, {-0.039, 0.0045, -0.0125}, {0.039, 0.0045, -0.0125}};
}

ChestPose bothLungs(const LungPose& lung) { return {{lung, lung}, 0.0}; }

Vec3 moved_mm(ChestRegion region, const ChestPose& pose, const Vec3& p_A)
{
    return 1e3 * adultChest().at(p_A, motionOf(region, pose, adultChest())).d_A;
}

const Vec3 kBaseBehind{-0.09, 0.07, -0.13};
const Vec3 kDome{-0.07, 0.0, -0.09};
const Vec3 kSternum{-0.01, -0.10, -0.06};
const Vec3 kAxilla{-0.13, 0.0, -0.05};
const Vec3 kHeart{0.02, -0.04, -0.06};

} // namespace

class TestChestPose : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lowersTheBaseMostOfAllBehind();
    void slidesOutwardAsTheBaseGoesDown();
    void movesTheRibsForwardUpwardAndOutward();
    void letsTheInsideSinkToTheBack();
    void collapsesTowardsTheHilum();
    void movesEachLungByItsOwnPose();
    void movesTheDiaphragmWithTheLungsAbove();
    void lowersTheDiaphragmBesideACollapsedLung();
    void keepsTheAttachmentOfTheDiaphragm();
    void movesTheBronchiWithTheLungsAround();
    void movesTheWallWithTheLungsBeneathAndUpward();
    void slidesLowerLobesAlongTheFissure();
    void shiftsTheMediastinumAlone();
    void movesNothingElse();
    void knowsHowMuchOfTheRangeIsTaken_data();
    void knowsHowMuchOfTheRangeIsTaken();
    void endsWhereTheRangeDoes_data();
    void endsWhereTheRangeDoes();
    void hasNoAmplitudesOutsideTheRange();
    void exaggeratesAsFarAsTheRangeGoes();
};

// The base by 7.5 % of 250 mm behind; where the heart lies on the diaphragm 30 % less.
void TestChestPose::lowersTheBaseMostOfAllBehind()
{
    const ChestPose pose = bothLungs({.diaphragm = 1.0});
    const Vec3 corner = moved_mm(ChestRegion::RightUpperLung, pose, {-0.13, 0.13, -0.15});
    QVERIFY2(-corner.z() > 18.0 && -corner.z() < 18.75, qPrintable(QString::number(corner.z())));
    const Vec3 middle = moved_mm(ChestRegion::Diaphragm, pose, {0.0, 0.13, -0.15});
    QVERIFY(std::abs(middle.z() / corner.z() - 0.7) < 0.01);
    const Vec3 behind = moved_mm(ChestRegion::RightUpperLung, pose, kBaseBehind);
    const Vec3 inFront = moved_mm(ChestRegion::RightUpperLung, pose, {-0.09, -0.09, -0.13});
    QVERIFY(-behind.z() > 14.0 && behind.z() > corner.z());
    QVERIFY(inFront.z() < 0.0 && inFront.z() > 0.25 * behind.z());
}

// The chest is wider below: what goes down beneath the ribs goes outward, and nothing to the back.
void TestChestPose::slidesOutwardAsTheBaseGoesDown()
{
    const ChestPose pose = bothLungs({.diaphragm = 1.0});
    const Vec3 side = moved_mm(ChestRegion::RightUpperLung, pose, kAxilla);
    QVERIFY2(-side.x() > 0.3 && -side.x() < 0.5 * -side.z(), qPrintable(QString::number(side.x())));
    QCOMPARE(side.y(), 0.0);
    QCOMPARE(moved_mm(ChestRegion::Diaphragm, pose, {0.0, 0.05, -0.05}).x(), 0.0);
    QCOMPARE(moved_mm(ChestRegion::Wall, pose, kAxilla).norm(), 0.0);
}

// 1.8 % of 250 mm forward, and outward less; ribs of an adult in quiet breathing, seated, go 3 to 5
// and 1 to 2 mm.
void TestChestPose::movesTheRibsForwardUpwardAndOutward()
{
    const ChestPose pose = bothLungs({.ribs = 1.0});
    const Vec3 sternum = moved_mm(ChestRegion::Wall, pose, kSternum);
    QVERIFY2(-sternum.y() > 3.0 && -sternum.y() < 5.0, qPrintable(QString::number(sternum.y())));
    QVERIFY(sternum.z() > 3.0 && sternum.z() < 5.0);
    QCOMPARE(moved_mm(ChestRegion::Skin, pose, kSternum), sternum);
    const Vec3 side = moved_mm(ChestRegion::Wall, pose, kAxilla);
    QVERIFY2(-side.x() > 1.0 && -side.x() < 2.5, qPrintable(QString::number(side.x())));
    const Vec3 other = moved_mm(ChestRegion::Wall, pose, {0.13, 0.0, -0.05});
    QVERIFY((other - Vec3{-side.x(), side.y(), side.z()}).norm() < 1e-9);
}

void TestChestPose::letsTheInsideSinkToTheBack()
{
    const Vec3 middle{-0.12, -0.005, -0.025};
    const Vec3 sunk = moved_mm(ChestRegion::RightUpperLung, bothLungs({.gravity = 1.0}), middle);
    QVERIFY(sunk.y() > 9.0 && sunk.y() <= 10.0); // 4 % of 250 mm
    QVERIFY(sunk.x() == 0.0 && sunk.z() == 0.0);
}

void TestChestPose::collapsesTowardsTheHilum()
{
    const ChestPose pose{{LungPose{.collapse = 0.3}, LungPose{}}, 0.0};
    const Vec3 hilum{-0.039, 0.0045, -0.0125};
    const Vec3 moved = moved_mm(ChestRegion::RightUpperLung, pose, kAxilla);
    QVERIFY((moved - 300.0 * (hilum - kAxilla)).norm() < 1e-9);
}

void TestChestPose::movesEachLungByItsOwnPose()
{
    const ChestPose pose{{LungPose{1.0, 0.5, 0.2, 0.1}, LungPose{3.0, 1.0, -0.4, 0.0}}, 0.1};
    const ChestPose right{{pose.lungs[0], {}}, 0.1};
    const ChestPose left{{LungPose{}, pose.lungs[1]}, 0.1};
    for (const Vec3& p_A : {kBaseBehind, kDome, kSternum, kHeart}) {
        for (const ChestRegion lung : {ChestRegion::RightUpperLung, ChestRegion::RightLowerLung})
            QCOMPARE(moved_mm(lung, pose, p_A), moved_mm(lung, right, p_A));
        for (const ChestRegion lung : {ChestRegion::LeftUpperLung, ChestRegion::LeftLowerLung})
            QCOMPARE(moved_mm(lung, pose, p_A), moved_mm(lung, left, p_A));
    }
}

void TestChestPose::movesTheDiaphragmWithTheLungsAbove()
{
    const ChestPose pose{{2.0 * kQuietBreath, kQuietBreath}, 0.05};
    for (const Vec3& p_A : {kBaseBehind, kDome})
        QVERIFY((moved_mm(ChestRegion::Diaphragm, pose, p_A)
                 - moved_mm(ChestRegion::RightUpperLung, pose, p_A))
                    .norm()
                < kSame_m);
    const ChestPose collapsed{{LungPose{.collapse = 0.3}, LungPose{}}, 0.0};
    QCOMPARE(moved_mm(ChestRegion::Diaphragm, collapsed, kDome).norm(), 0.0);
    const ChestPose leftCollapsed{{LungPose{}, LungPose{.collapse = 0.3}}, 0.0};
    QCOMPARE(moved_mm(ChestRegion::Diaphragm, leftCollapsed, {0.07, 0.0, -0.09}).norm(), 0.0);
}

// Gas under tension lowers its half of the diaphragm and widens its ribs, whatever the lung does.
void TestChestPose::lowersTheDiaphragmBesideACollapsedLung()
{
    ChestPose pose{{LungPose{.collapse = 0.35}, LungPose{}}, 0.0};
    pose.walls = {3.0 * kQuietBreath, LungPose{}};
    const ChestPose breathed{{3.0 * kQuietBreath, LungPose{}}, 0.0};
    for (const Vec3& p_A : {kBaseBehind, kDome, kAxilla})
        for (const ChestRegion region : {ChestRegion::Diaphragm, ChestRegion::Wall})
            QCOMPARE(moved_mm(region, pose, p_A), moved_mm(region, breathed, p_A));
    const ChestPose lung{pose.lungs, 0.0};
    QCOMPARE(moved_mm(ChestRegion::RightUpperLung, pose, kDome),
             moved_mm(ChestRegion::RightUpperLung, lung, kDome));
    QCOMPARE(exaggerated(pose, 1.1).walls->at(0), 1.1 * pose.walls->at(0));
    pose.walls->at(0).diaphragm = kMostDescent;
    QCOMPARE(rangeTaken(pose), 1.0);
}

// 80 mm below the lungs, and half of that.
void TestChestPose::keepsTheAttachmentOfTheDiaphragm()
{
    const ChestPose pose = bothLungs({.diaphragm = kMostDescent});
    const double base = moved_mm(ChestRegion::Diaphragm, pose, {-0.09, 0.07, -0.15}).z();
    const double edge = moved_mm(ChestRegion::Diaphragm, pose, {-0.09, 0.07, -0.23}).z();
    QVERIFY2(base < -55.0 && edge > 0.6 * base, qPrintable(QString::number(edge / base)));
    QCOMPARE(moved_mm(ChestRegion::Diaphragm, pose, {-0.09, 0.07, -0.33}).z(), 0.0);
    const ChestPose raised = bothLungs({.ribs = 2.0});
    QCOMPARE(moved_mm(ChestRegion::Wall, raised, {-0.01, -0.10, -0.33}).z(), 0.0);
}

void TestChestPose::movesTheBronchiWithTheLungsAround()
{
    const ChestPose pose{{LungPose{2.0, 0.5, 0.3, 0.1}, LungPose{1.0, 0.2, 0.0, 0.2}}, 0.05};
    QVERIFY((moved_mm(ChestRegion::Bronchi, pose, kDome)
             - moved_mm(ChestRegion::RightUpperLung, pose, kDome))
                .norm()
            < kSame_m);
    const Vec3 left{0.07, 0.02, -0.05};
    QVERIFY((moved_mm(ChestRegion::Bronchi, pose, left)
             - moved_mm(ChestRegion::LeftUpperLung, pose, left))
                .norm()
            < kSame_m);
}

void TestChestPose::movesTheWallWithTheLungsBeneathAndUpward()
{
    const ChestPose pose = bothLungs({.ribs = 1.5});
    for (const Vec3& p_A : {kSternum, kAxilla}) {
        const Vec3 wall = moved_mm(ChestRegion::Wall, pose, p_A);
        const Vec3 lung = moved_mm(ChestRegion::RightUpperLung, pose, p_A);
        QVERIFY(std::abs(wall.x() - lung.x()) < kSame_m && std::abs(wall.y() - lung.y()) < kSame_m);
        QVERIFY(wall.z() > 0.0 && lung.z() == 0.0);
    }
}

void TestChestPose::slidesLowerLobesAlongTheFissure()
{
    const ChestPose pose = bothLungs({.diaphragm = 1.0});
    const Vec3 middle{-0.12, -0.005, -0.025};
    const Vec3 slid = moved_mm(ChestRegion::RightLowerLung, pose, middle)
                      - moved_mm(ChestRegion::RightUpperLung, pose, middle);
    QVERIFY(slid.norm() > 0.33 && slid.norm() <= 0.375); // 0.15 % of 250 mm
    QVERIFY((slid.normalized() - Vec3{0.0, -0.8, -0.6}).norm() < 1e-9);
    const Vec3 onWall = moved_mm(ChestRegion::RightLowerLung, pose, {-0.12, 0.09, -0.025})
                        - moved_mm(ChestRegion::RightUpperLung, pose, {-0.12, 0.09, -0.025});
    QVERIFY(onWall.norm() < kSame_m);
}

void TestChestPose::shiftsTheMediastinumAlone()
{
    const ChestPose pose{{kQuietBreath, kQuietBreath}, 0.2};
    const Vec3 heart = moved_mm(ChestRegion::Mediastinum, pose, kHeart);
    QVERIFY(heart.x() > 23.0 && heart.x() < 26.0); // of 0.2 x 130 mm
    // The trachea deviates in the neck, below the larynx, which stays.
    QVERIFY(moved_mm(ChestRegion::Mediastinum, pose, {0.0, 0.0, 0.10}).x() > 12.0);
    QCOMPARE(moved_mm(ChestRegion::Mediastinum, pose, {0.0, 0.0, 0.18}).x(), 0.0);
    QVERIFY(heart.y() == 0.0 && heart.z() == 0.0);
    QCOMPARE(moved_mm(ChestRegion::Wall, {{}, 0.2}, kSternum).norm(), 0.0);
}

void TestChestPose::movesNothingElse()
{
    const ChestPose pose{{LungPose{2.0, 1.0, 0.3, 0.1}, LungPose{1.0, 0.2, 0.1, 0.2}}, 0.1};
    for (const Vec3& p_A : {kDome, kSternum, kHeart})
        for (const ChestRegion still :
             {ChestRegion::Still, ChestRegion::LooseTooth, ChestRegion::Teeth})
            QCOMPARE(moved_mm(still, pose, p_A).norm(), 0.0);
}

void TestChestPose::knowsHowMuchOfTheRangeIsTaken_data()
{
    QTest::addColumn<LungPose>("right");
    QTest::addColumn<double>("shift");
    QTest::addColumn<double>("taken");
    const double inf = std::numeric_limits<double>::infinity();
    QTest::newRow("rest") << LungPose{} << 0.0 << 0.0;
    QTest::newRow("breathed in") << LungPose{.diaphragm = 2.1, .ribs = 2.0} << 0.0 << 0.5;
    QTest::newRow("ribs out") << LungPose{.diaphragm = 1.0, .ribs = -1.5} << 0.0 << 0.5;
    QTest::newRow("face down") << LungPose{.diaphragm = 1.0, .gravity = -1.2} << 0.0 << 0.75;
    QTest::newRow("half collapsed") << LungPose{.diaphragm = 1.05, .collapse = 0.2} << 0.0 << 0.75;
    QTest::newRow("air trapped") << LungPose{.diaphragm = 1.05, .collapse = -0.3} << 0.0 << 0.75;
    QTest::newRow("only collapsed") << LungPose{.collapse = 0.23} << 0.0 << 0.5;
    QTest::newRow("only collapsed, shifted into it") << LungPose{.collapse = 0.23} << -0.1 << 0.75;
    QTest::newRow("only collapsed, shifted away") << LungPose{.collapse = 0.46} << 0.3 << 1.0;
    QTest::newRow("shifted into it") << LungPose{.diaphragm = 1.05} << -0.2 << 0.75;
    QTest::newRow("shifted away") << LungPose{.diaphragm = 3.15} << 0.2 << 0.75;
    QTest::newRow("shifted too far") << LungPose{} << 0.4001 << inf;
    QTest::newRow("shifted too far to the right") << LungPose{} << -0.4001 << inf;
}

void TestChestPose::knowsHowMuchOfTheRangeIsTaken()
{
    QFETCH(LungPose, right);
    QFETCH(double, shift);
    QFETCH(double, taken);
    QCOMPARE(rangeTaken({{right, LungPose{}}, shift}), taken);
    QCOMPARE(rangeTaken({{LungPose{}, right}, -shift}), taken);
}

void TestChestPose::endsWhereTheRangeDoes_data()
{
    QTest::addColumn<LungPose>("given");
    QTest::addColumn<LungPose>("along");
    QTest::addColumn<double>("shiftInto");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("greatest");
    constexpr LungPose kDown{.diaphragm = 1.0};
    constexpr LungPose kShrink{.collapse = 1.0};
    QTest::newRow("diaphragm") << LungPose{} << kDown << 0.0 << -3.0 << 4.2;
    QTest::newRow("ribs") << LungPose{} << LungPose{.ribs = 1.0} << 0.0 << -3.0 << 10.0;
    QTest::newRow("diaphragm the other way") << LungPose{} << -2.0 * kDown << 0.0 << -2.1 << 1.5;
    QTest::newRow("from below rest") << LungPose{.diaphragm = -1.0} << kDown << 0.0 << -2.0 << 5.2;
    QTest::newRow("beside ribs") << LungPose{.ribs = 10.0} << kDown << 0.0 << -3.0 << 4.2;
    QTest::newRow("half collapsed") << LungPose{.collapse = 0.2} << kDown << 0.0 << -1.5 << 2.1;
    QTest::newRow("shifted into it") << LungPose{} << kDown << 0.2 << -1.5 << 2.1;
    QTest::newRow("shifted away") << LungPose{} << kDown << -0.4 << -3.0 << 4.2;
    QTest::newRow("air trapped") << LungPose{.collapse = -0.3} << kDown << 0.0 << -1.5 << 2.1;
    QTest::newRow("collapse alone") << LungPose{} << kShrink << 0.0 << -0.6 << 0.46;
    QTest::newRow("collapse alone, shifted into it")
        << LungPose{} << kShrink << 0.2 << -0.3 << 0.23;
    QTest::newRow("collapse of a lung that sags")
        << LungPose{.gravity = 0.8} << kShrink << 0.0 << -0.3 << 0.2;
    QTest::newRow("collapse of half a breath")
        << LungPose{.diaphragm = 2.1} << kShrink << 0.0 << -0.3 << 0.2;
    QTest::newRow("gravity") << LungPose{} << LungPose{.gravity = 0.4} << 0.0 << -4.0 << 4.0;
}

void TestChestPose::endsWhereTheRangeDoes()
{
    QFETCH(LungPose, given);
    QFETCH(LungPose, along);
    QFETCH(double, shiftInto);
    QFETCH(double, least);
    QFETCH(double, greatest);
    const auto range = amplitudesWithin(given, along, shiftInto);
    QVERIFY(range.has_value());
    QVERIFY(std::abs(range->least - least) < 1e-12);
    QVERIFY(std::abs(range->greatest - greatest) < 1e-12);
    const auto takenAt = [&](double s) {
        return rangeTaken({{LungPose{}, given + s * along}, shiftInto});
    };
    QVERIFY(takenAt(0.5 * (least + greatest)) <= 1.0);
    QVERIFY(takenAt(greatest - 1e-9) <= 1.0 && takenAt(greatest + 1e-9) > 1.0);
    QVERIFY(takenAt(least + 1e-9) <= 1.0 && takenAt(least - 1e-9) > 1.0);
}

void TestChestPose::hasNoAmplitudesOutsideTheRange()
{
    constexpr LungPose kDown{.diaphragm = 1.0};
    QVERIFY(!amplitudesWithin({.ribs = 10.1}, kDown, 0.0));
    QVERIFY(!amplitudesWithin({.gravity = -1.61}, kDown, 0.0));
    QVERIFY(!amplitudesWithin({.collapse = 0.401}, kDown, 0.0));
    QVERIFY(!amplitudesWithin({.collapse = -0.601}, kDown, 0.0));
    QVERIFY(!amplitudesWithin({}, kDown, 0.401));
    QVERIFY(!amplitudesWithin({}, kDown, -0.401));
    QVERIFY(!amplitudesWithin({.collapse = 0.3}, kDown, 0.2));
}

void TestChestPose::exaggeratesAsFarAsTheRangeGoes()
{
    const ChestPose pose{{LungPose{1.0, 0.5, 0.2, 0.0}, LungPose{2.0, 0.0, 0.0, 0.0}}, 0.0};
    QCOMPARE(exaggerated(pose, 1.0), pose);
    const ChestPose twice = exaggerated(pose, 2.0);
    QCOMPARE(twice.lungs[0], (LungPose{2.0, 1.0, 0.4, 0.0}));
    QCOMPARE(twice.lungs[1], (LungPose{4.0, 0.0, 0.0, 0.0}));
    QCOMPARE(exaggerated(pose, 100.0).lungs[1].diaphragm, 4.2);
    QCOMPARE(exaggerated(ChestPose{}, 3.0), ChestPose{});
    QCOMPARE(exaggerated({{}, 0.05}, 2.0).mediastinalShift, 0.1);
}

CARINA_TEST(TestChestPose)

} // namespace carina::chest_pose_test

#include "tst_chest_pose.moc"
