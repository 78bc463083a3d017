#include "engine/airway/tube/tube_in_lumen.h"

#include "engine/airway/tube/tube_shape_code.h"
#include "engine/core/expects.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
namespace
{

constexpr Length kBeside = millimetres(30.0); ///< of ours
constexpr double kGoesOver = 0.06;            ///< metres behind the teeth: of ours
constexpr int kRoundsToRest = 4;
constexpr double kJustBeyond = 1e-4; ///< metres
constexpr double kAtStop = 1e-3;     ///< metres before a stop from which a tip is said to be there

/// The place at a length along the centre of a way, and beyond its end on in its direction.
Vec3 centreAt(const MovedWay& way, double along)
{
    const auto after = std::ranges::upper_bound(way.along, along);
    const auto i = std::size_t(std::clamp<std::ptrdiff_t>(after - way.along.begin(), 1,
                                                          std::ptrdiff_t(way.along.size()) - 1));
    const Vec3& a = way.sections[i - 1].p_A_centre;
    const Vec3& b = way.sections[i].p_A_centre;
    return a + (along - way.along[i - 1]) / (way.along[i] - way.along[i - 1]) * (b - a);
}

/// The centre line of the trunk up to where a way branches off, and that of the way.
MovedWay throughTrunk(const MovedLumen& lumen, AirwayWay which)
{
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    if (which == AirwayWay::Trunk)
        return trunk;
    const MovedWay& branch = lumen.way(which);
    std::size_t segment = trunk.nearestSegment(branch.sections.front().p_A_centre);
    MovedWay whole;
    const double until = trunk.alongAt(branch.sections.front().p_A_centre, segment);
    for (std::size_t i = 0; i < trunk.sections.size() && trunk.along[i] < until - 1e-3; ++i) {
        whole.sections.push_back(trunk.sections[i]);
        whole.along.push_back(trunk.along[i]);
    }
    for (std::size_t i = 0; i < branch.sections.size(); ++i) {
        whole.sections.push_back(branch.sections[i]);
        whole.along.push_back(until + branch.along[i]);
    }
    return whole;
}

} // namespace

WallTouch TubeInLumen::Walls::at(std::size_t node, const Vec3& p_A) const
{
    if (node < m_firstInside)
        return {};
    Node& it = m_nodes[node];
    if (node + 1 < m_nodes.size())
        return it.piece.touch(p_A);
    return m_lumen->touchIn(it.way, stop(it.way), p_A, it.segment);
}

/// The way beyond whose wall a place lies least; while it is inside of one, that is kept.
TubeInLumen::Walls::Node TubeInLumen::Walls::chosen(const Vec3& p_A) const
{
    Node best;
    double least = std::numeric_limits<double>::infinity();
    for (const AirwayWay which : kAllAirwayWays) {
        const MovedWay& way = m_lumen->way(which);
        if (!way.isThere())
            continue;
        Node there{which, way.nearestSegment(p_A), {}};
        if (which != AirwayWay::Trunk && way.alongAt(p_A, there.segment) <= 0.0)
            continue;
        const double depth = m_lumen->touchIn(which, stop(which), p_A, there.segment).depth;
        if (depth < least) {
            least = depth;
            best = there;
        }
    }
    return best;
}

bool TubeInLumen::Walls::isInFront(const Vec3& p_A, Node node) const
{
    return node.way == AirwayWay::Trunk && m_lumen->way(node.way).alongAt(p_A, node.segment) <= 0.0;
}

/// The first node that is inside, from the tip back to the mouth.
std::size_t TubeInLumen::Walls::entered(std::span<const Vec3> nodes)
{
    const std::size_t tip = nodes.size() - 1;
    const bool wasInside = m_firstInside <= tip;
    m_nodes[tip] = chosen(nodes[tip]);
    const Node& there = m_nodes[tip];
    std::size_t segment = there.segment;
    const double depth = m_lumen->touchIn(there.way, stop(there.way), nodes[tip], segment).depth;
    const bool isInFunnel =
        there.way == AirwayWay::Trunk
        && m_lumen->way(there.way).alongAt(nodes[tip], segment) < m_lumen->teeth + kCaught.si;
    if (isInFront(nodes[tip], there) || (!wasInside && !(isInFunnel && depth < kCaught.si)))
        return nodes.size();
    std::size_t first = tip;
    while (first > 0) {
        const std::size_t i = first - 1;
        segment = m_nodes[i].segment;
        const bool isKnown =
            m_isKnown && i >= m_firstInside && m_lumen->way(m_nodes[i].way).isThere();
        if (!isKnown
            || m_lumen->touchIn(m_nodes[i].way, stop(m_nodes[i].way), nodes[i], segment).depth
                   > 0.0)
            m_nodes[i] = chosen(nodes[i]);
        if (isInFront(nodes[i], m_nodes[i]))
            break;
        first = i;
    }
    return first;
}

void TubeInLumen::Walls::takeIn(std::size_t first)
{
    m_nodes.clear();
    m_firstInside = first;
}

void TubeInLumen::Walls::choose(const MovedLumen& lumen, std::span<const Vec3> nodes)
{
    m_lumen = &lumen;
    m_isKnown = !m_nodes.empty();
    m_nodes.resize(nodes.size());
    const auto before = m_stops;
    for (std::size_t w = 0; w < kAirwayWays; ++w)
        m_stops[w] = lumen.ways[w].isThere() ? lumen.ways[w].along.back() : 0.0;
    m_firstInside = entered(nodes);
    for (std::size_t i = m_firstInside; i + 1 < nodes.size(); ++i) {
        Node& node = m_nodes[i];
        const double along = lumen.way(node.way).alongAt(nodes[i], node.segment);
        node.piece = lumen.pieceAt(node.way, node.segment, along);
    }
    // Ahead of the tip each way ends where it is too narrow.
    Node& tip = m_nodes.back();
    const double place = lumen.way(tip.way).alongAt(nodes.back(), tip.segment);
    for (const AirwayWay which : kAllAirwayWays) {
        const bool isPassed = which == AirwayWay::Trunk && tip.way != AirwayWay::Trunk;
        if (lumen.way(which).isThere() && !isPassed)
            m_stops[std::size_t(which)] = which == tip.way
                                              ? stopAhead(which, place, before[std::size_t(which)])
                                              : lumen.way(which).stopBehind(0.0);
    }
}

/// A tip that presses on a stop is a little beyond it, and has not passed it.
double TubeInLumen::Walls::stopAhead(AirwayWay which, double place, double before) const
{
    const MovedSection beyond = m_lumen->sectionAt(which, before + kJustBeyond);
    const bool isPressed = place > before && place < before + 2.0 * kAtStop;
    return isPressed && beyond.spare + beyond.give < 0.0 ? before
                                                         : m_lumen->way(which).stopBehind(place);
}

TubeInLumen::TubeInLumen(const TubeSize& size, std::span<const Vec3> p_E_rest)
    : m_size(size), m_rod(RodMaterial{.stiffness = size.stiffness}, inPieces(p_E_rest, kPieces))
{
}

void TubeInLumen::step(const RigidTransform& X_AE, const MovedLumen& lumen)
{
    CARINA_EXPECTS(lumen.way(AirwayWay::Trunk).isThere());
    const double way = (X_AE.translation() - m_X_AE.translation()).norm();
    const Angle turn = angleBetween(X_AE.rotation(), m_X_AE.rotation());
    const double parts = std::max(std::ceil(std::max(way / kMostAtOnce.si, turn / kMostTurn)), 1.0);
    if (!m_hasBegun || parts > kMostParts || outside() > kLost) {
        layAnew(X_AE, lumen);
        relax(X_AE, lumen);
    } else {
        for (int i = 1; i <= int(parts); ++i)
            relax(interpolate(m_X_AE, X_AE, i / parts), lumen);
    }
    if (isFoundInside(lumen)) {
        layAnew(X_AE, lumen);
        relax(X_AE, lumen);
    }
    m_X_AE = X_AE;
    m_hasBegun = true;
    judgeTip(lumen);
}

void TubeInLumen::relax(const RigidTransform& X_AE, const MovedLumen& lumen)
{
    m_walls.choose(lumen, m_rod.nodes());
    m_rod.stiffenBefore(m_walls.firstInside(), kHeldByHand);
    m_rod.step(X_AE, m_walls);
}

/// Whether a tube that came in beside the funnel lies in the airway, from the teeth to its tip.
bool TubeInLumen::isFoundInside(const MovedLumen& lumen) const
{
    const std::span<const Vec3> nodes = m_rod.nodes();
    if (m_walls.firstInside() < nodes.size())
        return false;
    const Walls::Node& tip = m_walls.node(nodes.size() - 1);
    const MovedWay& way = lumen.way(tip.way);
    std::size_t segment = tip.segment;
    const bool isInside =
        lumen.touchIn(tip.way, way.along.back(), nodes.back(), segment).depth < 0.0;
    const bool isPastTeeth = tip.way != AirwayWay::Trunk
                             || way.alongAt(nodes.back(), segment) > lumen.teeth + kCaught.si;
    return isInside && isPastTeeth && passesTeeth(nodes, lumen);
}

bool TubeInLumen::passesTeeth(std::span<const Vec3> nodes, const MovedLumen& lumen)
{
    const Vec3 p_A_teeth = centreAt(lumen.way(AirwayWay::Trunk), lumen.teeth);
    return std::ranges::any_of(
        nodes, [&](const Vec3& p_A) { return (p_A - p_A_teeth).norm() < kBeside.si; });
}

void TubeInLumen::layAnew(const RigidTransform& X_AE, const MovedLumen& lumen)
{
    m_rod.lay(X_AE);
    m_walls.takeIn(m_rod.nodes().size());
    const std::vector<Vec3> rest = m_rod.nodesAtRest();
    // The way whose middle is nearest to the measured tip, of those that lead there.
    const AirwayWay which = *std::ranges::min_element(kAllAirwayWays, {}, [&](AirwayWay w) {
        const MovedWay& way = lumen.way(w);
        if (!way.isThere())
            return std::numeric_limits<double>::infinity();
        std::size_t segment = way.nearestSegment(rest.back());
        return (centreAt(way, way.alongAt(rest.back(), segment)) - rest.back()).norm();
    });
    const MovedWay path = throughTrunk(lumen, which);
    const Vec3 p_A_teeth = centreAt(path, lumen.teeth);
    std::size_t segment = path.nearestSegment(rest.back());
    const double place = path.alongAt(rest.back(), segment);
    // A tip that is far from the airway is beside the body.
    if (place <= lumen.teeth || !passesTeeth(rest, lumen)
        || (centreAt(path, place) - rest.back()).norm() > kBeside.si)
        return;
    const auto nearest = std::ranges::min_element(
        rest, {}, [&](const Vec3& p_A) { return (p_A - p_A_teeth).squaredNorm(); });
    layAlong(path, lumen, std::max(std::size_t(nearest - rest.begin()), ElasticRod::kHeld), X_AE);
}

/// From one node on in the middle of a way, to which it goes over from where it is at rest; then it
/// comes to rest in the lumen.
void TubeInLumen::layAlong(const MovedWay& path, const MovedLumen& lumen, std::size_t entry,
                           const RigidTransform& X_AE)
{
    std::vector<Vec3> nodes = m_rod.nodesAtRest();
    const Vec3 beside = nodes[entry] - centreAt(path, lumen.teeth);
    for (std::size_t i = entry; i < nodes.size(); ++i) {
        const double inside = m_rod.along(i) - m_rod.along(entry);
        const double share = std::max(1.0 - inside / kGoesOver, 0.0);
        nodes[i] =
            centreAt(path, lumen.teeth + inside) + share * share * (3.0 - 2.0 * share) * beside;
    }
    m_rod.lay(X_AE, nodes);
    m_walls.takeIn(entry);
    for (int i = 0; i < kRoundsToRest; ++i) {
        m_walls.choose(lumen, m_rod.nodes());
        m_rod.stiffenBefore(m_walls.firstInside(), kHeldByHand);
        m_rod.comeToRest(m_walls);
    }
}

Length TubeInLumen::depthAtTeeth(const MovedLumen& lumen) const
{
    const std::span<const Vec3> nodes = m_rod.nodes();
    const MovedWay& trunk = lumen.way(AirwayWay::Trunk);
    if (m_walls.firstInside() >= nodes.size())
        return {};
    double after = 0.0; // of the node behind, beyond the teeth
    for (std::size_t i = nodes.size(); i-- > 0;) {
        const Walls::Node& node = m_walls.node(i);
        if (node.way != AirwayWay::Trunk)
            continue;
        std::size_t segment = node.segment;
        const double beyond = trunk.alongAt(nodes[i], segment) - lumen.teeth;
        if (beyond <= 0.0 && i + 1 == nodes.size())
            return {};
        if (beyond <= 0.0) {
            const double share = after > beyond ? after / (after - beyond) : 0.0;
            return along(nodes.size() - 1) - along(i + 1) + share * (along(i + 1) - along(i));
        }
        after = beyond;
    }
    return along(nodes.size() - 1);
}

void TubeInLumen::judgeTip(const MovedLumen& lumen)
{
    const std::size_t last = m_rod.nodes().size() - 1;
    Walls::Node node = m_walls.node(last);
    m_tip = {.p_A = m_rod.nodes().back(), .way = node.way};
    if (m_walls.firstInside() > last) {
        m_tip.way = AirwayWay::Trunk;
        m_tip.aboveCarina = metres(lumen.way(AirwayWay::Trunk).along.back());
        m_tip.pastGlottis = metres(-lumen.glottis);
        return;
    }
    const double place = lumen.way(node.way).alongAt(m_tip.p_A, node.segment);
    m_tip.depth = depthAtTeeth(lumen);
    m_tip.isPastTeeth = m_tip.depth > Length{};
    m_tip.isStopped =
        m_tip.isPastTeeth && m_rod.force(last) > 0.0 && place > m_walls.stop(node.way) - kAtStop;
    const double carina = lumen.way(AirwayWay::Trunk).along.back();
    const double beyond = place - lumen.begins[std::size_t(node.way)];
    switch (node.way) {
    case AirwayWay::Trunk:
        m_tip.seat = place > lumen.glottis ? TubeSeat::Trachea : TubeSeat::None;
        m_tip.aboveCarina = metres(carina - place);
        break;
    case AirwayWay::RightMain:
    case AirwayWay::LeftMain: {
        const TubeSeat side =
            node.way == AirwayWay::RightMain ? TubeSeat::RightMain : TubeSeat::LeftMain;
        m_tip.seat = beyond > 0.0 ? side : TubeSeat::Trachea;
        m_tip.aboveCarina = metres(-beyond);
        break;
    }
    case AirwayWay::Oesophagus:
        m_tip.seat = beyond > 0.0 ? TubeSeat::Oesophagus : TubeSeat::None;
        return;
    }
    m_tip.pastGlottis = metres(carina - lumen.glottis) - m_tip.aboveCarina;
}

std::vector<TubeContact> TubeInLumen::contacts() const
{
    std::vector<TubeContact> contacts;
    for (std::size_t i = 0; i < m_rod.nodes().size(); ++i)
        if (const double force = m_rod.force(i); force > 0.0)
            contacts.push_back({.along = along(i),
                                .p_A = m_rod.nodes()[i],
                                .out_A = m_rod.touches()[i].out.normalized(),
                                .force = newtons(force)});
    return contacts;
}

Length TubeInLumen::apart() const
{
    return metres((m_rod.nodes().back() - m_rod.nodesAtRest().back()).norm());
}

Length TubeInLumen::farthestApart() const
{
    const std::vector<Vec3> rest = m_rod.nodesAtRest();
    double most = 0.0;
    for (std::size_t i = 0; i < rest.size(); ++i)
        most = std::max(most, (m_rod.nodes()[i] - rest[i]).norm());
    return metres(most);
}

Length TubeInLumen::outside() const
{
    const auto deepest = std::ranges::max_element(m_rod.touches(), {}, &WallTouch::depth);
    return metres(std::max(deepest->depth, 0.0));
}

} // namespace carina
