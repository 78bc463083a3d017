#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

#include <cmath>

namespace carina::airway_tint_test
{

using namespace carina::test;

namespace
{

constexpr int kSwitchFrames = 8; ///< after which another shader program is in use
constexpr int kTolerance = 2;    ///< of 255
constexpr Rgb kTint{30, 60, 200};
constexpr QColor kOwn{220, 20, 20}; ///< of spherePart

/// In the middle of the picture.
QColor drawn(const QColor& color, ChestRegion region, const AirwayField& airway, bool isSpotlit)
{
    ScenePart part = spherePart(1, MaterialGroup::SoftTissue, Vec3::Zero(), 0.3);
    part.color = color;
    part.region = region;
    const auto view = shownView({part}, [&airway](int, LocalTime) {
        SceneFrame frame = frontFrame();
        frame.airway = airway;
        return frame;
    });
    if (isSpotlit)
        view->setSpotlight(metres(1.0));
    if (!draws(*view, kSwitchFrames))
        return {};
    return view->picture().pixelColor(kWidth / 2, kHeight / 2);
}

AirwayField tinted(double share)
{
    AirwayField field;
    field.tint({.across = metres(2.0),
                .along = metres(2.0),
                .color = kTint,
                .share = share,
                .tissues = only(AirwayTissue::Larynx)});
    return field;
}

bool areAlike(const QColor& a, const QColor& b)
{
    return a.isValid() && b.isValid() && std::abs(a.red() - b.red()) <= kTolerance
           && std::abs(a.green() - b.green()) <= kTolerance
           && std::abs(a.blue() - b.blue()) <= kTolerance;
}

/// Of light that is mixed: colours are coded as its square root.
int mixed(int own, int tint, double share)
{
    return int(std::lround(std::sqrt((1.0 - share) * own * own + share * tint * tint)));
}

} // namespace

/// Tissue that events colour is drawn as tissue that has this colour.
class TestAirwayTint : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void drawsTissueInTheColourOfATint_data();
    void drawsTissueInTheColourOfATint();
    void leavesOtherTissue();
};

void TestAirwayTint::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestAirwayTint::drawsTissueInTheColourOfATint_data()
{
    QTest::addColumn<double>("share");
    QTest::addColumn<bool>("isSpotlit");
    QTest::newRow("whole, by daylight") << 1.0 << false;
    QTest::newRow("half, by daylight") << 0.5 << false;
    QTest::newRow("whole, by a lamp") << 1.0 << true;
    QTest::newRow("half, by a lamp") << 0.5 << true;
}

void TestAirwayTint::drawsTissueInTheColourOfATint()
{
    QFETCH(double, share);
    QFETCH(bool, isSpotlit);
    const QColor same{mixed(kOwn.red(), kTint[0], share), mixed(kOwn.green(), kTint[1], share),
                      mixed(kOwn.blue(), kTint[2], share)};
    const QColor byTint = drawn(kOwn, ChestRegion::Larynx, tinted(share), isSpotlit);
    QVERIFY(areAlike(byTint, drawn(same, ChestRegion::Larynx, {}, isSpotlit)));
    QVERIFY(!areAlike(byTint, drawn(kOwn, ChestRegion::Larynx, {}, isSpotlit)));
}

void TestAirwayTint::leavesOtherTissue()
{
    for (const ChestRegion region : {ChestRegion::Throat, ChestRegion::Still})
        QVERIFY(areAlike(drawn(kOwn, region, tinted(1.0), false), drawn(kOwn, region, {}, false)));
}

CARINA_SCREEN_TEST(TestAirwayTint)

} // namespace carina::airway_tint_test

#include "tst_airway_tint.moc"
