#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/labels/visible_places.h"
#include "widgets/scene/view/graphics.h"

#include <memory>
#include <numbers>

namespace carina::lifted_parts_test
{
namespace
{

using namespace carina::test;

constexpr double kRadius = 0.05;         ///< metres
constexpr double kPixelShare = 0.05;     ///< of a disc, by rounding at its rim
constexpr double kPlaceTolerance = 0.01; ///< of the picture's width
constexpr std::uint16_t kRed = 1;
constexpr std::uint16_t kBlue = 2;
const Vec3 kRedPlace{-0.2, 0.0, 0.0};
const Vec3 kBluePlace{0.2, 0.0, 0.0};

ScenePart ball(std::uint16_t id, MaterialGroup group, const Vec3& centre, const char* liftedWith)
{
    ScenePart part = spherePart(id, group, centre, kRadius);
    part.liftedWith = liftedWith;
    if (id == kBlue)
        part.color = QColor(20, 20, 220);
    return part;
}

/// A red ball of one group and a blue one of another, in one surface.
std::vector<ScenePart> balls(MaterialGroup group)
{
    return {ball(kRed, group, kRedPlace, "red"), ball(kBlue, group, kBluePlace, "blue")};
}

std::unique_ptr<SceneView> viewOf(const std::vector<ScenePart>& parts,
                                  const std::shared_ptr<SceneFrame>& frame)
{
    return shownView(parts, [frame](int, LocalTime) { return *frame; });
}

std::shared_ptr<SceneFrame> newFrame() { return std::make_shared<SceneFrame>(frontFrame()); }

/// Where a point in the plane of the origin is seen, as a share of the picture.
QPointF seenAt(double x, double z)
{
    const double focal = 0.5 * kHeight / std::tan(0.5 * OrbitCamera::kVerticalFieldOfView);
    return {0.5 + focal * x / kDistance / kWidth, 0.5 - focal * z / kDistance / kHeight};
}

bool isDisc(std::size_t pixels, double radius = kRadius)
{
    return std::abs(double(pixels) / discPixels(radius, kDistance) - 1.0) < kPixelShare;
}

bool isRedAt(SceneView& view, double x, double z)
{
    const auto centre = redCentre(view.picture());
    const QPointF expected = seenAt(x, z);
    return centre && std::abs(centre->x() - expected.x()) < kPlaceTolerance
           && std::abs(centre->y() - expected.y()) < kPlaceTolerance;
}

} // namespace

/// Groups of parts that are lifted out, and are drawn elsewhere than the rest of their surface.
class TestLiftedParts : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init()
    {
        if (!graphicsDriver())
            QSKIP("no OpenGL 3.3");
    }

    void areDrawnByTheirMotionAndTheRestInItsPlace_data()
    {
        QTest::addColumn<MaterialGroup>("group");
        QTest::newRow("opaque") << MaterialGroup::Bone;
        QTest::newRow("seen from both sides") << MaterialGroup::Tool;
        QTest::newRow("blended") << MaterialGroup::Lung;
        QTest::newRow("seen into") << MaterialGroup::Airway;
    }

    void areDrawnByTheirMotionAndTheRestInItsPlace()
    {
        QFETCH(MaterialGroup, group);
        const auto frame = newFrame();
        const auto view = viewOf(balls(group), frame);
        QVERIFY(draws(*view, 3));
        QVERIFY(isRedAt(*view, -0.2, 0.0));
        for (const double z : {0.2, -0.3}) {
            frame->lifted["red"] = RigidTransform::translation({0.1, 0.0, z});
            QVERIFY(draws(*view, 3));
            QVERIFY(isRedAt(*view, -0.1, z));
            const auto pixels = view->visiblePixels();
            QVERIFY(isDisc(pixels.at(kRed)) && isDisc(pixels.at(kBlue)));
        }
        frame->lifted.clear();
        QVERIFY(draws(*view, 3));
        QVERIFY(isRedAt(*view, -0.2, 0.0));
        const auto pixels = view->visiblePixels();
        QVERIFY(isDisc(pixels.at(kRed)) && isDisc(pixels.at(kBlue)));
    }

    /// A half turn about y takes x to -x and z to -z.
    void areTurnedAndScaled()
    {
        const auto frame = newFrame();
        const auto view = viewOf(balls(MaterialGroup::Bone), frame);
        const Quat half{Eigen::AngleAxisd{std::numbers::pi, Vec3::UnitY()}};
        frame->lifted["red"] = {RigidTransform{half, Vec3{0.0, 0.0, 0.3}}, 0.5};
        QVERIFY(draws(*view, 3));
        QVERIFY(isRedAt(*view, 0.1, 0.3));
        QVERIFY(isDisc(view->visiblePixels().at(kRed), 0.5 * kRadius));
    }

    void severalAreLiftedAtOnce()
    {
        const auto frame = newFrame();
        const auto view = viewOf(balls(MaterialGroup::Lung), frame);
        frame->lifted["red"] = RigidTransform::translation({0.4, 0.0, 0.3});
        frame->lifted["blue"] = RigidTransform::translation({-0.4, 0.0, 0.0});
        frame->lifted["neither"] = RigidTransform::translation({0.0, 0.0, 9.0});
        QVERIFY(draws(*view, 3));
        QVERIFY(isRedAt(*view, 0.2, 0.3));
        const auto pixels = view->visiblePixels();
        QVERIFY(isDisc(pixels.at(kRed)) && isDisc(pixels.at(kBlue)));
    }

    /// Growing by a half about x = 0.4 takes the centre from -0.2 to -0.5, and only then is it
    /// lifted.
    void breatheInTheirPlace()
    {
        ScenePart lung = ball(kRed, MaterialGroup::Lung, kRedPlace, "red");
        lung.region = ChestRegion::LeftLowerLung;
        const auto frame = newFrame();
        frame->chest.field = wideChest();
        frame->chest.motion[std::size_t(ChestRegion::LeftLowerLung)] = scaledBy(1.5);
        frame->lifted["red"] = RigidTransform::translation({0.3, 0.0, 0.25});
        const auto view = viewOf({lung}, frame);
        QVERIFY(draws(*view, 3));
        QVERIFY(isRedAt(*view, -0.2, 0.25));
        QVERIFY(isDisc(view->visiblePixels().at(kRed), 1.5 * kRadius));
    }

    void areLiftedFromWhereTheirBodyIs()
    {
        ScenePart part = ball(kRed, MaterialGroup::Bone, Vec3::Zero(), "red");
        part.body = "jaw";
        const auto frame = newFrame();
        const auto view = viewOf({part, ball(kBlue, MaterialGroup::Bone, kBluePlace, "")}, frame);
        frame->lifted["red"] = {RigidTransform::translation({0.0, 0.0, 0.1}), 2.0};
        QVERIFY(draws(*view, 3));
        QCOMPARE(view->visiblePixels().at(kRed), std::size_t{0}); // a lost body is not drawn
        frame->bodies["jaw"] = RigidTransform::translation({-0.1, 0.0, 0.0});
        QVERIFY(draws(*view, 3));
        QVERIFY(isRedAt(*view, -0.2, 0.1));
        QVERIFY(isDisc(view->visiblePixels().at(kRed), 2.0 * kRadius));
    }

    /// Where names are written beside them.
    void haveTheirPointsWhereTheyAreDrawn()
    {
        const ScenePart part = ball(kRed, MaterialGroup::Bone, kRedPlace, "red");
        SceneFrame frame;
        QCOMPARE(*drawnAt(part, kRedPlace, frame), kRedPlace);
        frame.lifted["red"] = {RigidTransform::translation({0.1, 0.0, 0.2}), 2.0};
        QVERIFY((*drawnAt(part, kRedPlace, frame) - Vec3(-0.3, 0.0, 0.2)).norm() < 1e-12);
    }
};

CARINA_SCREEN_TEST(TestLiftedParts)

} // namespace carina::lifted_parts_test

#include "tst_lifted_parts.moc"
