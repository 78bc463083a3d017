#include "engine/registration/fit/surface_refinement.h"

#include "engine/geometry/fit/motion_covariance.h"
#include "engine/geometry/fit/point_check.h"
#include "engine/geometry/rotation.h"
#include "engine/registration/calibration/turned_poses.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kDeviationsPerMedian = 1.4826; // of |d| for a normal d
constexpr double kLeastLimit = 0.3e-3;          // metres
constexpr double kOnSurface = 1e-9;             // metres: nearer, the triangle tells the direction
constexpr double kLeastExtent = 1e-9;           // metres: of a swab of one place
constexpr double kSettled = 1e-6;               // metres: no step worth taking
constexpr double kNarrowing = 0.6;              // of the limit, in one step

/// A swabbed point in a pose, and how it stands off the surface.
struct Touch {
    Vec3 p_A;
    Vec3 normal_A;
    double distance; ///< along the normal
};

struct Swab {
    const SurfaceTree* surface_A;
    std::span<const Vec3> p_MQ;

    [[nodiscard]] std::vector<Touch> touches(const RigidTransform& X_AM) const
    {
        std::vector<Touch> touches;
        touches.reserve(p_MQ.size());
        for (const Vec3& p_M : p_MQ) {
            const Vec3 p_A = X_AM * p_M;
            const SurfacePoint nearest = *surface_A->nearestTo(p_A);
            const Vec3 off = p_A - nearest.p;
            const double distance = off.norm();
            if (distance > kOnSurface)
                touches.push_back({p_A, off / distance, distance});
            else
                touches.push_back({p_A, nearest.normal, 0.0});
        }
        return touches;
    }
};

double rmsOf(std::span<const Touch> touches, double limit)
{
    double squares = 0.0;
    int count = 0;
    for (const Touch& touch : touches) {
        if (touch.distance > limit)
            continue;
        squares += touch.distance * touch.distance;
        ++count;
    }
    return std::sqrt(squares / count);
}

double costOf(std::span<const Touch> touches, double limit)
{
    double cost = 0.0;
    for (const Touch& touch : touches)
        cost += std::pow(std::min(touch.distance, limit), 2);
    return cost;
}

/// Three standard deviations, as the median tells them.
double robustLimit(std::span<const Touch> touches)
{
    std::vector<double> distances;
    for (const Touch& touch : touches)
        distances.push_back(touch.distance);
    const auto middle = distances.begin() + std::ssize(distances) / 2;
    std::ranges::nth_element(distances, middle);
    return std::max(kLeastLimit, 3.0 * kDeviationsPerMedian * *middle);
}

/// The touches within the limit as equations for a small motion, turns scaled by the extent.
struct Equations {
    Vec3 p_AC = Vec3::Zero();
    double extent = 0.0;
    int count = 0;
    double squares = 0.0;
    Vec6 holds;      ///< ascending
    Mat6 directions; ///< in its columns
    Vec6 slope = Vec6::Zero();

    Equations(std::span<const Touch> touches, double limit)
    {
        for (const Touch& touch : touches)
            p_AC += touch.p_A / double(touches.size());
        for (const Touch& touch : touches)
            extent += (touch.p_A - p_AC).squaredNorm() / double(touches.size());
        extent = std::max(kLeastExtent, std::sqrt(extent));
        Mat6 normal = Mat6::Zero();
        for (const Touch& touch : touches) {
            if (touch.distance > limit)
                continue;
            Vec6 j;
            j << (touch.p_A - p_AC).cross(touch.normal_A) / extent, touch.normal_A;
            normal += j * j.transpose();
            slope += touch.distance * j;
            squares += touch.distance * touch.distance;
            ++count;
        }
        const Eigen::SelfAdjointEigenSolver<Mat6> solver{normal / count};
        holds = solver.eigenvalues();
        directions = solver.eigenvectors();
        slope /= count;
    }

    [[nodiscard]] bool isLoose(int i, double leastHold) const
    {
        return holds[i] < leastHold * leastHold;
    }

    /// The Gauss-Newton step along all motions that are held.
    [[nodiscard]] Vec6 step(double leastHold) const
    {
        Vec6 step = Vec6::Zero();
        for (int i = 0; i < 6; ++i)
            if (!isLoose(i, leastHold))
                step -= directions.col(i).dot(slope) / holds[i] * directions.col(i);
        return step;
    }

    [[nodiscard]] RigidTransform moved(const RigidTransform& X_AM, const Vec6& step) const
    {
        const Quat turn = rotationFromVector(step.head<3>() / extent);
        const Vec3 shift = p_AC - turn * p_AC + step.tail<3>();
        return RigidTransform{turn, shift} * X_AM;
    }
};

/// Where the steps led, and the touches there.
struct Search {
    RigidTransform X_AM;
    std::vector<Touch> touches{};
    double limit = 0.0;
    int iterations = 0;
    bool settled = false;
};

/// Takes one step. @returns false where it is not worth taking, or does not lessen the sum.
bool takeStep(const Swab& swab, double leastHold, Search& search)
{
    const Equations equations{search.touches, search.limit};
    const Vec6 step = equations.step(leastHold);
    if (step.norm() < kSettled)
        return false;
    const RigidTransform X_AM = equations.moved(search.X_AM, step);
    std::vector<Touch> touches = swab.touches(X_AM);
    if (costOf(touches, search.limit) >= costOf(search.touches, search.limit))
        return false;
    search.X_AM = X_AM;
    search.touches = std::move(touches);
    return true;
}

/// Further away, a touch does not count in the first step.
Length firstLimit(const RefinementSettings& settings) { return 2.0 * settings.farthestMove; }

Search searchFrom(const Swab& swab, const RigidTransform& X_AM, const RefinementSettings& settings)
{
    Search search{.X_AM = X_AM, .touches = swab.touches(X_AM)};
    search.limit = firstLimit(settings).si;
    while (!search.settled && search.iterations < settings.mostSteps) {
        ++search.iterations;
        const bool stands = !takeStep(swab, settings.leastHold, search);
        const double narrower = std::max(robustLimit(search.touches), kNarrowing * search.limit);
        search.settled = stands && narrower >= search.limit;
        search.limit = std::min(search.limit, narrower);
    }
    return search;
}

void describe(const Search& search, double leastHold, SurfaceRefinement& result)
{
    const Equations equations{search.touches, search.limit};
    result.outliers = static_cast<int>(search.touches.size()) - equations.count;
    result.p_AC = equations.p_AC;
    result.extent = equations.extent;
    Vec6 scale;
    scale << Vec3::Constant(1.0 / equations.extent), Vec3::Ones();
    for (int i = 0; i < 6; ++i) {
        const Vec6 motion = equations.directions.col(i);
        if (equations.isLoose(i, leastHold)) {
            result.loose.push_back({motion.head<3>(), motion.tail<3>()});
            continue;
        }
        const Vec6 unscaled = scale.cwiseProduct(motion);
        const double variance =
            equations.squares / (equations.count - 6) / equations.count / equations.holds[i];
        result.covariance += variance * unscaled * unscaled.transpose();
    }
}

Result<void> checkSwab(const SurfaceTree& surface_A, std::span<const Vec3> p_MQ)
{
    if (p_MQ.size() < kFewestSwabPoints)
        return fail(Errc::TooFewPoints, std::to_string(p_MQ.size()) + " points, and "
                                            + std::to_string(kFewestSwabPoints)
                                            + " are the fewest");
    for (const Vec3& p_M : p_MQ)
        if (const auto sound = checkPoint(p_M, "a point of the swab"); !sound)
            return sound;
    if (!surface_A.nearestTo(Vec3::Zero()))
        return fail(Errc::NoSurfaceFit, "the surface is empty");
    return {};
}

/// Without a touch that counts there is no step to take.
Result<void> checkReach(std::span<const Touch> touches, const RefinementSettings& settings)
{
    const Length reach = firstLimit(settings);
    if (std::ranges::all_of(touches, [&](const Touch& touch) { return touch.distance > reach.si; }))
        return fail(Errc::NoSurfaceFit,
                    "no point of the swab lies within " + inWords(reach) + " of the surface");
    return {};
}

Result<void> checkSettled(const Search& search, const SurfaceRefinement& result,
                          const RefinementSettings& settings)
{
    if (result.moved > settings.farthestMove.si)
        return fail(Errc::NoSurfaceFit, "the swab would move by " + inWords(metres(result.moved))
                                            + ", and " + inWords(settings.farthestMove)
                                            + " are the most");
    if (!search.settled)
        return fail(Errc::NoSurfaceFit,
                    "the swab still moves after " + std::to_string(search.iterations) + " steps");
    if (result.rms > settings.largestRms.si)
        return fail(Errc::NoSurfaceFit, "the swab stays " + inWords(metres(result.rms))
                                            + " (RMS) off the surface, and "
                                            + inWords(settings.largestRms) + " are the most");
    return {};
}

} // namespace

double SurfaceRefinement::uncertaintyAt(const Vec3& p_A) const
{
    Eigen::Matrix<double, 3, 6> lever; // of a turn and a shift at the point
    const Vec3 r = p_A - p_AC;
    lever << 0.0, r.z(), -r.y(), 1.0, 0.0, 0.0, //
        -r.z(), 0.0, r.x(), 0.0, 1.0, 0.0,      //
        r.y(), -r.x(), 0.0, 0.0, 0.0, 1.0;
    return std::sqrt((lever * covariance * lever.transpose()).trace());
}

Result<SurfaceRefinement> refineOnSurface(const SurfaceTree& surface_A, std::span<const Vec3> p_MQ,
                                          const RigidTransform& X_AM,
                                          const RefinementSettings& settings)
{
    if (const auto sound = checkSwab(surface_A, p_MQ); !sound)
        return tl::unexpected(sound.error());
    const Swab swab{&surface_A, p_MQ};
    const std::vector<Touch> before = swab.touches(X_AM);
    if (const auto reached = checkReach(before, settings); !reached)
        return tl::unexpected(reached.error());
    const double everything = std::numeric_limits<double>::infinity();
    const Search search = searchFrom(swab, X_AM, settings);
    SurfaceRefinement result{.X_AM = search.X_AM,
                             .startRms = rmsOf(before, everything),
                             .rms = rmsOf(search.touches, search.limit),
                             .iterations = search.iterations};
    for (const Vec3& p_M : p_MQ)
        result.moved = std::max(result.moved, (search.X_AM * p_M - X_AM * p_M).norm());
    if (const auto sound = checkSettled(search, result, settings); !sound)
        return tl::unexpected(sound.error());
    describe(search, settings.leastHold, result);
    if (result.outliers > settings.mostOutliers * double(p_MQ.size()))
        return fail(Errc::NoSurfaceFit, std::to_string(result.outliers) + " of "
                                            + std::to_string(p_MQ.size())
                                            + " points do not lie on the surface");
    return result;
}

} // namespace carina
