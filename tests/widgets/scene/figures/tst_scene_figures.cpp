#include "tests/support/test_class.h"
#include "tests/widgets/scene/scene_fixture.h"

#include <QLabel>

namespace carina::scene_figures_test
{
namespace
{

using namespace carina::test;

constexpr double kRadius = 0.05;     ///< metres
constexpr double kPixelShare = 0.05; ///< of a disc, by rounding at its rim
constexpr std::uint16_t kPartId = 1;

SceneFigure ball(std::uint16_t id, const char* body, const char* name = "")
{
    SceneFigure figure{.body = body, .name = QString::fromUtf8(name)};
    figure.parts.push_back(spherePart(id, MaterialGroup::Tool, Vec3::Zero(), kRadius, body));
    return figure;
}

/// What the view draws, by name of body.
using Bodies = std::map<std::string, PlacedBody>;

/// A view with one part of its own, aside of the middle for an eye in front.
std::unique_ptr<SceneView> viewOf(const std::shared_ptr<Bodies>& bodies, bool inHeadset = true)
{
    const double aside = inHeadset ? 0.4 : 0.0;
    return shownView({spherePart(kPartId, MaterialGroup::Bone, {aside, 0.0, 0.0}, kRadius)},
                     [bodies, inHeadset](int, LocalTime) {
                         SceneFrame frame = inHeadset ? frontFrame() : SceneFrame{};
                         frame.bodies = *bodies;
                         return frame;
                     });
}

RigidTransform at(double x, double z) { return RigidTransform::translation({x, 0.0, z}); }

bool isDisc(std::size_t pixels)
{
    return std::abs(double(pixels) / discPixels(kRadius, kDistance) - 1.0) < kPixelShare;
}

} // namespace

class TestSceneFigures : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Two of the same shape, each where its body is; a body that is not listed is not drawn.
    void drawsEachWhereItsBodyIs()
    {
        const auto bodies = std::make_shared<Bodies>();
        const auto view = viewOf(bodies);
        const std::array figures{ball(7, "a"), ball(8, "b")};
        view->setFigures(figures);
        QVERIFY(draws(*view, 2));
        auto pixels = view->visiblePixels();
        QVERIFY(isDisc(pixels.at(kPartId)));
        QCOMPARE(pixels.at(7), std::size_t{0});
        QCOMPARE(pixels.at(8), std::size_t{0});
        *bodies = {{"a", at(0.0, 0.1)}, {"b", at(0.0, -0.1)}};
        QVERIFY(draws(*view, 2));
        pixels = view->visiblePixels();
        QVERIFY(isDisc(pixels.at(7)));
        QVERIFY(isDisc(pixels.at(8)));
        bodies->erase("a");
        QVERIFY(draws(*view, 2));
        pixels = view->visiblePixels();
        QCOMPARE(pixels.at(7), std::size_t{0});
        QVERIFY(isDisc(pixels.at(8)));
    }

    void comesAndGoesWithoutThePartsOfTheScene()
    {
        const auto bodies = std::make_shared<Bodies>();
        *bodies = {{"a", at(0.0, 0.0)}};
        const auto view = viewOf(bodies);
        view->setFigures(std::array{ball(7, "a")});
        QVERIFY(draws(*view, 2));
        QVERIFY(isDisc(view->visiblePixels().at(7)));
        view->setFigures({});
        QVERIFY(draws(*view, 2));
        const auto pixels = view->visiblePixels();
        QVERIFY(!pixels.contains(7));
        QVERIFY(isDisc(pixels.at(kPartId)));
        QCOMPARE(view->parts().size(), std::size_t{1});
    }

    /// Beside their figures, and beside each other where these are close together.
    void writesNamesThatCoverNoOther()
    {
        const auto bodies = std::make_shared<Bodies>();
        *bodies = {{"a", at(-0.01, 0.0)}, {"b", at(0.01, 0.0)}, {"c", at(0.0, 0.01)}};
        const auto view = viewOf(bodies, false);
        view->setFigures(
            std::array{ball(7, "a", "Tom"), ball(8, "b", "Tess"), ball(9, "c", "Tim")});
        QVERIFY(draws(*view, 2));
        const auto& names = view->placedFigureNames();
        QCOMPARE(names.size(), std::size_t{3});
        for (std::size_t i = 0; i < names.size(); ++i) {
            QVERIFY(view->rect().contains(names[i].box));
            for (std::size_t j = 0; j < i; ++j)
                QVERIFY(!names[i].box.intersects(names[j].box));
        }
        bodies->erase("b");
        QVERIFY(draws(*view, 2));
        QCOMPARE(view->placedFigureNames().size(), std::size_t{2});
        QStringList written;
        for (const QLabel* label : view->findChildren<QLabel*>())
            if (label->isVisible())
                written += label->text();
        written.sort();
        QCOMPARE(written, (QStringList{QStringLiteral("Tim"), QStringLiteral("Tom")}));
    }

    /// In the middle of each eye's half: both look straight at it.
    void writesANameOnceForEachEye()
    {
        const auto bodies = std::make_shared<Bodies>();
        *bodies = {{"a", at(0.0, 0.0)}};
        const auto view =
            shownView({spherePart(kPartId, MaterialGroup::Bone, {0.4, 0.0, 0.0}, kRadius)},
                      [bodies](int, LocalTime) {
                          SceneFrame frame;
                          EyePicture left = frontEye();
                          EyePicture right = frontEye();
                          left.part = {.x = 0.0, .y = 0.0, .width = 0.5, .height = 1.0};
                          right.part = {.x = 0.5, .y = 0.0, .width = 0.5, .height = 1.0};
                          frame.eyes = {left, right};
                          frame.bodies = *bodies;
                          return frame;
                      });
        view->setFigures(std::array{ball(7, "a", "Tom")});
        QVERIFY(draws(*view, 2));
        const auto& names = view->placedFigureNames();
        QCOMPARE(names.size(), std::size_t{2});
        constexpr double kPixel = 1.5;
        for (std::size_t eye = 0; eye < 2; ++eye) {
            const QPointF middle{(0.25 + 0.5 * double(eye)) * kWidth, 0.5 * kHeight};
            QVERIFY(QLineF(names[eye].anchor, middle).length() < kPixel);
        }
        QCOMPARE(names[1].box.topLeft() - names[0].box.topLeft(), QPoint(kWidth / 2, 0));
    }
};

CARINA_SCREEN_TEST(TestSceneFigures)

} // namespace carina::scene_figures_test

#include "tst_scene_figures.moc"
