// Programs run for hours: what a frame takes from the heap it must give back. The heap in use is
// the least of some frames, so that what lives for a few frames only is not taken for growth; and
// growth is the median of three stretches, so that a buffer which a driver makes once is not.

#include "tests/support/heap_in_use.h"
#include "tests/support/test_class.h"
#include "tests/widgets/scene/plate.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/scene_renderer.h"
#include "widgets/scene/view/scene_window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

namespace carina::heap_growth_test
{

using namespace carina::test;

namespace
{

constexpr int kWarmUp = 200;               ///< frames until shaders and caches are there
constexpr int kPeriod = 100;               ///< frames after which all motion repeats
constexpr int kStretch = 500;              ///< frames, over which growth is measured
constexpr std::int64_t kMostGrowth = 1000; ///< bytes in 1000 frames

const QSize kSmallWindow{96, 64};

/// What changes with each frame, beside the pose of the patient and of the tool.
enum class Shown : std::uint8_t {
    Patient,
    Headset,
    Section,
    ErrorMap,
    MovingJaw,
    ChangingAirway,
    MovingHead,
    Smoothed,
    Fine
};

/// Of every draw layer and shader program. Plates, which cost little to draw: what a frame takes
/// from the heap does not depend on the number of triangles.
std::vector<ScenePart> onePartOfEachKind()
{
    std::vector parts{
        platePart(1, MaterialGroup::Bone),         platePart(2, MaterialGroup::SoftTissue),
        platePart(3, MaterialGroup::Tool, "tube"), platePart(4, MaterialGroup::Airway),
        platePart(5, MaterialGroup::Lung),         platePart(6, MaterialGroup::Veil),
        platePart(7, MaterialGroup::Skin)};
    parts[1].region = ChestRegion::Throat;
    parts[3].region = ChestRegion::Pharynx;
    parts[4].region = ChestRegion::RightLowerLung;
    parts[5].region = ChestRegion::Wall;
    return parts;
}

/// -1 to 1, the same after kPeriod frames.
double swing(int frame) { return std::sin(2.0 * std::numbers::pi * frame / kPeriod); }

AirwayField airwayAt(int frame)
{
    AirwayField airway;
    airway.swell({.across = metres(0.2),
                  .along = metres(0.1),
                  .outward = metres(0.02 + 0.01 * swing(frame))});
    airway.tint({.across = metres(0.2),
                 .along = metres(0.1),
                 .color = {200, 30, 30},
                 .share = 0.5 + 0.4 * swing(frame)});
    return airway;
}

/// Bent in every frame.
NeckField neckAt(int frame)
{
    return {{0.0, 0.0, 0.1}, {0.0, -0.2, 0.25}, {degrees(15.0 + 10.0 * swing(frame)), {}}};
}

SceneFrame frameAt(int frame, Shown shown)
{
    SceneFrame made;
    made.chest.field = wideChest();
    for (ChestMotion& motion : made.chest.motion)
        motion = scaledBy(1.0 + 0.1 * swing(frame));
    made.throat.field = {{0.0, 0.03, -0.2}, {0.0, 0.0, -0.06}, {0.0, -0.07, 0.0}};
    if (shown == Shown::MovingJaw)
        made.throat.X_AJ = RigidTransform::translation({0.0, 0.0, -0.01 - 0.01 * swing(frame)});
    made.bodies["tube"] = RigidTransform::translation({0.1 * swing(frame), 0.0, 0.0});
    if (shown == Shown::ChangingAirway)
        made.airway = airwayAt(frame);
    if (shown == Shown::MovingHead) {
        made.throat.neck = neckAt(frame);
        made.bentInPlace["tube"] = RigidTransform{};
    }
    return made;
}

/// Moving, so that what is blended is sorted anew.
SceneCamera cameraAt(int frame, const PixelRect& pixels)
{
    const Vec3 eye{0.5 * swing(frame), -kDistance, 0.0};
    return {{.p_A_eye = eye, .p_A_target = Vec3::Zero()}, frontEye().frustum, pixels};
}

std::vector<SceneCamera> camerasAt(int frame, Shown shown)
{
    const int width = kSmallWindow.width();
    const int height = kSmallWindow.height();
    if (shown != Shown::Headset)
        return {cameraAt(frame, {0, 0, width, height})};
    return {cameraAt(frame, {0, 0, width / 2, height}),
            cameraAt(frame + 1, {width / 2, 0, width / 2, height})};
}

void drawFrame(SceneRenderer& renderer, int frame, Shown shown, std::size_t parts)
{
    if (shown == Shown::Section)
        renderer.setSection(Section{Vec3::UnitY(), 0.1 * swing(frame)});
    if (shown == Shown::ErrorMap)
        renderer.setErrorMap(
            ErrorMap{growingAlongX(0.1 * swing(frame), 5e-3), ErrorBands{.count = 5}});
    if (shown == Shown::Smoothed)
        renderer.setQuality(PictureQuality::Smoothed);
    if (shown == Shown::Fine)
        renderer.setQuality(PictureQuality::Fine);
    renderer.setCameras(camerasAt(frame, shown));
    renderer.apply(frameAt(frame, shown), std::vector<int>(parts, 0));
    renderer.draw();
    QCoreApplication::processEvents();
}

/// The least heap in use after each of kPeriod frames.
std::int64_t leastHeap(const std::function<void()>& drawNext)
{
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (int frame = 0; frame < kPeriod; ++frame) {
        drawNext();
        least = std::min(least, heapInUse());
    }
    return least;
}

/// Bytes by which the heap in use grows in 1000 frames.
std::int64_t growth(const std::function<void()>& drawNext)
{
    for (int frame = 0; frame < kWarmUp; ++frame)
        drawNext();
    std::array<std::int64_t, 3> grown{};
    std::int64_t before = leastHeap(drawNext);
    for (std::int64_t& each : grown) {
        for (int frame = kPeriod; frame < kStretch; ++frame)
            drawNext();
        const std::int64_t after = leastHeap(drawNext);
        each = (after - before) * 1000 / kStretch;
        before = after;
    }
    std::ranges::sort(grown);
    return grown[1];
}

} // namespace

class TestHeapGrowth : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void init();
    void countsWhatIsTakenAndGivenBack();
    void aFrameGivesBackWhatItTook_data();
    void aFrameGivesBackWhatItTook();
    void aViewWithNamesGivesBackWhatItTook();
};

void TestHeapGrowth::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
}

void TestHeapGrowth::countsWhatIsTakenAndGivenBack()
{
    constexpr std::int64_t kTaken = 1'000'000;
    constexpr std::int64_t kOverhead = 100'000; // of blocks, and of what else runs meanwhile
    const std::int64_t before = heapInUse();
    {
        const std::vector<char> block(kTaken);
        const std::int64_t after = heapInUse() - before;
        QVERIFY(after >= kTaken && after < kTaken + kOverhead);
    }
    QVERIFY(std::abs(heapInUse() - before) < kOverhead);
}

void TestHeapGrowth::aFrameGivesBackWhatItTook_data()
{
    QTest::addColumn<Shown>("shown");
    QTest::newRow("a breathing patient and a moving tool") << Shown::Patient;
    QTest::newRow("in both eyes of a headset") << Shown::Headset;
    QTest::newRow("behind a moving section") << Shown::Section;
    QTest::newRow("coloured by a changing error") << Shown::ErrorMap;
    QTest::newRow("with a moving jaw") << Shown::MovingJaw;
    QTest::newRow("with tissue that swells and changes colour") << Shown::ChangingAirway;
    QTest::newRow("with a moving head and a tube in place") << Shown::MovingHead;
    QTest::newRow("with smoothed edges") << Shown::Smoothed;
    QTest::newRow("with several samples per pixel") << Shown::Fine;
}

void TestHeapGrowth::aFrameGivesBackWhatItTook()
{
    QFETCH(Shown, shown);
    SceneWindow window;
    window.resize(kSmallWindow);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    SceneRenderer renderer{&window};
    const std::vector<ScenePart> parts = onePartOfEachKind();
    renderer.setParts(parts);
    int frame = 0;
    const std::int64_t grown = growth([&] { drawFrame(renderer, frame++, shown, parts.size()); });
    QVERIFY2(grown < kMostGrowth, qPrintable(QStringLiteral("%1 bytes in 1000 frames").arg(grown)));
}

/// All of a view: names of parts and sides, statistics, the choice of detail.
void TestHeapGrowth::aViewWithNamesGivesBackWhatItTook()
{
    int frame = 0;
    std::vector<ScenePart> parts = onePartOfEachKind();
    PartLooks looks;
    for (ScenePart& part : parts) {
        part.name = "Part " + std::to_string(part.id);
        looks[part.id] = {.labelled = true};
    }
    const auto view =
        shownView(parts, [&](int, LocalTime) { return frameAt(frame++, Shown::MovingJaw); });
    view->setLooks(looks);
    view->nameSides();
    view->resize(kSmallWindow);
    const std::int64_t grown = growth([&] { QVERIFY(draws(*view, 1)); });
    QVERIFY2(grown < kMostGrowth, qPrintable(QStringLiteral("%1 bytes in 1000 frames").arg(grown)));
}

CARINA_SCREEN_TEST(TestHeapGrowth)

} // namespace carina::heap_growth_test

#include "tst_heap_growth.moc"
