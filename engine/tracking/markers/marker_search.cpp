#include "engine/tracking/markers/marker_search.h"

#include "engine/core/expects.h"
#include "engine/geometry/fit/rigid_fit.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace carina
{
namespace
{

using MarkerTriple = std::array<std::size_t, 3>;

constexpr Angle kAlikePoses = degrees(5.0); ///< poses of one assignment differ by less
constexpr Angle kSlack = degrees(10.0);
constexpr double kNearly = 2.0;          ///< times the misfit of the best order
constexpr double kNearlyMore = 0.1e-3;   ///< and metres
constexpr std::size_t kMostTriples = 60; ///< of points, which are tried

/// Markers found, and the pose that they give.
struct FoundMarkers {
    RigidTransform X_TO;
    std::vector<SeenMarker> markers{};
    double rms = 0.0; ///< of the misfits, metres
};

double doubleArea(const Vec3& a, const Vec3& b, const Vec3& c)
{
    return (b - a).cross(c - a).norm();
}

/// The triples of points, those of large triangles that are no larger than the probe first.
std::vector<MarkerTriple> triplesOfPoints(std::span<const Vec3> p_TQ, double extent)
{
    std::vector<std::pair<double, MarkerTriple>> ranked;
    const auto areNear = [&](std::size_t a, std::size_t b) {
        return (p_TQ[a] - p_TQ[b]).norm() <= extent;
    };
    for (std::size_t i = 0; i < p_TQ.size(); ++i)
        for (std::size_t j = i + 1; j < p_TQ.size(); ++j) {
            if (!areNear(i, j))
                continue;
            for (std::size_t k = j + 1; k < p_TQ.size(); ++k)
                if (areNear(i, k) && areNear(j, k))
                    ranked.push_back({-doubleArea(p_TQ[i], p_TQ[j], p_TQ[k]), {i, j, k}});
        }
    const std::size_t kept = std::min<std::size_t>(kMostTriples, ranked.size());
    std::ranges::partial_sort(ranked, ranked.begin() + std::ptrdiff_t(kept));
    std::vector<MarkerTriple> triples;
    for (std::size_t i = 0; i < kept; ++i)
        triples.push_back(ranked[i].second);
    return triples;
}

double extentOfProbe(const Probe& probe)
{
    double extent = 0.0;
    for (const ToolMarker& a : probe.markers)
        for (const ToolMarker& b : probe.markers)
            extent = std::max(extent, (a.p_OQ - b.p_OQ).norm());
    return extent + 2.0 * probe.largestMisfit.si;
}

class MarkerSearch
{
public:
    MarkerSearch(const Probe& probe, std::span<const Vec3> p_TQ)
        : m_probe{probe}, m_p_TQ{p_TQ}, m_extent{extentOfProbe(probe)}
    {
    }

    [[nodiscard]] double extent() const { return m_extent; }

    /// The best assignment of a triple, in which it has most points; with `isAmbiguous` another of
    /// as many points that fits nearly as well.
    std::optional<FoundMarkers> of(const MarkerTriple& points, bool& isAmbiguous) const
    {
        const std::vector<FoundMarkers> all = assignmentsOf(points);
        if (all.empty())
            return std::nullopt;
        const auto better = [](const FoundMarkers& x, const FoundMarkers& y) {
            return x.markers.size() != y.markers.size() ? x.markers.size() > y.markers.size()
                                                        : x.rms < y.rms;
        };
        const auto best = std::ranges::min_element(all, better);
        isAmbiguous = std::ranges::any_of(all, [&](const FoundMarkers& other) {
            return other.markers.size() == best->markers.size()
                   && other.rms < kNearly * best->rms + kNearlyMore
                   && angleBetween(other.X_TO.rotation(), best->X_TO.rotation()) > kAlikePoses;
        });
        return *best;
    }

private:
    [[nodiscard]] double limit() const { return m_probe.largestMisfit.si; }

    [[nodiscard]] std::vector<FoundMarkers> assignmentsOf(const MarkerTriple& points) const
    {
        std::vector<FoundMarkers> all;
        const std::size_t count = m_probe.markers.size();
        for (std::size_t a = 0; a < count; ++a)
            for (std::size_t b = 0; b < count; ++b) {
                if (b == a || !agree(points[0], points[1], a, b))
                    continue;
                for (std::size_t c = 0; c < count; ++c)
                    if (c != a && c != b && agree(points[0], points[2], a, c)
                        && agree(points[1], points[2], b, c))
                        if (auto found = grown(points, {a, b, c}))
                            all.push_back(*std::move(found));
            }
        return all;
    }

    [[nodiscard]] bool agree(std::size_t i, std::size_t j, std::size_t a, std::size_t b) const
    {
        const double seen = (m_p_TQ[i] - m_p_TQ[j]).norm();
        const double is = (m_probe.markers[a].p_OQ - m_probe.markers[b].p_OQ).norm();
        return std::abs(seen - is) <= 2.0 * limit();
    }

    /// A little more than it may face away: the lines of sight to the markers are not parallel.
    [[nodiscard]] bool isSeen(std::size_t marker, const RigidTransform& X_TO) const
    {
        const Vec3 d_O = X_TO.rotation().conjugate() * -X_TO.translation().stableNormalized();
        return faces(m_probe.markers[marker], d_O, m_probe.largestAngle + kSlack);
    }

    /// Whether a point within the tool's size is none of its markers.
    [[nodiscard]] bool hasOthersNear(const FoundMarkers& found) const
    {
        return std::ranges::any_of(m_p_TQ, [&](const Vec3& p) {
            const auto isThis = [&](const SeenMarker& marker) { return marker.p_TQ == p; };
            return std::ranges::none_of(found.markers, isThis)
                   && (p - found.markers.front().p_TQ).norm() <= m_extent;
        });
    }

    /// The pose of three markers, and all other markers that it puts at a point.
    [[nodiscard]] std::optional<FoundMarkers> grown(const MarkerTriple& points,
                                                    const MarkerTriple& markers) const
    {
        std::array<LandmarkPair, 3> pairs;
        for (std::size_t i = 0; i < 3; ++i)
            pairs[i] = {m_p_TQ[points[i]], m_probe.markers[markers[i]].p_OQ};
        const Result<RigidFit> fit = fitRigid(pairs);
        if (!fit || std::ranges::max(fit->residuals) > limit())
            return std::nullopt;
        FoundMarkers found{.X_TO = fit->X_AM};
        for (std::size_t marker = 0; marker < m_probe.markers.size(); ++marker) {
            const auto* mine = std::ranges::find(markers, marker);
            const bool isSeen = this->isSeen(marker, found.X_TO);
            if (mine != markers.end() && !isSeen)
                return std::nullopt;
            if (isSeen)
                take(found, marker);
        }
        // Three points that are like three markers are found in many a cloud.
        if (found.markers.size() < 3 || (found.markers.size() == 3 && hasOthersNear(found)))
            return std::nullopt;
        return refitted(std::move(found));
    }

    /// With the pose of all markers found; nothing where they do not fit.
    [[nodiscard]] std::optional<FoundMarkers> refitted(FoundMarkers found) const
    {
        std::vector<LandmarkPair> pairs;
        for (const SeenMarker& marker : found.markers)
            pairs.push_back({marker.p_TQ, m_probe.markers[marker.marker].p_OQ});
        const Result<RigidFit> fit = fitRigid(pairs);
        if (!fit || std::ranges::max(fit->residuals) > limit())
            return std::nullopt;
        found.X_TO = fit->X_AM;
        found.rms = fit->rms;
        return found;
    }

    /// The nearest point to a marker, if it is near and no other marker's.
    void take(FoundMarkers& found, std::size_t marker) const
    {
        const Vec3 place = found.X_TO * m_probe.markers[marker].p_OQ;
        const auto nearest = std::ranges::min_element(
            m_p_TQ, {}, [&](const Vec3& p) { return (p - place).squaredNorm(); });
        const double off = (*nearest - place).norm();
        // A pose of three points puts far ones off by a multiple of their error.
        if (off > 2.0 * limit() || std::ranges::any_of(found.markers, [&](const SeenMarker& taken) {
                return taken.p_TQ == *nearest;
            }))
            return;
        found.markers.push_back({.marker = marker, .p_TQ = *nearest});
    }

    const Probe& m_probe;
    std::span<const Vec3> m_p_TQ;
    double m_extent; ///< of the probe, metres
};

} // namespace

Result<std::vector<SeenMarker>> searchMarkers(const Probe& probe, std::span<const Vec3> p_TQ)
{
    CARINA_EXPECTS(p_TQ.size() <= kMostPoints);
    if (p_TQ.size() < std::max<std::size_t>(3, probe.fewest))
        return fail(Errc::TooFewLandmarks, std::to_string(p_TQ.size()) + " points are seen");
    const MarkerSearch search{probe, p_TQ};
    std::optional<FoundMarkers> best;
    bool isBestAmbiguous = false;
    for (const MarkerTriple& points : triplesOfPoints(p_TQ, search.extent())) {
        bool isAmbiguous = false;
        auto found = search.of(points, isAmbiguous);
        if (!found || (best && found->markers.size() <= best->markers.size()))
            continue;
        best = std::move(found);
        isBestAmbiguous = isAmbiguous;
        if (best->markers.size() == std::min(p_TQ.size(), probe.markers.size()))
            break; // there are no more
    }
    if (!best || best->markers.size() < probe.fewest)
        return fail(Errc::DegenerateLandmarks, "the points do not fit the tool");
    if (isBestAmbiguous)
        return fail(Errc::DegenerateLandmarks, "several orders of the markers fit as well");
    return std::move(best->markers);
}

} // namespace carina
