#include "engine/vision/marker_watch.h"

#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

constexpr double kClearly = 2.0;          ///< times as far from the known pose
constexpr double kLargeRotation = 0.0175; ///< 1 degree
constexpr double kLargePosition = 3e-3;   ///< metres
/// How far corners may be from where the best pose puts them: what is taken for the body's markers
/// is not the body beyond that, RMS. A corner whose edges could not be refined is right to about a
/// pixel; and a marker is printed, glued and folded by hand to a few hundredths of its side, which
/// are the more pixels the larger it is in the picture.
constexpr double kRoughCorner = 1.5; ///< pixels
constexpr double kHandmade = 0.03;   ///< of a marker's side in the picture

/// The corners of a body's markers in a picture. A marker that is there twice is not used: at least
/// one of them is of something else.
std::vector<SeenCorner> cornersSeen(const MarkerBody& body, const std::vector<DetectedMarker>& seen)
{
    std::vector<SeenCorner> corners;
    for (const BodyMarker& marker : body) {
        if (std::ranges::count(seen, marker.id, &DetectedMarker::id) != 1)
            continue;
        const auto found = std::ranges::find(seen, marker.id, &DetectedMarker::id);
        const auto p_BQ = cornersOf(marker);
        for (std::size_t i = 0; i < p_BQ.size(); ++i)
            corners.push_back({p_BQ[i], found->corners[i]});
    }
    return corners;
}

/// @param corners of whole markers, four after four
double mostResidual(const std::vector<SeenCorner>& corners)
{
    double sides = 0.0; // pixels
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t next = i % 4 == 3 ? i - 3 : i + 1;
        sides += (corners[next].pixel - corners[i].pixel).norm();
    }
    return kRoughCorner + kHandmade * sides / double(corners.size());
}

double turnBetween(const RigidTransform& a, const RigidTransform& b)
{
    return angleBetween(a.rotation(), b.rotation()).si;
}

} // namespace

MarkerWatch::MarkerWatch(WatchedBodies watched)
    : m_watched{std::move(watched)}, m_known(m_watched.bodies.size())
{
    CARINA_EXPECTS(isUsable(m_watched.camera));
}

std::vector<BodySight> MarkerWatch::look(const GreyPicture& picture, Duration time)
{
    return look(seenMarkers(picture, m_watched.dictionary), time);
}

std::vector<BodySight> MarkerWatch::look(const std::vector<DetectedMarker>& seen, Duration time)
{
    std::vector<BodySight> sights;
    for (std::size_t body = 0; body < m_watched.bodies.size(); ++body)
        sights.push_back(sightOfBody(body, seen, time));
    return sights;
}

BodySight MarkerWatch::sightOfBody(std::size_t body, const std::vector<DetectedMarker>& seen,
                                   Duration time)
{
    const std::vector<SeenCorner> corners = cornersSeen(m_watched.bodies[body], seen);
    BodySight sight{.markers = int(corners.size() / 4)};
    const auto fit = fitBody(m_watched.camera, corners);
    if (!fit || fit->best.rms > mostResidual(corners))
        return sight;
    sight.pose = fit->best;
    sight.evidence = fit->evidence;
    std::optional<Known>& known = m_known[body];
    if (known && (time - known->time > kMemory || time < known->time))
        known.reset();
    const bool isSure = !fit->rival || fit->evidence >= kSure;
    if (!isSure) {
        if (!known) {
            sight.isAmbiguous = true;
            return sight;
        }
        const double best = turnBetween(fit->best.X_TB, known->X_TB);
        const double rival = turnBetween(fit->rival->X_TB, known->X_TB);
        if (std::max(best, rival) < kClearly * std::min(best, rival)) {
            sight.isAmbiguous = true;
            return sight;
        }
        if (rival < best) {
            sight.pose = fit->rival;
            sight.evidence = -fit->evidence;
        }
    }
    if (isSure) // and not a guess by the last one
        known = Known{sight.pose->X_TB, time};
    return sight;
}

ExpectedError expectedError(const FittedBody& pose)
{
    return {.rotation = std::sqrt(pose.covariance_T.topLeftCorner<3, 3>().trace()),
            .position =
                std::sqrt(pointCovariance(pose.covariance_T, pose.X_TB.translation()).trace())};
}

/// The covariance as a small motion of the points of the body.
Mat6 inBody(const FittedBody& pose)
{
    const Mat3 R_BT = pose.X_TB.rotation().conjugate().toRotationMatrix();
    Mat6 toBody = Mat6::Zero();
    toBody.topLeftCorner<3, 3>() = R_BT;
    toBody.bottomLeftCorner<3, 3>() = -R_BT * crossMatrix(pose.X_TB.translation());
    toBody.bottomRightCorner<3, 3>() = R_BT;
    return toBody * pose.covariance_T * toBody.transpose();
}

std::optional<PoseSample> sampleOf(const BodySight& sight, double focal, SessionTime time)
{
    if (!sight.pose || sight.isAmbiguous)
        return std::nullopt;
    const FittedBody& pose = *sight.pose;
    PoseSample sample{.time = time, .X_FO = pose.X_TB};
    sample.error = pose.rms * pose.X_TB.translation().norm() / focal;
    sample.covariance_O = inBody(pose);
    const ExpectedError expected = expectedError(pose);
    if (expected.rotation > kLargeRotation || expected.position > kLargePosition) {
        sample.validity = Validity::PartlyOccluded;
    }
    return sample;
}

} // namespace carina
