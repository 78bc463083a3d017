#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

#include <QLabel>

namespace carina::part_labels_test
{

using namespace carina::test;

namespace
{

constexpr double kSmall = 1e-9;

/// At the origin of A, looking along +y with the head up.
CameraPose lookingBack()
{
    CameraPose pose;
    pose.p_A_target = Vec3::UnitY();
    return pose;
}

constexpr Frustum kWide{-2.0, 2.0, -1.0, 1.0};

ScenePart named(std::uint16_t id, const char* name, const Vec3& centre)
{
    ScenePart part = spherePart(id, MaterialGroup::Bone, centre, 0.05);
    part.name = name;
    return part;
}

QLabel* labelOf(const SceneView& view, const char* name)
{
    for (QLabel* label : view.findChildren<QLabel*>())
        if (label->text() == QLatin1String{name})
            return label;
    return nullptr;
}

} // namespace

class TestPartLabels : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void findsWhereACameraSeesAPoint_data();
    void findsWhereACameraSeesAPoint();
    void writesNamesBesideLabelledParts();
    void writesNoNameOverAnother();
    void followsItsBody();
    void writesNothingForAHeadset();
};

void TestPartLabels::findsWhereACameraSeesAPoint_data()
{
    QTest::addColumn<QVector3D>("place");
    QTest::addColumn<QPointF>("seen");
    QTest::newRow("straight ahead") << QVector3D{0, 3, 0} << QPointF{0.5, 0.5};
    QTest::newRow("upper right corner") << QVector3D{4, 2, 2} << QPointF{1.0, 0.0};
    QTest::newRow("a quarter to the left") << QVector3D{-3, 3, 0} << QPointF{0.25, 0.5};
    QTest::newRow("a quarter down") << QVector3D{0, 2, -1} << QPointF{0.5, 0.75};
}

void TestPartLabels::findsWhereACameraSeesAPoint()
{
    QFETCH(QVector3D, place);
    QFETCH(QPointF, seen);
    const auto found = seenAt({place.x(), place.y(), place.z()}, lookingBack(), kWide);
    QVERIFY(found);
    QVERIFY(std::abs(found->x() - seen.x()) < kSmall && std::abs(found->y() - seen.y()) < kSmall);
    for (const Vec3& outside : {Vec3{4.1, 2, 0}, Vec3{-4.1, 2, 0}, Vec3{0, 2, 2.1},
                                Vec3{0, 2, -2.1}, Vec3{0, -1, 0}, Vec3{0, 0, 0}})
        QVERIFY(!seenAt(outside, lookingBack(), kWide));
}

void TestPartLabels::writesNamesBesideLabelledParts()
{
    const auto view =
        shownView({named(1, "Left", {-0.1, 0.0, 0.0}), named(2, "Right", {0.1, 0.0, 0.0})}, {});
    view->setLooks({{2, {.labelled = true}}});
    QVERIFY(draws(*view, 3));
    QVERIFY(labelOf(*view, "Left") == nullptr);
    const QLabel* label = labelOf(*view, "Right");
    QVERIFY(label != nullptr && label->isVisible());
    QVERIFY(label->x() > view->width() / 2);
    QVERIFY(std::abs(label->y() - view->height() / 2) < view->height() / 4);
    view->setLooks({});
    QVERIFY(labelOf(*view, "Right") == nullptr);
}

void TestPartLabels::writesNoNameOverAnother()
{
    const auto view = shownView({named(1, "First", Vec3::Zero()), named(2, "Second", Vec3::Zero()),
                                 named(3, "Third", {0.0, 0.0, 0.001})},
                                {});
    view->setLooks({{1, {.labelled = true}}, {2, {.labelled = true}}, {3, {.labelled = true}}});
    QVERIFY(draws(*view, 3));
    const QRect first = labelOf(*view, "First")->geometry();
    const QRect second = labelOf(*view, "Second")->geometry();
    const QRect third = labelOf(*view, "Third")->geometry();
    QVERIFY(!first.intersects(second) && !second.intersects(third) && !third.intersects(first));
}

void TestPartLabels::followsItsBody()
{
    ScenePart part = named(1, "Tube", Vec3::Zero());
    part.body = "tube";
    SceneFrame frame;
    frame.bodies["tube"] = RigidTransform::translation({0.02, 0.0, 0.0});
    const auto view = shownView({part}, [&](int, LocalTime) { return frame; });
    view->setLooks({{1, {.labelled = true}}});
    QVERIFY(draws(*view, 3));
    const int before = labelOf(*view, "Tube")->x();
    frame.bodies["tube"] = RigidTransform::translation({-0.02, 0.0, 0.0});
    QVERIFY(draws(*view, 2));
    QVERIFY(labelOf(*view, "Tube")->x() < before);
    frame.bodies.clear();
    QVERIFY(draws(*view, 2));
    QVERIFY(!labelOf(*view, "Tube")->isVisible());
}

void TestPartLabels::writesNothingForAHeadset()
{
    SceneFrame frame;
    const auto view =
        shownView({named(1, "Only", Vec3::Zero())}, [&](int, LocalTime) { return frame; });
    view->setLooks({{1, {.labelled = true}}});
    QVERIFY(draws(*view, 2));
    QVERIFY(labelOf(*view, "Only")->isVisible());
    frame = frontFrame();
    QVERIFY(draws(*view, 2));
    QVERIFY(!labelOf(*view, "Only")->isVisible());
}

CARINA_SCREEN_TEST(TestPartLabels)

} // namespace carina::part_labels_test

#include "tst_part_labels.moc"
