#include "engine/airway/tube/tube_in_lumen.h"

#include "engine/airway/tube/tube_shape_code.h"
#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
namespace
{

constexpr double kBeforeConnector = 0.3; ///< metres: as far back as a tube can be held
constexpr int kPiecesInFront = 12;       ///< of the curve from the connector to the mouth
constexpr double kLeastInFront = 0.012;  ///< metres from the connector to where the way begins
constexpr double kLeaves = 0.01;         ///< metres before the teeth, from which a tip is outside
constexpr double kNearTeeth = 0.06;      ///< metres: a connector that may be between them
constexpr double kLeastApart = 1e-3;     ///< metres between sections of two ways
constexpr double kGoesOver = 8e-3; ///< metres of the trunk in which a tube turns into a branch
constexpr double kPastFork = 0.01; ///< metres
constexpr double kAtStop = 1e-3;   ///< metres before a stop from which a tip is said to be there
constexpr Length kStopped = millimetres(0.2);

/// The place at a length along the centre of a way, and beyond its end on in its direction.
Vec3 middleAt(const MovedWay& way, double along)
{
    const auto after = std::ranges::upper_bound(way.along, along);
    const auto i = std::size_t(std::clamp<std::ptrdiff_t>(after - way.along.begin(), 1,
                                                          std::ptrdiff_t(way.along.size()) - 1));
    const Vec3& a = way.sections[i - 1].p_A_centre;
    const Vec3& b = way.sections[i].p_A_centre;
    return a + (along - way.along[i - 1]) / (way.along[i] - way.along[i - 1]) * (b - a);
}

double branchOf(const MovedLumen& lumen, AirwayWay which)
{
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    if (which == AirwayWay::Trunk)
        return trunk.along.back();
    const Vec3& p_A = lumen.way(which).sections.front().p_A_centre;
    std::size_t segment = trunk.nearestSegment(p_A);
    return trunk.alongAt(p_A, segment);
}

/// Where a place is along a way and the trunk before it.
double placeIn(const MovedLumen& lumen, AirwayWay which, const Vec3& p_A)
{
    const MovedWay& way = lumen.way(which);
    std::size_t segment = way.nearestSegment(p_A);
    const double place = way.alongAt(p_A, segment);
    return which == AirwayWay::Trunk ? place : branchOf(lumen, which) + place;
}

std::size_t entryOf(std::span<const Vec3> nodes, const Vec3& p_A)
{
    const auto nearest = std::ranges::min_element(
        nodes, {}, [&](const Vec3& node) { return (node - p_A).squaredNorm(); });
    return std::size_t(nearest - nodes.begin());
}

GuideSection walled(const MovedSection& section)
{
    return {section.p_A_centre, section.side, section.back, section.reach, false};
}

bool hasMainBronchi(const MovedLumen& lumen)
{
    return lumen.way(AirwayWay::RightMain).isThere() && lumen.way(AirwayWay::LeftMain).isThere();
}

bool isBehind(const MovedWay& way, const Vec3& p_A)
{
    std::size_t segment = way.nearestSegment(p_A);
    return way.alongAt(p_A, segment) >= way.along.back();
}

/// A cubic from one place and direction to another one, without its last place.
std::vector<Vec3> curveBetween(const Vec3& a, const Vec3& alongA, const Vec3& b, const Vec3& alongB)
{
    const double length = (b - a).norm();
    std::vector<Vec3> curve;
    for (int i = 0; i < kPiecesInFront; ++i) {
        const double s = double(i) / kPiecesInFront;
        const double r = 1.0 - s;
        curve.push_back(r * r * (1.0 + 2.0 * s) * a + s * s * (1.0 + 2.0 * r) * b
                        + length * s * r * (r * alongA - s * alongB));
    }
    return curve;
}

} // namespace

TubeInLumen::TubeInLumen(const TubeSize& size, std::span<const Vec3> p_E_rest)
    : m_size(size), m_rod(size.stiffness, inPieces(p_E_rest, kPieces))
{
}

void TubeInLumen::step(const RigidTransform& X_AE, const MovedLumen& lumen,
                       std::span<const Vec3> p_E_rest)
{
    if (!p_E_rest.empty())
        m_rod.setRest(inPieces(p_E_rest, kPieces));
    lieIn(lumen, X_AE, m_rod.nodesAtRest(X_AE).back());
}

void TubeInLumen::found(const RigidTransform& X_AE, const Vec3& p_A_tip, bool isHeldUp,
                        const MovedLumen& lumen, std::span<const Vec3> p_E_rest)
{
    if (!p_E_rest.empty())
        m_rod.setRest(inPieces(p_E_rest, kPieces));
    m_isInside = false;
    lieIn(lumen, X_AE, p_A_tip, isHeldUp ? kFoundBefore : Length{});
}

/// @param p_A_tip where its tip is, or would be without walls
/// @param before  of the tip of one that is found: it has passed only what lies farther before
void TubeInLumen::lieIn(const MovedLumen& lumen, const RigidTransform& X_AE, const Vec3& p_A_tip,
                        Length before)
{
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    CARINA_EXPECTS(trunk.isThere());
    const std::vector<Vec3> measured = m_rod.nodesAtRest(X_AE);
    const bool wasInside = m_isInside;
    m_isInside = isFoundInside(measured, p_A_tip, lumen);
    if (m_isInside) {
        const double was = wasInside ? tipOnWay() : 0.0;
        m_way.which = nearestWay(p_A_tip, lumen, wasInside);
        m_way.branch = branchOf(lumen, m_way.which);
        guideAlong(measured[0], (measured[1] - measured[0]).normalized(), lumen);
        const double place = wasInside ? was : placeIn(lumen, m_way.which, p_A_tip) - before.si;
        const RodHold hold{X_AE, &m_guide, m_onGuide.clamp, guideAt(stopAhead(place, lumen)),
                           kHeldByHand};
        if (!wasInside || !m_rod.step(hold))
            m_rod.layAlong(hold, entryOf(measured, middleAt(trunk, m_onGuide.joined)),
                           m_onGuide.join);
        // Where no rod can be found, as of a connector deep in the mouth, there is none.
        m_isInside =
            std::ranges::all_of(constrained(), [](const Vec3& p) { return p.allFinite(); });
    }
    if (!m_isInside) {
        m_rod.lay(X_AE);
        m_way = {};
    }
    judgeTip(lumen);
}

bool TubeInLumen::isFoundInside(std::span<const Vec3> measured, const Vec3& p_A_tip,
                                const MovedLumen& lumen) const
{
    const AirwayWay which = nearestWay(p_A_tip, lumen, m_isInside);
    const double behindTeeth = placeIn(lumen, which, p_A_tip) - lumen.teeth;
    if (behindTeeth < (m_isInside ? -kLeaves : 0.0))
        return false;
    if (!m_isInside && lumen.way(which).fromMiddles(p_A_tip) > kBeside.si)
        return false;
    const Vec3 p_A_teeth = middleAt(lumen.way(AirwayWay::Trunk), lumen.teeth);
    return std::ranges::any_of(
        measured, [&](const Vec3& p_A) { return (p_A - p_A_teeth).norm() < kBeside.si; });
}

/// @param isHeld a way that it lies in already is given up only for one that is clearly nearer
AirwayWay TubeInLumen::nearestWay(const Vec3& p_A_tip, const MovedLumen& lumen, bool isHeld) const
{
    const auto distanceOf = [&](AirwayWay which) {
        const MovedWay& way = lumen.way(which);
        if (!way.isThere())
            return std::numeric_limits<double>::infinity();
        // Behind the carina there is no trunk.
        if (which == AirwayWay::Trunk && hasMainBronchi(lumen) && isBehind(way, p_A_tip))
            return std::numeric_limits<double>::infinity();
        const double distance = way.fromMiddles(p_A_tip);
        if (!isHeld || which == m_way.which)
            return distance;
        const double fork = std::min(branchOf(lumen, which), m_way.branch);
        return distance + kNearer.si + kNearerEach * std::max(tipOnWay() - fork, 0.0);
    };
    return *std::ranges::min_element(kAllAirwayWays, {}, distanceOf);
}

/// Straight before the connector and its first segment, then evenly bent to the teeth, and on in
/// the middle of the way.
void TubeInLumen::guideAlong(const Vec3& p_A, const Vec3& direction, const MovedLumen& lumen)
{
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    double join = std::max(lumen.teeth - kBeforeTeeth.si, 0.0);
    if ((p_A - middleAt(trunk, lumen.teeth)).norm() < kNearTeeth) {
        std::size_t segment = trunk.nearestSegment(p_A);
        join = std::max(join, trunk.alongAt(p_A, segment) + kLeastInFront);
    }
    const Vec3 p_A_held = p_A + m_rod.along(1) * direction;
    const MovedSection joint = lumen.sectionAt(AirwayWay::Trunk, join);
    std::vector<Vec3> line{p_A - kBeforeConnector * direction, p_A};
    for (const Vec3& point :
         curveBetween(p_A_held, direction, joint.p_A_centre, joint.back.cross(joint.side)))
        line.push_back(point);
    m_guide.clear();
    m_guide.addFree(line);
    const bool isTrunk = m_way.which == AirwayWay::Trunk;
    m_guide.add(walled(joint));
    m_onGuide = {kBeforeConnector, m_guide.length(), std::numeric_limits<double>::infinity(), join};
    addSections(trunk, join + kLeastApart, isTrunk ? trunk.along.back() : m_way.branch - kGoesOver);
    if (isTrunk)
        return;
    m_guide.add(walled(lumen.way(m_way.which).sections.front()));
    m_onGuide.branch = m_guide.length();
    addSections(lumen.way(m_way.which), kLeastApart, lumen.way(m_way.which).along.back());
}

void TubeInLumen::addSections(const MovedWay& way, double from, double until)
{
    for (std::size_t i = 0; i < way.sections.size() && way.along[i] <= until; ++i)
        if (way.along[i] >= from)
            m_guide.add(walled(way.sections[i]));
}

double TubeInLumen::wayAt(double alongGuide) const
{
    if (alongGuide >= m_onGuide.branch)
        return m_way.branch + alongGuide - m_onGuide.branch;
    const double place = m_onGuide.joined + alongGuide - m_onGuide.join;
    return m_way.which == AirwayWay::Trunk ? place : std::min(place, m_way.branch);
}

double TubeInLumen::guideAt(double alongWay) const
{
    if (m_way.which != AirwayWay::Trunk && alongWay >= m_way.branch)
        return m_onGuide.branch + alongWay - m_way.branch;
    return m_onGuide.join + alongWay - m_onGuide.joined;
}

/// Where a tip at a place of the way is stopped, along the way.
double TubeInLumen::stopAhead(double place, const MovedLumen& lumen) const
{
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    // A tip that rests at a stop is there by no more than kAtStop.
    const double from = std::max(place - kAtStop, 0.0);
    double stop = trunk.stopBehind(from);
    if (m_way.which != AirwayWay::Trunk && (from >= m_way.branch || stop >= m_way.branch))
        stop = m_way.branch + lumen.way(m_way.which).stopBehind(std::max(from - m_way.branch, 0.0));
    // It has become too narrow around the tip, which goes no farther.
    return stop <= from ? place : stop;
}

void TubeInLumen::judgeTip(const MovedLumen& lumen)
{
    const double carina = lumen.way(AirwayWay::Trunk).along.back();
    m_tip = {.p_A = m_rod.nodes().back(), .way = m_way.which};
    if (!m_isInside) {
        m_tip.aboveCarina = metres(carina);
        m_tip.pastGlottis = metres(-lumen.glottis);
        return;
    }
    const double place = tipOnWay();
    m_tip.depth = depthAtTeeth(lumen);
    m_tip.isPastTeeth = m_tip.depth > Length{};
    m_tip.isStopped = m_tip.isPastTeeth && heldBack() > kStopped;
    const double beyond = place - m_way.branch - lumen.begins[std::size_t(m_way.which)];
    switch (m_way.which) {
    case AirwayWay::Trunk:
        m_tip.seat = place > lumen.glottis ? TubeSeat::Trachea : TubeSeat::None;
        m_tip.aboveCarina = metres(carina - place);
        break;
    case AirwayWay::RightMain:
    case AirwayWay::LeftMain: {
        const TubeSeat side =
            m_way.which == AirwayWay::RightMain ? TubeSeat::RightMain : TubeSeat::LeftMain;
        m_tip.seat = beyond > 0.0            ? side
                     : place > lumen.glottis ? TubeSeat::Trachea
                                             : TubeSeat::None;
        m_tip.aboveCarina = metres(-beyond);
        break;
    }
    case AirwayWay::Oesophagus:
        m_tip.seat = beyond > 0.0 ? TubeSeat::Oesophagus : TubeSeat::None;
        return;
    }
    m_tip.pastGlottis = metres(carina - lumen.glottis) - m_tip.aboveCarina;
}

Length TubeInLumen::depthAtTeeth(const MovedLumen& lumen) const
{
    double after = 0.0; // of the node behind, beyond the teeth
    for (std::size_t i = kPieces + 1; i-- > 0;) {
        const double beyond = wayAt(m_rod.alongGuide(i)) - lumen.teeth;
        if (beyond <= 0.0) {
            if (i == kPieces)
                return {};
            const double share = after / (after - beyond);
            return metres(m_rod.along(kPieces) - m_rod.along(i + 1) + share * m_rod.along(1));
        }
        after = beyond;
    }
    return metres(m_rod.along(kPieces));
}

} // namespace carina
