#include "engine/airway/tube/elastic_rod.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

// Of the stiffness of a unit of bending, B / l^3: of ours, as all that follow.
constexpr double kWall = 1e3;
constexpr double kStretch = 1e4;
constexpr double kDrag = 0.01; ///< for each step; where it lies in tissue

constexpr double kNearEnough = 1e-5;  ///< metres
constexpr double kMostWay = 0.01;     ///< metres of a node in one step
constexpr double kLost = 0.1;         ///< metres: a way that only a rod that is lost would go
constexpr double kMostBack = 0.5;     ///< of a segment, along the guide
constexpr double kSameLength = 1e-9;  ///< metres
constexpr double kLeastCosine = 0.25; ///< between a rod and its guide
constexpr double kMostSlid = 5e-3;    ///< metres
constexpr int kMostSlides = 6;
constexpr int kMostLost = 3; ///< steps

/// A vector across one direction carried on to another without rotation about it.
Vec3 carried(const Vec3& across, const Vec3& from, const Vec3& to)
{
    return across - across.dot(to) / (1.0 + from.dot(to)) * (from + to);
}

/// Onto the wall of the section, where a place is beyond it.
void putInside(const GuideSection& section, GuidedPlace& place)
{
    const double share = section.isFree ? 0.0 : section.share(place.u, place.v);
    if (share <= 1.0)
        return;
    place.u /= share;
    place.v /= share;
}

} // namespace

ElasticRod::ElasticRod(double stiffness, std::span<const Vec3> p_E_rest)
    : m_stiffness(stiffness),
      m_rest(p_E_rest.begin(), p_E_rest.end()),
      m_turns(m_rest.size()),
      m_walled(m_rest.size(), kWall),
      m_solved(m_rest.size()),
      m_segments(m_rest.size()),
      m_axes(m_rest.size()),
      m_tensions(m_rest.size()),
      m_drawn(m_rest.size())
{
    CARINA_EXPECTS(m_rest.size() >= 4 && stiffness > 0.0);
    double whole = 0.0;
    for (std::size_t i = 0; i + 1 < m_rest.size(); ++i)
        whole += (m_rest[i + 1] - m_rest[i]).norm();
    m_length = whole / double(m_rest.size() - 1);
    // Where it leaves what holds it half a segment bends.
    m_turns[kHeld - 1].stiffness = 2.0;
    setRest(p_E_rest);
    lay({});
}

void ElasticRod::setRest(std::span<const Vec3> p_E_rest)
{
    CARINA_EXPECTS(p_E_rest.size() == m_rest.size());
    std::ranges::copy(p_E_rest, m_rest.begin());
    m_across_E = (m_rest[1] - m_rest[0]).unitOrthogonal();
    carryAxes(m_rest, m_across_E);
    for (std::size_t i = 1; i + 1 < m_rest.size(); ++i) {
        const Vec3 bent = m_rest[i - 1] - 2.0 * m_rest[i] + m_rest[i + 1];
        m_turns[i].byFirst = m_axes[i].first.dot(bent);
        m_turns[i].bySecond = m_axes[i].second.dot(bent);
    }
}

double ElasticRod::perUnit() const { return m_stiffness / std::pow(m_length, 3); }

void ElasticRod::lay(const RigidTransform& X_AE)
{
    m_X_AE = X_AE;
    m_nodes = nodesAtRest();
    m_heldBack = 0.0;
}

std::vector<Vec3> ElasticRod::nodesAtRest(const RigidTransform& X_AE) const
{
    std::vector<Vec3> nodes;
    nodes.reserve(m_rest.size());
    for (const Vec3& p_E : m_rest)
        nodes.push_back(X_AE * p_E);
    return nodes;
}

void ElasticRod::layAlong(const RodHold& hold, std::size_t entry, double entered)
{
    lay(hold.X_AE);
    m_lost = 0;
    std::ranges::fill(m_tensions, 0.0);
    double about = hold.first;
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        GuidedPlace& place = m_walled.nodes[i].place;
        place = i < entry ? hold.guide->placeOf(m_nodes[i], about, m_segments[i])
                          : GuidedPlace{.along = entered + along(i - entry)};
        about = place.along + m_length;
    }
    static_cast<void>(improve(hold, Vec3::Zero()));
    draw(hold);
}

bool ElasticRod::step(const RodHold& hold, const Vec3& f_A_tip)
{
    m_X_AE = hold.X_AE;
    if (!(improve(hold, f_A_tip / perUnit()) < kLost))
        return false;
    m_lost = isFolded() ? m_lost + 1 : 0;
    if (m_lost > 0)
        beginAsDrawn();
    draw(hold);
    return m_lost < kMostLost
           && std::ranges::all_of(m_nodes, [](const Vec3& p) { return p.allFinite(); });
}

/// The solution is folded. What was drawn lies in the sections and is as long as it should be: it
/// goes on from there, taken along with what holds it.
void ElasticRod::beginAsDrawn()
{
    std::ranges::fill(m_tensions, 0.0);
    for (std::size_t i = 0; i < m_nodes.size(); ++i)
        m_walled.nodes[i].place = m_drawn[i];
}

/// Whether it comes back along its guide.
bool ElasticRod::isFolded() const
{
    for (std::size_t i = kHeld; i < m_nodes.size(); ++i)
        if (!(m_walled.nodes[i].place.along
              > m_walled.nodes[i - 1].place.along - kMostBack * m_length))
            return true;
    return false;
}

/// @param load in units of B / l^3
/// @returns the farthest way that a node should go, metres
double ElasticRod::improve(const RodHold& hold, const Vec3& load)
{
    place(hold);
    carryAxes(m_solved, m_X_AE.rotation() * m_across_E);
    for (BandedSystem::Row& row : m_walled.system.rows)
        row = {};
    addBending(hold.inFreeSpace);
    addTension();
    addDrag();
    m_walled.system.rows.back().right += load;
    if (!m_walled.find(kHeld, kNearEnough))
        return std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const Vec3& way : m_walled.ways())
        most = std::max(most, way.norm());
    const double share = std::min(1.0, kMostWay / most);
    if (share == 1.0 && m_walled.isLeast())
        takeTension();
    for (std::size_t i = kHeld; i < m_nodes.size(); ++i)
        go(i, share * m_walled.ways()[i], *hold.guide);
    holdBack(hold.stop);
    return most;
}

/// In the section of where it was, and then in that where it comes to.
void ElasticRod::go(std::size_t i, const Vec3& way, const RodGuide& guide)
{
    auto& [section, slope, across, place] = m_walled.nodes[i];
    place = moved(section, slope, place, way);
    const GuideSection there = guide.at(place.along, m_segments[i]);
    const Vec3 left = m_solved[i] + way - there.at(place.u, place.v);
    place = moved(there, guide.slope(m_segments[i], place), place, left);
}

/// Where the nodes are, by their places along the guide. The first ones are held.
void ElasticRod::place(const RodHold& hold)
{
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        auto& [section, slope, across, place] = m_walled.nodes[i];
        if (i < kHeld)
            place = {.along = hold.first - m_heldBack + along(i)};
        section = hold.guide->at(place.along, m_segments[i]);
        slope = hold.guide->slope(m_segments[i], place);
        across = acrossGuide(section, slope);
        m_solved[i] = section.at(place.u, place.v);
    }
}

/// The two axes across the rod at each node but the first and the last.
/// @param across the first segment
void ElasticRod::carryAxes(std::span<const Vec3> nodes, const Vec3& across)
{
    Vec3 before = (nodes[1] - nodes[0]).normalized();
    Vec3 axis = (across - across.dot(before) * before).normalized();
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
        const Vec3 after = (nodes[i + 1] - nodes[i]).normalized();
        const Vec3 middle = (before + after).normalized();
        const Vec3 first = carried(axis, before, middle);
        m_axes[i] = {first, middle.cross(first)};
        axis = carried(first, middle, after);
        before = after;
    }
}

/// In A, across the rod: by how much it bends otherwise than at rest.
Vec3 ElasticRod::bentBeyondRest(std::size_t node) const
{
    const auto& [first, second] = m_axes[node];
    const Vec3 bent = m_solved[node - 1] - 2.0 * m_solved[node] + m_solved[node + 1];
    return (first.dot(bent) - m_turns[node].byFirst) * first
           + (second.dot(bent) - m_turns[node].bySecond) * second;
}

void ElasticRod::addBending(double inFreeSpace)
{
    std::vector<BandedSystem::Row>& rows = m_walled.system.rows;
    for (std::size_t i = 1; i + 1 < m_solved.size(); ++i) {
        const auto& [first, second] = m_axes[i];
        const double stiffness =
            m_turns[i].stiffness * (m_walled.nodes[i].section.isFree ? inFreeSpace : 1.0);
        const Mat3 stiff = stiffness * (first * first.transpose() + second * second.transpose());
        const Vec3 beyond = stiffness * bentBeyondRest(i);
        rows[i - 1].diagonal += stiff;
        rows[i].diagonal += 4.0 * stiff;
        rows[i + 1].diagonal += stiff;
        rows[i].before -= 2.0 * stiff;
        rows[i + 1].before -= 2.0 * stiff;
        rows[i + 1].secondBefore += stiff;
        rows[i - 1].right -= beyond;
        rows[i].right += 2.0 * beyond;
        rows[i + 1].right -= beyond;
    }
}

/// Compression, with which the matrix would not always be positive definite, is left out of that.
void ElasticRod::addTension()
{
    std::vector<BandedSystem::Row>& rows = m_walled.system.rows;
    for (std::size_t i = 1; i + 1 < m_solved.size(); ++i) {
        const Vec3 segment = m_solved[i + 1] - m_solved[i];
        const double length = segment.norm();
        const Vec3 t = segment / length;
        const Vec3 pull = (kStretch * (length - m_length) + m_tensions[i]) * t;
        const double across = std::max(m_tensions[i], 0.0) / length;
        const Mat3 stiff = (kStretch - across) * (t * t.transpose()) + across * Mat3::Identity();
        rows[i].diagonal += stiff;
        rows[i + 1].diagonal += stiff;
        rows[i + 1].before -= stiff;
        rows[i].right += pull;
        rows[i + 1].right -= pull;
    }
}

/// Only across the guide: what is pushed on goes on.
void ElasticRod::addDrag()
{
    for (std::size_t i = kHeld; i < m_nodes.size(); ++i) {
        const WalledWays::Node& node = m_walled.nodes[i];
        if (node.section.isFree)
            continue;
        const Vec3 t = node.slope.normalized();
        m_walled.system.rows[i].diagonal += kDrag * (Mat3::Identity() - t * t.transpose());
    }
}

/// The multipliers by which the lengths are kept with the ways that were found.
void ElasticRod::takeTension()
{
    const std::span<const Vec3> ways = m_walled.ways();
    for (std::size_t i = 1; i + 1 < m_solved.size(); ++i) {
        const Vec3 segment = m_solved[i + 1] - m_solved[i];
        const double length = segment.norm();
        m_tensions[i] +=
            kStretch * (length - m_length + segment.dot(ways[i + 1] - ways[i]) / length);
    }
}

void ElasticRod::holdBack(double stop)
{
    const double beyond = m_walled.nodes.back().place.along - stop;
    const double on = std::min(std::min(m_heldBack, -beyond), kMostOn);
    m_heldBack -= on;
    for (WalledWays::Node& node : m_walled.nodes)
        node.place.along += on;
}

/// As it is drawn: inside of the sections, and exactly as long as it is.
void ElasticRod::draw(const RodHold& hold)
{
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        const GuidedPlace& solved = m_walled.nodes[i].place;
        GuidedPlace& drawn = m_drawn[i];
        if (i < kHeld) {
            drawn = {.along = hold.first - m_heldBack + along(i)};
            m_nodes[i] = hold.guide->at(drawn.along, m_segments[i]).p_A_centre;
            continue;
        }
        drawn.along =
            std::clamp(m_drawn[i - 1].along + solved.along - m_walled.nodes[i - 1].place.along,
                       solved.along - kMostSlid, solved.along + kMostSlid);
        for (int slide = 0; slide < kMostSlides; ++slide) {
            const GuideSection section = hold.guide->at(drawn.along, m_segments[i]);
            drawn.u = solved.u;
            drawn.v = solved.v;
            putInside(section, drawn);
            m_nodes[i] = section.at(drawn.u, drawn.v);
            const Vec3 segment = m_nodes[i] - m_nodes[i - 1];
            const double length = segment.norm();
            if (std::abs(length - m_length) < kSameLength)
                break;
            const double cosine = segment.dot(hold.guide->slope(m_segments[i], drawn)) / length;
            drawn.along += (m_length - length) / std::max(cosine, kLeastCosine);
            // Where it goes across its guide, that would lead ever farther away.
            drawn.along =
                std::clamp(drawn.along, solved.along - kMostSlid, solved.along + kMostSlid);
            if (slide + 1 == kMostSlides) // its length counts
                m_nodes[i] = m_nodes[i - 1] + m_length / length * segment;
        }
    }
}

} // namespace carina
