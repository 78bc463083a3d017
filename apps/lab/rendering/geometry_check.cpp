#include "apps/lab/rendering/geometry_check.h"

#include "apps/lab/rendering/picture_series.h"
#include "apps/lab/rendering/seen_balls.h"
#include "tests/support/eye_projection.h"
#include "widgets/scene/labels/marker_shapes.h"

#include <cmath>

namespace carina::lab
{
namespace
{

constexpr int kWindowWidth = 1280;    // pixels
constexpr int kWindowHeight = 480;    // pixels
constexpr double kBallRadius = 0.004; // metres
constexpr double kClearance_px = 1.0; ///< of a ball that is measured, to the edge and to others

std::string ballName(std::size_t ball) { return "ball " + std::to_string(ball); }

SceneFrame frameOf(const HeadsetSeries& series, std::size_t i)
{
    SceneFrame frame;
    frame.eyes = series.eyes(i);
    for (std::size_t ball = 0; ball < series.places().size(); ++ball)
        frame.bodies[ballName(ball)] = RigidTransform::translation(series.places()[ball]);
    return frame;
}

std::vector<ScenePart> balls()
{
    std::vector<ScenePart> parts;
    for (std::size_t ball = 0; ball < kBallColors; ++ball) {
        ScenePart part;
        part.name = part.body = ballName(ball);
        part.id = static_cast<std::uint16_t>(ball + 1);
        part.group = MaterialGroup::Bone;
        part.color = ballColor(ball);
        part.levels = {ballMarker(metres(kBallRadius))};
        parts.push_back(std::move(part));
    }
    return parts;
}

static_assert(HeadsetSeries::kPlaces == kBallColors);
using ExpectedBalls = std::array<std::optional<test::SeenBall>, kBallColors>;

bool touchesAnother(const ExpectedBalls& expected, std::size_t ball)
{
    for (std::size_t other = 0; other < expected.size(); ++other)
        if (other != ball && expected[other]
            && std::hypot(expected[ball]->x - expected[other]->x,
                          expected[ball]->y - expected[other]->y)
                   < expected[ball]->reach + expected[other]->reach + kClearance_px)
            return true;
    return false;
}

bool isWithin(const test::SeenBall& ball, const test::PixelArea& area)
{
    const double room = ball.reach + kClearance_px;
    return ball.x - room > area.left && ball.x + room < area.left + area.width
           && ball.y - room > area.top && ball.y + room < area.top + area.height;
}

/// Holds pictures against what should be seen in them.
class Comparison
{
public:
    explicit Comparison(const HeadsetSeries& series) : m_series{series} {}

    void add(std::size_t frame, const QImage& picture)
    {
        const DisplayGeometry& display = m_series.display(frame);
        const int half = picture.width() / 2;
        addEye(frame, picture, {0, 0, half, picture.height()}, display.p_HDl);
        addEye(frame, picture, {half, 0, half, picture.height()}, display.p_HDr);
    }

    [[nodiscard]] GeometryErrors errors() const
    {
        GeometryErrors errors = m_errors;
        errors.mean_px = m_sum_px / std::max(1, errors.measured);
        return errors;
    }

private:
    void addEye(std::size_t frame, const QImage& picture, const QRect& part, const Vec3& p_H_eye)
    {
        const DisplayGeometry& display = m_series.display(frame);
        const test::EyeBeforeScreen eye{p_H_eye, display.p_HQ_screenCentre, display.screenWidth,
                                        display.screenHeight};
        const test::PixelArea area = test::screenWithin(
            eye, {double(part.x()), double(part.y()), double(part.width()), double(part.height())});
        const RigidTransform X_HA = m_series.head(frame).inverse();
        ExpectedBalls expected;
        for (std::size_t ball = 0; ball < expected.size(); ++ball)
            expected[ball] = test::seenBall(eye, area, X_HA * m_series.places()[ball], kBallRadius);
        const auto found = ballsIn(picture, part);
        for (std::size_t ball = 0; ball < expected.size(); ++ball) {
            if (!expected[ball] || !isWithin(*expected[ball], area))
                ++m_errors.outside;
            else if (touchesAnother(expected, ball))
                ++m_errors.touching;
            else if (found[ball].count == 0)
                ++m_errors.notDrawn;
            else
                measure(*expected[ball], found[ball]);
        }
    }

    void measure(const test::SeenBall& expected, const BallPixels& found)
    {
        const double error_px = std::hypot(found.x - expected.x, found.y - expected.y);
        m_errors.largest_px = std::max(m_errors.largest_px, error_px);
        m_sum_px += error_px;
        m_errors.smallestBall_px =
            m_errors.measured == 0 ? found.count : std::min(m_errors.smallestBall_px, found.count);
        ++m_errors.measured;
    }

    const HeadsetSeries& m_series;
    GeometryErrors m_errors;
    double m_sum_px = 0.0;
};

} // namespace

Result<GeometryErrors> checkGeometry(const AirwayLandmarks& airway, const GeometryTrial& trial)
{
    const auto series = HeadsetSeries::of(airway, trial);
    if (!series)
        return tl::unexpected(series.error());
    Comparison comparison{*series};
    const PictureSeries pictures{
        .count = series->size(),
        .size = {kWindowWidth, kWindowHeight},
        .prepare =
            [](SceneView& view) {
                view.setParts(balls());
                view.setBackground(Qt::black);
            },
        .frame = [&](SceneView&, std::size_t i) { return frameOf(*series, i); },
        .take = [&](SceneView&, std::size_t i, const QImage& picture) -> Result<void> {
            comparison.add(i, picture);
            return {};
        }};
    if (const auto drawn = drawSeries(pictures); !drawn)
        return tl::unexpected(drawn.error());
    return comparison.errors();
}

} // namespace carina::lab
