#include "engine/airway/tube/elastic_rod.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kMostImprovements = 8;
constexpr double kAtRest = 2e-6;     ///< metres: a smaller improvement is the last
constexpr double kMostAtOnce = 8e-3; ///< metres that a node moves in one of Newton's steps
constexpr double kSufficient = 1e-4; ///< of the fall that the gradient promises (Armijo)
constexpr int kMostHalvings = 6;

/// v as it goes along from one unit direction to another by the least rotation.
Vec3 carried(const Vec3& v, const Vec3& from, const Vec3& to)
{
    const Vec3 axis = from.cross(to);
    const double cosine = std::max(from.dot(to), -0.999);
    const Vec3 turned = axis.cross(v);
    return v + turned + axis.cross(turned) / (1.0 + cosine);
}

/// The rotation by an angle about a unit axis.
Mat3 turnAbout(const Vec3& axis, double cosine, double sine)
{
    Mat3 cross;
    cross << 0.0, -axis.z(), axis.y(), axis.z(), 0.0, -axis.x(), -axis.y(), axis.x(), 0.0;
    return cosine * Mat3::Identity() + sine * cross + (1.0 - cosine) * axis * axis.transpose();
}

} // namespace

ElasticRod::ElasticRod(const RodMaterial& material, std::span<const Vec3> p_E_rest)
    : m_material(material), m_rest(p_E_rest.begin(), p_E_rest.end())
{
    CARINA_EXPECTS(m_rest.size() >= 4 && material.stiffness > 0.0);
    m_along = {0.0};
    std::vector<Vec3> tangents;
    for (std::size_t i = 0; i + 1 < m_rest.size(); ++i) {
        const Vec3 step = m_rest[i + 1] - m_rest[i];
        m_lengths.push_back(step.norm());
        CARINA_EXPECTS(m_lengths.back() > 0.0);
        m_along.push_back(m_along.back() + m_lengths.back());
        tangents.push_back(step / m_lengths.back());
    }
    m_firstAcross_E = tangents.front().unitOrthogonal();
    Vec3 across = m_firstAcross_E;
    for (std::size_t i = 0; i + 1 < tangents.size(); ++i) {
        const Vec3& t = tangents[i];
        const Vec3 axis = t.cross(tangents[i + 1]);
        const double sine = axis.norm();
        Turn turn;
        turn.cosine = t.dot(tangents[i + 1]);
        turn.sine = sine;
        if (sine > 1e-12) {
            turn.across = axis.dot(across) / sine;
            turn.aside = axis.dot(t.cross(across)) / sine;
        } else {
            turn.across = 1.0;
        }
        // The first segment is held: of what bends there only the half in the second one does.
        const double length = 0.5 * ((i > 0 ? m_lengths[i] : 0.0) + m_lengths[i + 1]);
        turn.perLength = material.stiffness / length;
        m_turnsAtRest.push_back(turn);
        m_stiffness.push_back(turn.perLength);
        across = carried(across, t, tangents[i + 1]);
    }
    const std::size_t count = m_rest.size();
    m_turns.resize(m_turnsAtRest.size());
    m_axes.resize(m_turnsAtRest.size());
    m_torques.resize(m_turnsAtRest.size());
    m_twist.resize(count);
    m_touches.resize(count);
    m_trialTouches.resize(count);
    m_normals.resize(count);
    m_grips.resize(count);
    lay(RigidTransform{});
}

std::vector<Vec3> ElasticRod::nodesAtRest() const
{
    std::vector<Vec3> nodes;
    for (const Vec3& p_E : m_rest)
        nodes.push_back(m_X_AE * p_E);
    return nodes;
}

void ElasticRod::lay(const RigidTransform& X_AE)
{
    m_X_AE = X_AE;
    lay(X_AE, nodesAtRest());
}

void ElasticRod::lay(const RigidTransform& X_AE, std::span<const Vec3> p_A)
{
    CARINA_EXPECTS(p_A.size() == m_rest.size());
    m_X_AE = X_AE;
    m_nodes.assign(p_A.begin(), p_A.end());
    m_before = m_nodes;
    m_start = m_nodes;
    m_ways.assign(m_nodes.size(), Vec3::Zero());
    m_trial = m_nodes;
    std::ranges::fill(m_touches, WallTouch{});
    std::ranges::fill(m_torques, 0.0);
    carryFrames();
}

void ElasticRod::stiffenBefore(std::size_t node, double factor)
{
    for (std::size_t i = 0; i < m_turns.size(); ++i)
        m_stiffness[i] = (i + 1 < node ? factor : 1.0) * m_turnsAtRest[i].perLength;
}

void ElasticRod::step(const RigidTransform& X_AE, const RodWall& wall, const Vec3& f_A_tip)
{
    m_X_AE = X_AE;
    m_load = f_A_tip;
    m_before = m_nodes;
    for (std::size_t i = 0; i < kHeld; ++i)
        m_nodes[i] = X_AE * m_rest[i];
    m_start = m_nodes;
    grip();
    carryFrames();
    holdTwist();
    addBending();
    const double before = sumOf(m_nodes, wall, m_touches);
    m_sum = before + twisting(m_nodes);
    foresee(wall);
    for (int i = 0; i < kMostImprovements && improve(wall) > kAtRest; ++i) {}
    settle(wall, before);
    for (std::size_t i = 0; i < m_nodes.size(); ++i)
        m_ways[i] = m_nodes[i] - m_before[i];
}

void ElasticRod::foresee(const RodWall& wall)
{
    for (std::size_t i = kHeld; i < m_nodes.size(); ++i)
        m_trial[i] = m_nodes[i] + m_ways[i];
    std::ranges::copy_n(m_nodes.begin(), kHeld, m_trial.begin());
    const double sum = sumOf(m_trial, wall, m_trialTouches) + twisting(m_trial);
    if (sum >= m_sum)
        return;
    m_nodes.swap(m_trial);
    m_touches.swap(m_trialTouches);
    m_sum = sum;
}

void ElasticRod::settle(const RodWall& wall, double before)
{
    for (int halving = 0; halving < kMostHalvings; ++halving) {
        carryFrames();
        if (sumOf(m_nodes, wall, m_touches) <= before)
            return;
        for (std::size_t i = kHeld; i < m_nodes.size(); ++i)
            m_nodes[i] = 0.5 * (m_nodes[i] + m_start[i]);
    }
    m_nodes = m_start;
    carryFrames();
    static_cast<void>(sumOf(m_nodes, wall, m_touches));
}

double ElasticRod::force(std::size_t node) const
{
    const WallTouch& touch = m_touches[node];
    return touch.depth > 0.0
               ? kWallToBending * m_material.stiffness * touch.depth * touch.out.norm()
               : 0.0;
}

double ElasticRod::energy() const { return bending(m_nodes) + stretching(m_nodes); }

/// What was touched before the step holds on to the nodes during it.
void ElasticRod::grip()
{
    for (std::size_t i = 0; i < m_nodes.size(); ++i) {
        const double pressure = force(i);
        m_grips[i] = m_material.friction * pressure;
        m_normals[i] = pressure > 0.0 ? Vec3{m_touches[i].out.normalized()} : Vec3{Vec3::Zero()};
    }
}

void ElasticRod::carryFrames()
{
    Vec3 across = m_X_AE.rotation() * m_firstAcross_E;
    Vec3 t = (m_nodes[1] - m_nodes[0]).normalized();
    for (std::size_t i = 0; i < m_turns.size(); ++i) {
        const Turn& rest = m_turnsAtRest[i];
        const Vec3 axis = rest.across * across + rest.aside * t.cross(across);
        m_axes[i] = axis;
        m_turns[i] = turnAbout(axis, rest.cosine, rest.sine);
        const Vec3 next = (m_nodes[i + 2] - m_nodes[i + 1]).normalized();
        across = carried(across, t, next);
        across = (across - across.dot(next) * next).normalized();
        t = next;
    }
}

/// A turn's energy changes as its frame is turned about the segment before it, and that is turned
/// by what the nodes before it do.
void ElasticRod::holdTwist()
{
    std::ranges::fill(m_twist, Vec3{Vec3::Zero()});
    double torque = 0.0; // of all turns behind
    for (std::size_t i = m_turns.size(); i-- > 0;) {
        const Vec3 t = (m_nodes[i + 1] - m_nodes[i]).normalized();
        const Vec3 next = (m_nodes[i + 2] - m_nodes[i + 1]).normalized();
        const Vec3 bend = t.cross(next) / std::max(1.0 + t.dot(next), 1e-3);
        m_torques[i] = 0.5 * (m_torques[i] + torque);
        const Vec3 first = m_torques[i] / m_lengths[i] * bend;
        const Vec3 second = m_torques[i] / m_lengths[i + 1] * bend;
        m_twist[i] += first;
        m_twist[i + 1] += second - first;
        m_twist[i + 2] -= second;
        const Turn& rest = m_turnsAtRest[i];
        torque -= m_stiffness[i] * rest.sine * next.dot(m_axes[i]);
    }
}

double ElasticRod::twisting(std::span<const Vec3> nodes) const
{
    double sum = 0.0;
    for (std::size_t i = kHeld; i < nodes.size(); ++i)
        sum += m_twist[i].dot(nodes[i] - m_start[i]);
    return sum;
}

void ElasticRod::add(BandedSystem<8>& system, std::size_t row, std::size_t column,
                     const Mat3& block) const
{
    if (column < kHeld)
        return;
    const std::size_t r = 3 * (row - kHeld);
    const std::size_t c = 3 * (column - kHeld);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < (row == column ? i + 1 : 3); ++j)
            system.at(r + i, c + j) += block(Eigen::Index(i), Eigen::Index(j));
}

void ElasticRod::push(std::size_t node, const Vec3& gradient)
{
    if (node < kHeld)
        return;
    for (std::size_t i = 0; i < 3; ++i)
        m_system.right[3 * (node - kHeld) + i] -= gradient[Eigen::Index(i)];
}

/// The second derivatives of the bending.
void ElasticRod::addBending()
{
    m_bending.clear(3 * (m_nodes.size() - kHeld));
    for (std::size_t i = 0; i < m_turns.size(); ++i) {
        const Mat3& R = m_turns[i];
        const double w = m_stiffness[i];
        const double a = 1.0 / m_lengths[i];
        const double b = 1.0 / m_lengths[i + 1];
        const Mat3 one = Mat3::Identity();
        add(m_bending, i + 2, i + 2, w * b * b * one);
        add(m_bending, i + 2, i + 1, -w * b * (b * one + a * R));
        add(m_bending, i + 2, i, w * a * b * R);
        add(m_bending, i + 1, i + 1, w * ((a * a + b * b) * one + a * b * (R + R.transpose())));
        add(m_bending, i + 1, i, -w * a * (b * R + a * one));
        if (i >= kHeld)
            add(m_bending, i, i, w * a * a * one);
    }
}

double ElasticRod::bending(std::span<const Vec3> nodes) const
{
    double sum = 0.0;
    Vec3 t = (nodes[1] - nodes[0]) / m_lengths[0];
    for (std::size_t i = 0; i < m_turns.size(); ++i) {
        const Vec3 next = (nodes[i + 2] - nodes[i + 1]) / m_lengths[i + 1];
        sum += 0.5 * m_stiffness[i] * (next - m_turns[i] * t).squaredNorm();
        t = next;
    }
    return sum;
}

double ElasticRod::stretching(std::span<const Vec3> nodes) const
{
    double sum = 0.0;
    for (std::size_t i = 1; i < m_lengths.size(); ++i) {
        const double over = (nodes[i + 1] - nodes[i]).norm() - m_lengths[i];
        sum += 0.5 * over * over / m_lengths[i];
    }
    return kStretchToBending * m_material.stiffness * sum;
}

Vec3 ElasticRod::slide(std::size_t node, const Vec3& p) const
{
    const Vec3 way = p - m_before[node];
    return way - way.dot(m_normals[node]) * m_normals[node];
}

double ElasticRod::sumOf(std::span<const Vec3> nodes, const RodWall& wall,
                         std::vector<WallTouch>& touches) const
{
    double walls = 0.0;
    double friction = 0.0;
    for (std::size_t i = kHeld; i < nodes.size(); ++i) {
        touches[i] = wall.at(i, nodes[i]);
        const double depth = std::max(touches[i].depth, 0.0);
        walls += 0.5 * depth * depth;
        if (m_grips[i] > 0.0)
            friction += m_grips[i]
                        * std::sqrt(slide(i, nodes[i]).squaredNorm() + kFrictionWay * kFrictionWay);
    }
    return bending(nodes) + stretching(nodes) + kWallToBending * m_material.stiffness * walls
           + friction - m_load.dot(nodes.back());
}

void ElasticRod::lineariseSegment(std::size_t segment)
{
    const Vec3 step = m_nodes[segment + 1] - m_nodes[segment];
    const double length = step.norm();
    const Vec3 t = step / length;
    const double k = kStretchToBending * m_material.stiffness / m_lengths[segment];
    const double tension = k * (length - m_lengths[segment]);
    const Mat3 along = t * t.transpose();
    const Mat3 block = k * along + std::max(tension / length, 0.0) * (Mat3::Identity() - along);
    add(m_system, segment + 1, segment + 1, block);
    add(m_system, segment + 1, segment, -block);
    if (segment >= kHeld)
        add(m_system, segment, segment, block);
    push(segment + 1, tension * t);
    push(segment, -tension * t);
}

void ElasticRod::lineariseTouch(std::size_t node)
{
    const WallTouch& touch = m_touches[node];
    if (touch.depth > 0.0) {
        const double k = kWallToBending * m_material.stiffness;
        add(m_system, node, node, k * touch.out * touch.out.transpose());
        push(node, k * touch.depth * touch.out);
    }
    if (m_grips[node] > 0.0) {
        const Vec3 way = slide(node, m_nodes[node]);
        const double r = std::sqrt(way.squaredNorm() + kFrictionWay * kFrictionWay);
        const double hold = m_grips[node] / r;
        const Vec3& n = m_normals[node];
        add(m_system, node, node,
            hold * (Mat3::Identity() - n * n.transpose() - way * way.transpose() / (r * r)));
        push(node, hold * way);
    }
}

/// The equations of Newton's step where the nodes lie now: the right side is the fall of the sum.
void ElasticRod::linearise()
{
    m_system = m_bending;
    for (std::size_t i = 0; i < m_turns.size(); ++i) {
        const double a = 1.0 / m_lengths[i];
        const double b = 1.0 / m_lengths[i + 1];
        const Vec3 t = a * (m_nodes[i + 1] - m_nodes[i]);
        const Vec3 off = m_stiffness[i] * (b * (m_nodes[i + 2] - m_nodes[i + 1]) - m_turns[i] * t);
        const Vec3 back = a * (m_turns[i].transpose() * off);
        push(i + 2, b * off);
        push(i + 1, -b * off - back);
        push(i, back);
    }
    for (std::size_t i = 1; i < m_lengths.size(); ++i)
        lineariseSegment(i);
    for (std::size_t i = kHeld; i < m_nodes.size(); ++i)
        lineariseTouch(i);
    for (std::size_t i = kHeld; i < m_nodes.size(); ++i)
        push(i, m_twist[i]);
    push(m_nodes.size() - 1, -m_load);
}

double ElasticRod::improve(const RodWall& wall)
{
    linearise();
    const std::vector<double> fall = m_system.right;
    if (!m_system.solve())
        return 0.0;
    double promised = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < fall.size(); ++i)
        promised += fall[i] * m_system.right[i];
    const auto wayOf = [this](std::size_t node) {
        return Eigen::Map<const Vec3>(&m_system.right[3 * (node - kHeld)]);
    };
    for (std::size_t i = kHeld; i < m_nodes.size(); ++i)
        most = std::max(most, wayOf(i).norm());
    double share = std::min(1.0, kMostAtOnce / most);
    for (int halving = 0; halving < kMostHalvings; ++halving, share *= 0.5) {
        std::ranges::copy(m_nodes, m_trial.begin());
        for (std::size_t i = kHeld; i < m_nodes.size(); ++i)
            m_trial[i] += share * wayOf(i);
        const double sum = sumOf(m_trial, wall, m_trialTouches) + twisting(m_trial);
        if (sum <= m_sum - kSufficient * share * promised) {
            m_nodes.swap(m_trial);
            m_touches.swap(m_trialTouches);
            m_sum = sum;
            return share * most;
        }
    }
    return 0.0;
}

} // namespace carina
