#include "engine/registration/calibration/tube_calibration.h"

#include "engine/geometry/fit/point_check.h"
#include "engine/geometry/rotation.h"
#include "engine/registration/calibration/shape_fit.h"
#include "engine/registration/calibration/turned_poses.h"
#include "engine/registration/error/error_bound.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carina
{
namespace
{

constexpr std::size_t kFewestRim = 3;
constexpr Length kNarrowRim = millimetres(6.0); ///< least distance between two touches of it
constexpr Length kLeastRise = millimetres(1.0); ///< of an arc to begin with
constexpr double kByChance = 0.01;
constexpr Eigen::Index kOneBend = 8; ///< parameters: pose, length, curvature

struct TouchedTube {
    std::vector<Vec3> rim, wall, tip;
    Length outerDiameter;
};

Result<TouchedTube> touchedTube(std::span<const TubeTouch> touches, Length outerDiameter,
                                const TubeSettings& settings)
{
    if (!(inMillimetres(outerDiameter) >= 2.0 && inMillimetres(outerDiameter) <= 20.0))
        return fail(Errc::OutOfRange, "a tube of " + inWords(outerDiameter));
    TouchedTube touched{.rim = {}, .wall = {}, .tip = {}, .outerDiameter = outerDiameter};
    for (const TubeTouch& touch : touches) {
        if (const auto sound = checkPoint(touch.p_NQ, "a touch"); !sound)
            return tl::unexpected(sound.error());
        auto& part = touch.part == TubePart::Rim    ? touched.rim
                     : touch.part == TubePart::Wall ? touched.wall
                                                    : touched.tip;
        part.push_back(touch.p_NQ);
    }
    if (touched.rim.size() < kFewestRim)
        return fail(Errc::TooFewPoints, "the rim of the connector at three places");
    if (touched.wall.size() < settings.fewestWall)
        return fail(Errc::TooFewPoints, "the wall at " + std::to_string(settings.fewestWall)
                                            + " places between connector and cuff");
    if (touched.tip.empty())
        return fail(Errc::TooFewPoints, "the tip");
    return touched;
}

Vec3 meanOf(const std::vector<Vec3>& points)
{
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : points)
        mean += p / double(points.size());
    return mean;
}

/// That the touches are spread as far as the tube.
Result<void> checkExtent(const TouchedTube& touched, double shortestPart)
{
    for (std::size_t i = 0; i < touched.rim.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if ((touched.rim[i] - touched.rim[j]).norm() < kNarrowRim.si)
                return fail(Errc::DegenerateLandmarks,
                            "two touches of the rim are at the same place");
    const Vec3 p_N_rim = meanOf(touched.rim);
    const Vec3 to = meanOf(touched.tip) - p_N_rim;
    if (to.norm() < 4.0 * touched.outerDiameter.si)
        return fail(Errc::DegenerateLandmarks, "rim and tip are at the same place");
    const auto along = [&](const Vec3& p) { return (p - p_N_rim).dot(to) / to.squaredNorm(); };
    const auto [least, most] = std::ranges::minmax(touched.wall, {}, along);
    if (along(most) - along(least) < shortestPart)
        return fail(Errc::DegenerateLandmarks, "the wall was touched along too short a part");
    return {};
}

/// A pose near the one of the start, and a shape.
class TubeParameters
{
public:
    TubeParameters(const TouchedTube& touched, const RigidTransform& X_NE_start)
        : m_touched{&touched}, m_X_NE{X_NE_start}
    {
    }

    [[nodiscard]] RigidTransform pose(const Eigen::VectorXd& x) const
    {
        return {m_X_NE.rotation() * rotationFromVector(x.segment<3>(3)),
                m_X_NE.translation() + x.head<3>()};
    }
    [[nodiscard]] TubeRest rest(const Eigen::VectorXd& x) const
    {
        return {.length = metres(x[6]),
                .bends = {x[7], x[x.size() > kOneBend ? kOneBend : 7]},
                .outerDiameter = m_touched->outerDiameter};
    }
    [[nodiscard]] Vec3 tip(const Eigen::VectorXd& x) const { return pose(x) * tipOfTube(rest(x)); }

    [[nodiscard]] Eigen::VectorXd residuals(const Eigen::VectorXd& x) const
    {
        const RigidTransform X_EN = pose(x).inverse();
        const TubeRest tube = rest(x);
        std::vector<double> off;
        for (const Vec3& p_NQ : m_touched->rim) {
            const Vec3 p_EQ = X_EN * p_NQ;
            off.push_back(std::hypot(p_EQ.x(), p_EQ.y()) - kConnectorRadius.si);
            off.push_back(p_EQ.z() - kConnectorRim.si);
        }
        for (const Vec3& p_NQ : m_touched->wall)
            off.push_back(distanceFromTube(tube, X_EN * p_NQ) - 0.5 * tube.outerDiameter.si);
        for (const Vec3& p_NQ : m_touched->tip) {
            const Vec3 p_E = X_EN * p_NQ - tipOfTube(tube);
            off.insert(off.end(), {p_E.x(), p_E.y(), p_E.z()});
        }
        return Eigen::Map<const Eigen::VectorXd>{off.data(), Eigen::Index(off.size())};
    }

private:
    const TouchedTube* m_touched; ///< outlives this
    RigidTransform m_X_NE;
};

struct TubeStart {
    RigidTransform X_NE;
    Eigen::VectorXd parameters; ///< of one curvature
};

/// Where the axis of the rim goes, from the plane of its touches towards the tip.
Vec3 aheadOfRim(const TouchedTube& touched)
{
    const Vec3 p_N_rim = meanOf(touched.rim);
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 2; i < touched.rim.size(); ++i) {
        const Vec3 each =
            (touched.rim[i - 1] - touched.rim[0]).cross(touched.rim[i] - touched.rim[0]);
        normal += each.dot(normal) < 0.0 ? Vec3{-each} : each;
    }
    return (normal.dot(meanOf(touched.tip) - p_N_rim) < 0.0 ? Vec3{-normal} : normal).normalized();
}

/// Arcs from the connector to the tip: the one that leaves along the axis of the rim, and some that
/// rise more and less. The touches of the wall tell which is meant: by their distances alone each
/// could be at either side of the centreline.
Result<std::vector<TubeStart>> startsOf(const TouchedTube& touched)
{
    const Vec3 axis = aheadOfRim(touched);
    const Vec3 p_NE = meanOf(touched.rim) + kConnectorRim.si * axis;
    const Vec3 chord = meanOf(touched.tip) - p_NE;
    const Vec3 along = chord.normalized();
    Vec3 out = Vec3::Zero();
    for (const Vec3& p_NQ : touched.wall)
        out += p_NQ - p_NE - (p_NQ - p_NE).dot(along) * along;
    if (!(out.norm() > 1e-6) || !axis.allFinite())
        return fail(Errc::DegenerateLandmarks, "the tube is straight");
    out.normalize();
    const double angle = std::acos(std::clamp(axis.dot(along), -1.0, 1.0));
    std::vector<TubeStart> starts;
    for (const double diameters : {0.0, -0.5, 0.5, -1.0, 1.0}) {
        const double rise =
            0.5 * chord.norm() * std::tan(0.5 * angle) + diameters * touched.outerDiameter.si;
        const double half = 2.0 * std::atan(2.0 * std::max(rise, kLeastRise.si) / chord.norm());
        const double bend = 2.0 * std::sin(half) / chord.norm();
        const Vec3 ahead = std::cos(half) * along + std::sin(half) * out;
        const Vec3 y_N = std::cos(half) * out - std::sin(half) * along;
        Mat3 R_NE;
        R_NE << y_N.cross(-ahead), y_N, -ahead;
        TubeStart start{.X_NE = {Quat{R_NE}, p_NE}, .parameters = Eigen::VectorXd::Zero(kOneBend)};
        start.parameters[6] = 2.0 * half / bend;
        start.parameters[7] = bend;
        starts.push_back(std::move(start));
    }
    return starts;
}

/// With one curvature, and with two where they are worth it.
Result<ShapeFit> fitBends(const TubeParameters& tube, const Eigen::VectorXd& start)
{
    const Residuals residuals = [&](const Eigen::VectorXd& x) { return tube.residuals(x); };
    auto one = fitShape(residuals, start);
    if (!one || one->degrees() < 2.0)
        return one;
    Eigen::VectorXd both{one->parameters.size() + 1};
    both << one->parameters, one->parameters[7];
    auto two = fitShape(residuals, std::move(both));
    if (!two || two->variance() <= 0.0)
        return one;
    const double gain = one->residuals.squaredNorm() - two->residuals.squaredNorm();
    const double ratio = std::max(gain, 0.0) / two->variance();
    return varianceRatioTail(ratio, 1.0, two->degrees()) < kByChance ? two : one;
}

/// The fit, and the parameters' pose.
struct FittedTube {
    TubeParameters tube;
    ShapeFit fit;
};

/// The best of the fits from all starts.
Result<FittedTube> fitTube(const TouchedTube& touched)
{
    const auto starts = startsOf(touched);
    if (!starts)
        return tl::unexpected(starts.error());
    Result<FittedTube> best = fail(Errc::DegenerateLandmarks);
    for (const TubeStart& start : *starts) {
        const TubeParameters tube{touched, start.X_NE};
        auto fit = fitBends(tube, start.parameters);
        if (fit && (!best || fit->residuals.squaredNorm() < best->fit.residuals.squaredNorm()))
            best = FittedTube{tube, *std::move(fit)};
    }
    return best;
}

} // namespace

Result<TubeCalibration> calibrateTube(std::span<const TubeTouch> touches, Length outerDiameter,
                                      const TubeSettings& settings)
{
    const auto touched = touchedTube(touches, outerDiameter, settings);
    if (!touched)
        return tl::unexpected(touched.error());
    if (const auto wide = checkExtent(*touched, settings.shortestPart); !wide)
        return tl::unexpected(wide.error());
    const auto fitted = fitTube(*touched);
    if (!fitted)
        return tl::unexpected(fitted.error());
    const TubeParameters& tube = fitted->tube;
    const ShapeFit& fit = fitted->fit;
    const double rms = std::sqrt(fit.residuals.squaredNorm() / double(touches.size()));
    if (!(rms <= settings.largestRms.si))
        return fail(Errc::NoSurfaceFit, "the touches are off the tube by " + inWords(metres(rms))
                                            + " (RMS), and " + inWords(settings.largestRms)
                                            + " are the most");
    const TubeRest rest = tube.rest(fit.parameters);
    if (!(rest.length.si > 0.0) || sagittaOfTube(rest) < settings.leastSagitta)
        return fail(Errc::DegenerateLandmarks, "the tube is straight");
    const Eigen::MatrixXd J = derivatives(
        [&](const Eigen::VectorXd& x) -> Eigen::VectorXd { return tube.tip(x); }, fit.parameters);
    return TubeCalibration{.X_NE = tube.pose(fit.parameters),
                           .rest = rest,
                           .fle = metres(std::sqrt(3.0 * fit.variance())),
                           .degrees = fit.degrees(),
                           .rms = rms,
                           .covariance_N = fit.variance() * J * fit.spread * J.transpose()};
}

} // namespace carina
