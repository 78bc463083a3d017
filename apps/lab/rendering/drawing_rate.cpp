#include "apps/lab/rendering/drawing_rate.h"

#include "widgets/scene/view/graphics.h"

#include <QEventLoop>
#include <QTimer>

namespace carina::lab
{
namespace
{

constexpr int kUntimedFrames = 20; ///< until shaders, buffers and levels of detail are there
constexpr int kTimedFrames = 200;
constexpr int kLongestFrame_ms = 60'000;

} // namespace

Result<double> drawingRate(const TimedScene& scene)
{
    if (const auto driver = graphicsDriver(); !driver)
        return tl::unexpected(driver.error());
    SceneView view;
    scene.prepare(view);
    view.setWindowTitle(QStringLiteral("carina-lab render"));
    view.resize(scene.size);
    view.drawEvery(std::chrono::milliseconds{0});
    view.setFrameSource([&scene](int, LocalTime) { return scene.frame(); });
    Result<double> rate = fail(Errc::NoGraphics, "render got no frame from the view");
    int drawn = 0;
    LocalTime began{};
    QEventLoop loop;
    QTimer patience;
    QObject::connect(&patience, &QTimer::timeout, &loop, [&loop] { loop.quit(); });
    view.onFrameDrawn([&](const DrawnFrame& frame) {
        patience.start(kLongestFrame_ms);
        ++drawn;
        if (drawn == kUntimedFrames)
            began = frame.swapped;
        if (drawn != kUntimedFrames + kTimedFrames)
            return;
        rate = kTimedFrames / toSeconds(frame.swapped - began);
        loop.quit();
    });
    patience.start(kLongestFrame_ms);
    view.show();
    loop.exec();
    return rate;
}

} // namespace carina::lab
