#include "apps/lab/rendering/picture_series.h"

#include "widgets/scene/view/graphics.h"

#include <QEventLoop>
#include <QTimer>

#include <algorithm>
#include <string>

namespace carina::lab
{
namespace
{

constexpr std::size_t kWarmUp = 5;      ///< frames until shaders and buffers are there
constexpr int kLongestWait_ms = 60'000; ///< for one picture

std::string tooSlowly()
{
    return "render waited " + std::to_string(kLongestWait_ms / 1000)
           + " s for a picture: run it again while less else runs, with smaller pictures (--size), "
             "or on a computer that draws OpenGL 3.3 faster";
}

} // namespace

Result<void> drawSeries(const PictureSeries& series)
{
    if (const auto driver = graphicsDriver(); !driver)
        return fail(Errc::NoGraphics, "render needs OpenGL 3.3, which is not available ("
                                          + driver.error().detail
                                          + "). Run it as ./carina lab render ...");
    SceneView view;
    view.setFixedQuality(PictureQuality::Quick);
    series.prepare(view);
    view.setWindowTitle(QStringLiteral("carina-lab render"));
    view.resize(series.size);
    std::size_t next = 0;
    std::size_t drawn = 0;
    Result<void> result = fail(Errc::NoGraphics, tooSlowly());
    view.setFrameSource(
        [&](int, LocalTime) { return series.frame(view, std::min(next, series.count - 1)); });
    QEventLoop loop;
    QTimer patience;
    QObject::connect(&patience, &QTimer::timeout, &loop, [&loop] { loop.quit(); });
    view.onFrameDrawn([&](const DrawnFrame&) {
        patience.start(kLongestWait_ms);
        if (++drawn <= kWarmUp || view.isPreparing() || next == series.count)
            return;
        if (const QImage picture = view.picture(); picture.isNull()) {
            result = fail(Errc::NoGraphics, "render got no picture back from the view");
            next = series.count;
        } else if (const auto taken = series.take(view, next, picture);
                   !taken || ++next == series.count) {
            result = taken;
            next = series.count;
        }
        if (next == series.count)
            loop.quit();
    });
    patience.start(kLongestWait_ms);
    view.show();
    loop.exec();
    return result;
}

} // namespace carina::lab
