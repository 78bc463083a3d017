#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"
#include "widgets/scene/view/graphics.h"

namespace carina::scene_eyes_test
{

using namespace carina::test;

namespace
{

constexpr double kPlaceTolerance_px = 0.5;
constexpr double kCountTolerance = 0.02; ///< of the analytic area
const WindowPart kLeftHalf{0.0, 0.0, 0.5, 1.0};
const WindowPart kRightHalf{0.5, 0.0, 0.5, 1.0};

/// Eyes 0.2 m apart that look straight ahead, each through a frustum 2 wide and 3 high, which
/// fills a half of the window: 160 pixels per unit of tangent.
std::vector<EyePicture> eyesSideBySide()
{
    std::vector<EyePicture> eyes{frontEye(-0.1), frontEye(0.1)};
    for (EyePicture& eye : eyes)
        eye.frustum = {-1.0, 1.0, -1.5, 1.5};
    eyes[0].part = kLeftHalf;
    eyes[1].part = kRightHalf;
    return eyes;
}

SceneView::FrameSource alwaysSeenBy(std::vector<EyePicture> eyes)
{
    return [eyes = std::move(eyes)](int, LocalTime) {
        SceneFrame frame;
        frame.eyes = eyes;
        return frame;
    };
}

/// Middle of the red pixels of a part of a picture, in pixels of the picture.
std::optional<QPointF> redCentreIn(const QImage& picture, const QRect& part)
{
    const auto share = redCentre(picture.copy(part));
    if (!share)
        return std::nullopt;
    return QPointF(part.topLeft()) + QPointF(share->x() * part.width(), share->y() * part.height());
}

bool isAt(const std::optional<QPointF>& found, const QPointF& expected)
{
    if (found)
        qInfo("found %.2f %.2f, expected %.2f %.2f", found->x(), found->y(), expected.x(),
              expected.y());
    return found && std::abs(found->x() - expected.x()) < kPlaceTolerance_px
           && std::abs(found->y() - expected.y()) < kPlaceTolerance_px;
}

int redPixels(const QImage& picture)
{
    int count = 0;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            count += isRed(picture.pixel(x, y)) ? 1 : 0;
    return count;
}

const QRect kLeftPixels{0, 0, kWidth / 2, kHeight};
const QRect kRightPixels{kWidth / 2, 0, kWidth / 2, kHeight};

} // namespace

class TestSceneEyes : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void showsEachEyeItsOwnPictureInItsPart();
    void looksPastTheMiddleThroughAnOffAxisFrustum();
    void letterboxesAPictureOfAnotherShape();
    void countsThePixelsOfAllEyes();
    void leavesTheBackgroundWithoutAnEye();
    void changesItsEyesInTheVerySameFrame();
    void tellsTheSourceWhenTheFrameWillBeLit();
};

void TestSceneEyes::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

// A sphere 0.3 m to the right and 0.4 m up, 2 m away: 0.4 / 2 * 160 px right of the left eye's
// middle, 0.2 / 2 * 160 px of the right eye's, and 0.4 / 2 * 160 px above both.
void TestSceneEyes::showsEachEyeItsOwnPictureInItsPart()
{
    const auto view = shownView({spherePart(1, MaterialGroup::Bone, {0.3, 0.0, 0.4}, 0.03)},
                                alwaysSeenBy(eyesSideBySide()));
    QVERIFY(draws(*view, 3));
    const QImage picture = view->picture();
    QVERIFY(isAt(redCentreIn(picture, kLeftPixels), {160.0 + 32.0, 240.0 - 32.0}));
    QVERIFY(isAt(redCentreIn(picture, kRightPixels), {480.0 + 16.0, 240.0 - 32.0}));
}

// The sphere is straight ahead; the frustum spans -0.25 to 0.75 and -0.25 to 0.5, so straight ahead
// is a quarter of 640 px from the left and two thirds of 480 px from the top.
void TestSceneEyes::looksPastTheMiddleThroughAnOffAxisFrustum()
{
    EyePicture eye = frontEye();
    eye.frustum = {-0.25, 0.75, -0.25, 0.5};
    const auto view =
        shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.03)}, alwaysSeenBy({eye}));
    QVERIFY(draws(*view, 3));
    const QImage picture = view->picture();
    QVERIFY(isAt(redCentreIn(picture, picture.rect()), {160.0, 320.0}));
}

// A square picture in a window of 640 by 480 takes the middle 480 columns and leaves all others.
void TestSceneEyes::letterboxesAPictureOfAnotherShape()
{
    EyePicture eye = frontEye();
    eye.frustum = {-0.2, 0.2, -0.2, 0.2};
    const auto view =
        shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 1.0)}, alwaysSeenBy({eye}));
    QVERIFY(draws(*view, 3));
    const QImage picture = view->picture();
    QCOMPARE(redPixels(picture), 480 * 480);
    QVERIFY(isRed(picture.pixel(80, 0)) && isRed(picture.pixel(559, 479)));
    QVERIFY(!isRed(picture.pixel(79, 240)) && !isRed(picture.pixel(560, 240)));
    QCOMPARE(view->visiblePixels()[1], std::size_t{480 * 480});
}

void TestSceneEyes::countsThePixelsOfAllEyes()
{
    std::vector<EyePicture> eyes = eyesSideBySide();
    eyes[1].X_AD = eyes[0].X_AD;
    const auto view = shownView({spherePart(1, MaterialGroup::Bone, {-0.1, 0.0, 0.0}, 0.2),
                                 spherePart(2, MaterialGroup::Lung, {-0.1, 0.0, 0.0}, 0.4)},
                                alwaysSeenBy(eyes));
    // Straight ahead of both, a disc of the focal length times tan(asin(r / distance)).
    const auto disc = [](double radius) {
        const double squared = radius * radius / (kDistance * kDistance - radius * radius);
        return std::numbers::pi * 160.0 * 160.0 * squared;
    };
    QVERIFY(draws(*view, 3));
    const auto counted = view->visiblePixels();
    for (const auto& [id, radius] : {std::pair{1, 0.2}, std::pair{2, 0.4}}) {
        const double expected = 2.0 * disc(radius);
        const auto count = static_cast<double>(counted.at(static_cast<std::uint16_t>(id)));
        QVERIFY2(std::abs(count - expected) < kCountTolerance * expected,
                 qPrintable(QString::number(count)));
    }
}

void TestSceneEyes::leavesTheBackgroundWithoutAnEye()
{
    const auto view =
        shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.3)}, alwaysSeenBy({}));
    QVERIFY(draws(*view, 3));
    QImage black{kWidth, kHeight, QImage::Format_RGB32};
    black.fill(Qt::black);
    QCOMPARE(view->picture(), black);
    QCOMPARE(view->visiblePixels()[1], std::size_t{0});
}

void TestSceneEyes::changesItsEyesInTheVerySameFrame()
{
    constexpr std::size_t kWarmUp = 6; // frames until shaders and buffers are there
    constexpr std::size_t kFrames = 30;
    constexpr std::array<std::size_t, 6> kEyes{0, 2, 1, 2, 0, 1}; // every change there is
    std::size_t asked = 0;
    int wrong = 0;
    const auto view =
        shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.3)}, [&](int, LocalTime) {
            SceneFrame frame;
            std::vector<EyePicture> eyes = eyesSideBySide();
            eyes.resize(kEyes[asked++ % kEyes.size()]);
            frame.eyes = std::move(eyes);
            return frame;
        });
    view->onFrameDrawn([&](const DrawnFrame& drawn) {
        if (asked <= kWarmUp)
            return;
        const QImage picture = onScreen(*view);
        const bool left = redPixels(picture.copy(kLeftPixels)) > 0;
        const bool right = redPixels(picture.copy(kRightPixels)) > 0;
        const std::size_t eyes = drawn.frame.eyes->size();
        wrong += left == (eyes > 0) && right == (eyes > 1) ? 0 : 1;
    });
    QVERIFY(draws(*view, kWarmUp + kFrames));
    QCOMPARE(wrong, 0);
}

void TestSceneEyes::tellsTheSourceWhenTheFrameWillBeLit()
{
    std::vector<LocalTime> told;
    std::vector<DrawnFrame> log;
    const auto view =
        shownView({spherePart(1, MaterialGroup::Bone, Vec3::Zero(), 0.1)}, [&](int, LocalTime lit) {
            told.push_back(lit);
            return frontFrame();
        });
    view->onFrameDrawn([&](const DrawnFrame& drawn) { log.push_back(drawn); });
    QVERIFY(draws(*view, 6));
    QCOMPARE(told.size(), log.size());
    for (std::size_t i = 0; i < log.size(); ++i) {
        QVERIFY(log[i].lit == told[i]);
        QVERIFY(log[i].lit > log[i].asked);
        QVERIFY(i == 0 || log[i].lit >= log[i - 1].lit);
    }
}

CARINA_SCREEN_TEST(TestSceneEyes)

} // namespace carina::scene_eyes_test

#include "tst_scene_eyes.moc"
