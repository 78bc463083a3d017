#include "engine/registration/landmarks/landmark_order.h"

#include "engine/core/expects.h"
#include "engine/registration/error/error_bound.h"
#include "engine/registration/fit/pose_misfit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace carina
{
namespace
{

double rmsOrInfinite(std::span<const LandmarkPair> pairs)
{
    const Result<RigidFit> fit = fitRigid(pairs);
    return fit ? fit->rms : std::numeric_limits<double>::infinity();
}

std::vector<LandmarkPair> inOrder(std::span<const LandmarkPair> pairs,
                                  const std::vector<std::size_t>& touchOf)
{
    std::vector<LandmarkPair> ordered{pairs.begin(), pairs.end()};
    for (std::size_t i = 0; i < pairs.size(); ++i)
        ordered[i].p_MQ = pairs[touchOf[i]].p_MQ;
    return ordered;
}

/// Searches the orders in which all distances agree.
class OrderSearch
{
public:
    OrderSearch(std::span<const LandmarkPair> pairs, double tolerance, double plausibleRms)
        : m_pairs{pairs},
          m_tolerance{tolerance},
          m_plausibleRms{plausibleRms},
          m_touchOf(pairs.size()),
          m_best(pairs.size())
    {
        std::iota(m_touchOf.begin(), m_touchOf.end(), 0U);
        m_best = m_touchOf;
    }

    /// @returns false beyond kMostOrders.
    bool run() { return assign(0); }

    [[nodiscard]] const std::vector<std::size_t>& best() const { return m_best; }
    [[nodiscard]] double rms() const { return m_rms; }
    [[nodiscard]] std::size_t explanations() const { return m_explanations; }

private:
    /// Tries all remaining touches, those from this index on, for the landmark.
    bool assign(std::size_t landmark)
    {
        if (++m_looked > kMostOrders)
            return false;
        if (landmark == m_pairs.size()) {
            judge();
            return true;
        }
        for (std::size_t other = landmark; other < m_pairs.size(); ++other) {
            std::swap(m_touchOf[landmark], m_touchOf[other]);
            const bool goesOn = !agrees(landmark) || assign(landmark + 1);
            std::swap(m_touchOf[landmark], m_touchOf[other]);
            if (!goesOn)
                return false;
        }
        return true;
    }

    /// Whether the distances of this landmark's touch from those before match their landmarks'.
    [[nodiscard]] bool agrees(std::size_t landmark) const
    {
        for (std::size_t before = 0; before < landmark; ++before) {
            const double ofLandmarks = (m_pairs[landmark].p_AQ - m_pairs[before].p_AQ).norm();
            const double ofTouches =
                (m_pairs[m_touchOf[landmark]].p_MQ - m_pairs[m_touchOf[before]].p_MQ).norm();
            if (std::abs(ofLandmarks - ofTouches) > m_tolerance)
                return false;
        }
        return true;
    }

    void judge()
    {
        const double rms = rmsOrInfinite(inOrder(m_pairs, m_touchOf));
        m_explanations += rms <= m_plausibleRms ? 1U : 0U;
        if (rms < m_rms) {
            m_rms = rms;
            m_best = m_touchOf;
        }
    }

    std::span<const LandmarkPair> m_pairs;
    double m_tolerance;
    double m_plausibleRms;
    std::vector<std::size_t> m_touchOf;
    std::vector<std::size_t> m_best;
    double m_rms = std::numeric_limits<double>::infinity();
    std::size_t m_explanations = 0;
    std::size_t m_looked = 0;
};

/// The FRE that errors of this size exceed with probability 1 - kPlausibleShare.
double plausibleRms(Length fle, std::size_t landmarks)
{
    const double degrees = 3.0 * double(landmarks) - 6.0;
    const double meanSquare = fle.si * fle.si * (1.0 - 2.0 / double(landmarks));
    return std::sqrt(meanSquare * chiSquaredShare(degrees, kPlausibleShare));
}

} // namespace

std::vector<LandmarkPair> OrderFinding::repaired(std::span<const LandmarkPair> pairs) const
{
    CARINA_EXPECTS(pairs.size() == touchOf.size());
    return inOrder(pairs, touchOf);
}

Result<OrderFinding> recogniseOrder(std::span<const LandmarkPair> pairs, Length fle)
{
    CARINA_EXPECTS(fle.si > 0.0);
    const Result<RigidFit> asGiven = fitRigid(pairs);
    if (!asGiven && asGiven.error().code != Errc::DegenerateLandmarks)
        return tl::unexpected(asGiven.error());
    const double plausible = plausibleRms(fle, pairs.size());
    // Along one direction a touch strays by FLE / sqrt 3, a distance of two by sqrt 2 of that.
    OrderSearch search{pairs, kFarthestDeviations * std::sqrt(2.0 / 3.0) * fle.si, plausible};
    if (!search.run())
        return fail(Errc::DegenerateLandmarks, "they lie too close to tell them apart");

    OrderFinding finding;
    finding.touchOf.resize(pairs.size());
    finding.rmsAsGiven = metres(rmsOrInfinite(pairs));
    finding.explanations = search.explanations();
    std::iota(finding.touchOf.begin(), finding.touchOf.end(), 0U);
    finding.rms = finding.rmsAsGiven;
    std::vector<LandmarkPair> mirrored{pairs.begin(), pairs.end()};
    for (LandmarkPair& pair : mirrored)
        pair.p_MQ.x() = -pair.p_MQ.x();
    if (finding.rmsAsGiven.si <= plausible) {
        finding.order = TouchOrder::AsGiven;
    } else if (search.rms() <= plausible) {
        finding.order = TouchOrder::Exchanged;
        finding.touchOf = search.best();
        finding.rms = metres(search.rms());
    } else if (const double rms = rmsOrInfinite(mirrored); rms <= plausible) {
        finding.order = TouchOrder::MirrorImage;
        finding.rms = metres(rms);
    }
    return finding;
}

} // namespace carina
