#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

#include <QLabel>

namespace carina::part_labels_test
{

using namespace carina::test;

namespace
{

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
    void writesNamesBesideLabelledParts();
    void writesNoNameOverAnother();
    void leadsToWhatItNames();
    void namesNothingThatIsCutAwayOrHidden();
    void namesNothingThatIsBehindAnother();
    void followsItsBody();
    void writesNothingForAHeadset();
};

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
    const auto view =
        shownView({named(1, "First", {0.0, 0.0, 0.03}), named(2, "Second", {0.01, 0.0, 0.0}),
                   named(3, "Third", {0.0, 0.0, -0.03})},
                  {});
    view->setLooks({{1, {.labelled = true}}, {2, {.labelled = true}}, {3, {.labelled = true}}});
    QVERIFY(draws(*view, 3));
    const QRect first = labelOf(*view, "First")->geometry();
    const QRect second = labelOf(*view, "Second")->geometry();
    const QRect third = labelOf(*view, "Third")->geometry();
    QVERIFY(!first.intersects(second) && !second.intersects(third) && !third.intersects(first));
    QCOMPARE(view->placedNames().size(), std::size_t{3});
}

/// The leader ends in the disc that the ball covers in the picture.
void TestPartLabels::leadsToWhatItNames()
{
    const auto view =
        shownView({named(1, "Left", {-0.1, 0.0, 0.0}), named(2, "Right", {0.1, 0.0, 0.0})}, {});
    view->setLooks({{1, {.labelled = true}}, {2, {.labelled = true}}});
    QVERIFY(draws(*view, 3));
    QCOMPARE(view->placedNames().size(), std::size_t{2});
    for (const PlacedName& name : view->placedNames()) {
        const double side = name.wish == 0 ? -1.0 : 1.0;
        QVERIFY(side * (name.anchor.x() - 0.5 * view->width()) > 0.0);
        const QColor under =
            view->picture().pixelColor(name.anchor.toPoint() * view->devicePixelRatio());
        QVERIFY(under.red() > 60);
        QVERIFY(!QRectF{name.box}.contains(name.anchor));
        QCOMPARE(labelOf(*view, name.wish == 0 ? "Left" : "Right")->geometry(), name.box);
    }
}

void TestPartLabels::namesNothingThatIsCutAwayOrHidden()
{
    const auto view =
        shownView({named(1, "Left", {-0.1, 0.0, 0.0}), named(2, "Right", {0.1, 0.0, 0.0})}, {});
    const PartLooks both{{1, {.labelled = true}}, {2, {.labelled = true}}};
    view->setLooks(both);
    view->setSection(Section{Vec3::UnitX(), 0.0, Cut::All});
    QVERIFY(draws(*view, 3));
    QVERIFY(labelOf(*view, "Left")->isVisible());
    QVERIFY(!labelOf(*view, "Right")->isVisible());
    view->setSection({});
    QVERIFY(draws(*view, 3));
    QVERIFY(labelOf(*view, "Right")->isVisible());
    PartLooks hidden = both;
    hidden[2].style = PartStyle::Hidden;
    view->setLooks(hidden);
    QVERIFY(draws(*view, 3));
    QVERIFY(labelOf(*view, "Left")->isVisible());
    QVERIFY(labelOf(*view, "Right") == nullptr);
}

void TestPartLabels::namesNothingThatIsBehindAnother()
{
    SceneFrame frame;
    ScenePart cover = named(2, "Cover", {0.0, -0.2, 0.0});
    cover.body = "cover";
    const auto view = shownView({named(1, "Behind", {0.0, 0.2, 0.0}), cover},
                                [&](int, LocalTime) { return frame; });
    view->setLooks({{1, {.labelled = true}}});
    view->showFrom(ViewPreset::Front);
    QVERIFY(draws(*view, PartLabels::kFramesAPlace + 1));
    QVERIFY(labelOf(*view, "Behind")->isVisible());
    frame.bodies["cover"] = PlacedBody{RigidTransform{}, 1.2};
    QVERIFY(draws(*view, PartLabels::kFramesAPlace + 1));
    QVERIFY(!labelOf(*view, "Behind")->isVisible());
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
    QVERIFY(draws(*view, PartLabels::kFramesAPlace));
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
