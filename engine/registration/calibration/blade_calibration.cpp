#include "engine/registration/calibration/blade_calibration.h"

#include "engine/geometry/fit/point_check.h"
#include "engine/geometry/fit/rigid_fit.h"
#include "engine/geometry/rotation.h"
#include "engine/registration/calibration/shape_fit.h"
#include "engine/registration/calibration/turned_poses.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace carina
{
namespace
{

constexpr Length kLargestBladeRms = millimetres(1.0);
constexpr Length kShortestBlade = millimetres(30.0);
constexpr Eigen::Index kBladeParameters = 12; ///< pose, and six lengths

/// The places as they were touched; means of several touches.
Result<std::array<Vec3, kBladePlaces.size()>> touchedPlaces(std::span<const BladeTouch> touches)
{
    std::array<Vec3, kBladePlaces.size()> sums{};
    std::array<int, kBladePlaces.size()> counts{};
    for (const BladeTouch& touch : touches) {
        if (const auto sound = checkPoint(touch.p_NQ, "a touch"); !sound)
            return tl::unexpected(sound.error());
        const auto i = std::size_t(touch.place);
        sums[i] = counts[i]++ == 0 ? touch.p_NQ : Vec3{sums[i] + touch.p_NQ};
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (counts[i] == 0)
            return fail(Errc::TooFewPoints, "each of the five places");
        sums[i] /= counts[i];
    }
    return sums;
}

/// The shape with these lengths between its places.
BladeShape shapeOf(const std::array<Vec3, kBladePlaces.size()>& p_N)
{
    const auto at = [&](BladePlace place) { return p_N[std::size_t(place)]; };
    const Vec3 heel = 0.5 * (at(BladePlace::LeftHeel) + at(BladePlace::RightHeel));
    const Vec3 up = at(BladePlace::Handle) - heel;
    const auto inPlane = [&](BladePlace place) {
        const Vec3 to = at(place) - heel;
        const double y = to.dot(up.normalized());
        return Vec3{0.0, y, -std::sqrt(std::max(to.squaredNorm() - y * y, 0.0))};
    };
    return {.heelWidth = metres((at(BladePlace::RightHeel) - at(BladePlace::LeftHeel)).norm()),
            .handle = metres(up.norm()),
            .p_L_tip = inPlane(BladePlace::Tip),
            .p_L_half = inPlane(BladePlace::Half)};
}

struct BladeParameters {
    RigidTransform X_NL; ///< near the pose of all zeros

    [[nodiscard]] RigidTransform pose(const Eigen::VectorXd& x) const
    {
        return {X_NL.rotation() * rotationFromVector(x.segment<3>(3)),
                X_NL.translation() + x.head<3>()};
    }
    [[nodiscard]] static BladeShape shape(const Eigen::VectorXd& x)
    {
        return {.heelWidth = metres(x[6]),
                .handle = metres(x[7]),
                .p_L_tip = {0.0, x[8], x[9]},
                .p_L_half = {0.0, x[10], x[11]}};
    }
    [[nodiscard]] static Eigen::VectorXd of(const BladeShape& shape)
    {
        Eigen::VectorXd x = Eigen::VectorXd::Zero(kBladeParameters);
        x.tail<6>() << shape.heelWidth.si, shape.handle.si, shape.p_L_tip.y(), shape.p_L_tip.z(),
            shape.p_L_half.y(), shape.p_L_half.z();
        return x;
    }
};

} // namespace

Length BladeShape::sag() const
{
    const Vec3 to = p_L_tip.normalized();
    return metres((p_L_half - p_L_half.dot(to) * to).norm()
                  * (p_L_half.y() * p_L_tip.z() - p_L_half.z() * p_L_tip.y() > 0.0 ? 1.0 : -1.0));
}

bool BladeShape::isCurved() const { return sag().si > kCurvedBladeSag * p_L_tip.norm(); }

Vec3 placeOnBlade(const BladeShape& blade, BladePlace place)
{
    switch (place) {
    case BladePlace::LeftHeel:
        return {-0.5 * blade.heelWidth.si, 0.0, 0.0};
    case BladePlace::RightHeel:
        return {0.5 * blade.heelWidth.si, 0.0, 0.0};
    case BladePlace::Handle:
        return {0.0, blade.handle.si, 0.0};
    case BladePlace::Half:
        return blade.p_L_half;
    case BladePlace::Tip:
        break;
    }
    return blade.p_L_tip;
}

Result<BladeCalibration> calibrateBlade(std::span<const BladeTouch> touches)
{
    const auto touched = touchedPlaces(touches);
    if (!touched)
        return tl::unexpected(touched.error());
    const BladeShape start = shapeOf(*touched);
    if (start.p_L_tip.norm() < kShortestBlade.si || start.handle < kShortestBlade)
        return fail(Errc::DegenerateLandmarks, "heel, tip and handle are too near to each other");
    std::vector<LandmarkPair> pairs;
    for (const BladePlace place : kBladePlaces)
        pairs.push_back({(*touched)[std::size_t(place)], placeOnBlade(start, place)});
    const auto rigid = fitRigid(pairs);
    if (!rigid)
        return tl::unexpected(rigid.error());
    const BladeParameters parameters{rigid->X_AM};
    const auto residuals = [&](const Eigen::VectorXd& x) {
        const RigidTransform X_NL = parameters.pose(x);
        const BladeShape shape = BladeParameters::shape(x);
        Eigen::VectorXd off{3 * Eigen::Index(touches.size())};
        for (std::size_t i = 0; i < touches.size(); ++i)
            off.segment<3>(3 * Eigen::Index(i)) =
                touches[i].p_NQ - X_NL * placeOnBlade(shape, touches[i].place);
        return off;
    };
    const auto fit = fitShape(residuals, BladeParameters::of(start));
    if (!fit)
        return tl::unexpected(fit.error());
    const BladeShape shape = BladeParameters::shape(fit->parameters);
    if (!(shape.heelWidth.si > 0.0))
        return fail(Errc::NoSurfaceFit, "left and right corner of the heel are exchanged");
    const double rms = std::sqrt(fit->residuals.squaredNorm() / double(touches.size()));
    if (!(rms <= kLargestBladeRms.si))
        return fail(Errc::NoSurfaceFit, "the touches are off a symmetric blade by "
                                            + inWords(metres(rms)) + " (RMS), and "
                                            + inWords(kLargestBladeRms) + " are the most");
    const Eigen::MatrixXd J = derivatives(
        [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
            return parameters.pose(x) * BladeParameters::shape(x).p_L_tip;
        },
        fit->parameters);
    return BladeCalibration{.X_NL = parameters.pose(fit->parameters),
                            .shape = shape,
                            .fle = metres(std::sqrt(3.0 * fit->variance())),
                            .degrees = fit->degrees(),
                            .rms = rms,
                            .covariance_N = fit->variance() * J * fit->spread * J.transpose()};
}

} // namespace carina
