#include "engine/airway/tube/elastic_rod.h"

#include "engine/core/expects.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kMostImprovements = 4; ///< in one step
constexpr int kMostAtRest = 60;      ///< where it is let come to rest
constexpr double kNearRest = 5e-5;   ///< metres: a smaller improvement is the last of a step, as
                                     ///< what is left is about the square of it
constexpr double kAtRest = 2e-6;     ///< metres: the same where it is let come to rest
constexpr double kMostAtOnce = 2e-2; ///< metres that a node moves in one of Newton's steps
constexpr double kSufficient = 1e-4; ///< of the fall that the gradient promises (Armijo)
constexpr double kGood = 0.25;       ///< of it: less damping is needed
constexpr int kMostTries = 6;
constexpr int kMostWallings = 4; ///< times that the walls that hold it are chosen
constexpr int kMostFollowings = 3;
constexpr double kDeep = 3e-4; ///< metres: the clamp is followed anew where walls are so far passed
// Damping, of a unit of bending stiffness, per m^3.
constexpr double kLeastDamping = 1e4;
constexpr double kMostDamping = 1e8;
constexpr double kMostKeptDamping = 1e5; ///< for the next step
constexpr double kMoreDamping = 10.0;
/// Of a unit of bending stiffness: against stretching in the linear equations, per m^2. The ways of
/// the nodes keep the lengths as well as these keep them; the segments are turned anyway.
constexpr double kStretchToBending = 2e8;

/// v as it goes along from one unit direction to another by the least rotation.
Vec3 carried(const Vec3& v, const Vec3& from, const Vec3& to)
{
    const Vec3 axis = from.cross(to);
    const double cosine = std::max(from.dot(to), -0.999);
    const Vec3 turned = axis.cross(v);
    return v + turned + axis.cross(turned) / (1.0 + cosine);
}

/// A unit vector across `along`, about which it is turned by an angle: to the second order, as in
/// Cayley's map.
Vec3 twisted(const Vec3& v, const Vec3& along, double angle)
{
    const double h = 0.5 * angle;
    const double scale = 1.0 / (1.0 + h * h);
    const Vec3 turned = scale * (1.0 - h * h) * v + scale * 2.0 * h * along.cross(v);
    return (turned - turned.dot(along) * along).normalized();
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
        const Vec3& next = tangents[i + 1];
        // The first segment is held: of what bends there only the half in the second one does.
        const double length = 0.5 * ((i > 0 ? m_lengths[i] : 0.0) + m_lengths[i + 1]);
        m_turnsAtRest.push_back({.cosine = next.dot(t),
                                 .byAcross = next.dot(across),
                                 .byAside = next.dot(t.cross(across)),
                                 .perLength = material.stiffness / length});
        m_stiffness.push_back(m_turnsAtRest.back().perLength);
        across = carried(across, t, next);
    }
    const std::size_t count = m_rest.size();
    for (Laid* laid : {&m_laid, &m_trial, &m_best}) {
        laid->nodes.resize(count);
        laid->across.resize(m_lengths.size());
        laid->touches.resize(count);
    }
    m_tensions.resize(m_lengths.size());
    m_normals.resize(count);
    m_grips.resize(count);
    m_system.resize(count);
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
    std::vector<Vec3>& nodes = m_laid.nodes;
    std::ranges::copy(heldAt(X_AE).nodes, nodes.begin());
    for (std::size_t i = kHeld; i < p_A.size(); ++i)
        nodes[i] = nodes[i - 1] + m_lengths[i - 1] * (p_A[i] - p_A[i - 1]).normalized();
    carryFrames();
    std::ranges::fill(m_laid.touches, WallTouch{});
    m_before = nodes;
    m_ways.assign(nodes.size(), Values::Zero());
    m_bestWays = m_ways;
    m_isHeld.assign(nodes.size(), false);
    std::ranges::fill(m_tensions, 0.0);
    m_damping = 0.0;
}

/// Along the rod without twist.
void ElasticRod::carryFrames()
{
    std::vector<Vec3>& across = m_laid.across;
    across[0] = heldAt(m_X_AE).across;
    for (std::size_t i = 1; i < across.size(); ++i) {
        const Vec3 t = segment(m_laid.nodes, i);
        across[i] = twisted(carried(across[i - 1], segment(m_laid.nodes, i - 1), t), t, 0.0);
    }
}

void ElasticRod::stiffenBefore(std::size_t node, double factor)
{
    for (std::size_t i = 0; i < m_turnsAtRest.size(); ++i)
        m_stiffness[i] = (i + 1 < node ? factor : 1.0) * m_turnsAtRest[i].perLength;
}

void ElasticRod::step(const RigidTransform& X_AE, const RodWall& wall, const Vec3& f_A_tip)
{
    m_load = f_A_tip;
    m_before = m_laid.nodes;
    grip();
    m_solutionsLeft = kMostSolutions;
    m_hasCompression = true;
    m_damping = m_damping > kMostKeptDamping ? kMostKeptDamping : 0.0;
    moveClamp(X_AE, wall);
    for (int i = 0; i < kMostImprovements && improve(wall) > kNearRest; ++i) {}
}

void ElasticRod::comeToRest(const RodWall& wall)
{
    m_before = m_laid.nodes;
    std::ranges::fill(m_grips, 0.0);
    judge(m_laid, wall);
    for (int i = 0; i < kMostAtRest; ++i) {
        m_solutionsLeft = kMostSolutions;
        m_hasCompression = true;
        // What ran out of solutions, or is held by its damping, is not at rest.
        if (improve(wall) <= kAtRest && m_solutionsLeft > 0 && m_damping <= kLeastDamping)
            break;
    }
}

double ElasticRod::force(std::size_t node) const
{
    const WallTouch& touch = m_laid.touches[node];
    return touch.depth > 0.0
               ? kWallToBending * m_material.stiffness * touch.depth * touch.out.norm()
               : 0.0;
}

/// What was touched before the step holds on to the nodes during it.
void ElasticRod::grip()
{
    for (std::size_t i = 0; i < m_laid.nodes.size(); ++i) {
        const double pressure = force(i);
        m_grips[i] = m_material.friction * pressure;
        m_normals[i] =
            pressure > 0.0 ? Vec3{m_laid.touches[i].out.normalized()} : Vec3{Vec3::Zero()};
    }
}

ElasticRod::Held ElasticRod::heldAt(const RigidTransform& X_AE) const
{
    return {{X_AE * m_rest[0], X_AE * m_rest[1]}, X_AE.rotation() * m_firstAcross_E};
}

/// Where the equations lead to no place, the rod is moved as a whole.
void ElasticRod::moveClamp(const RigidTransform& X_AE, const RodWall& wall)
{
    const RigidTransform moved = X_AE * m_X_AE.inverse();
    m_X_AE = X_AE;
    const Held held = heldAt(X_AE);
    judge(m_laid, wall);
    if (std::ranges::equal(held.nodes, std::span{m_laid.nodes}.first(kHeld))
        && held.across == m_laid.across[0])
        return;
    if (followClamp(held, wall)) {
        m_ways.swap(m_bestWays);
        findTensions(1.0);
    } else {
        moveAsWhole(moved, held);
        judge(m_best, wall);
    }
    std::swap(m_laid, m_best);
    std::ranges::fill(m_ways, Values{Values::Zero()});
}

/// By the equations where the rod lies now, m_best; more damped where these lead far beyond walls.
bool ElasticRod::followClamp(const Held& held, const RodWall& wall)
{
    const auto deepest = [](const Laid& laid) {
        return std::max(std::ranges::max_element(laid.touches, {}, &WallTouch::depth)->depth, 0.0);
    };
    const double before = deepest(m_laid);
    const Vec3 t = segment(m_laid.nodes, 0);
    const Vec3& across = m_laid.across[0];
    const Vec3 back = carried(held.across, (held.nodes[1] - held.nodes[0]) / m_lengths[0], t);
    const double twist = std::atan2(back.dot(t.cross(across)), back.dot(across));
    for (std::size_t i = 0; i < kHeld; ++i)
        m_ways[i] << held.nodes[i] - m_laid.nodes[i], i > 0 ? twist : 0.0;
    m_likely = m_ways[1].head<3>().norm();
    linearise();
    bool isFound = false;
    for (int i = 0; i < kMostFollowings && m_solutionsLeft > 2; ++i) {
        if (findWays()) {
            tryWays(1.0);
            std::ranges::copy(held.nodes, m_trial.nodes.begin());
            m_trial.across[0] = held.across;
            judge(m_trial, wall);
            const bool isGood = deepest(m_trial) < before + kDeep;
            if (!isFound || m_trial.sum < m_best.sum) {
                std::swap(m_best, m_trial);
                m_bestWays = m_ways;
            }
            isFound = true;
            if (isGood)
                break;
        }
        damp(kMoreDamping * kMoreDamping);
    }
    m_likely = 0.0;
    return isFound;
}

void ElasticRod::moveAsWhole(const RigidTransform& moved, const Held& held)
{
    for (std::size_t i = kHeld; i < m_laid.nodes.size(); ++i)
        m_best.nodes[i] = moved * m_laid.nodes[i];
    for (std::size_t i = 1; i < m_laid.across.size(); ++i)
        m_best.across[i] = moved.rotation() * m_laid.across[i];
    std::ranges::copy(held.nodes, m_best.nodes.begin());
    m_best.across[0] = held.across;
}

double ElasticRod::elastic(const Laid& laid) const
{
    double sum = 0.0;
    Vec3 t = segment(laid.nodes, 0);
    for (std::size_t i = 0; i < m_turnsAtRest.size(); ++i) {
        const Turn& turn = m_turnsAtRest[i];
        const Vec3 next = segment(laid.nodes, i + 1);
        const Vec3& a = laid.across[i];
        const Vec3 off = next - turn.cosine * t - turn.byAcross * a - turn.byAside * t.cross(a);
        const double cosine = laid.across[i + 1].dot(carried(a, t, next));
        sum += m_stiffness[i] * (0.5 * off.squaredNorm() + kTorsionToBending * (1.0 - cosine));
        t = next;
    }
    return sum;
}

Vec3 ElasticRod::slide(std::size_t node, const Vec3& p) const
{
    const Vec3 way = p - m_before[node];
    return way - way.dot(m_normals[node]) * m_normals[node];
}

void ElasticRod::judge(Laid& laid, const RodWall& wall) const
{
    double walls = 0.0;
    double friction = 0.0;
    for (std::size_t i = kHeld; i < laid.nodes.size(); ++i) {
        laid.touches[i] = wall.at(i, laid.nodes[i]);
        const double depth = std::max(laid.touches[i].depth, 0.0);
        walls += 0.5 * depth * depth;
        if (m_grips[i] > 0.0)
            friction +=
                m_grips[i]
                * std::sqrt(slide(i, laid.nodes[i]).squaredNorm() + kFrictionWay * kFrictionWay);
    }
    laid.sum = elastic(laid) + kWallToBending * m_material.stiffness * walls + friction
               - m_load.dot(laid.nodes.back());
}

/// The equations of Newton's step where the rod lies now, but for the walls: the right side is the
/// fall of the sum.
void ElasticRod::linearise()
{
    std::ranges::fill(m_system.rows, BandedSystem::Row{});
    for (std::size_t i = 0; i < m_turnsAtRest.size(); ++i)
        lineariseTurn(i);
    lineariseTension();
    lineariseFriction();
    m_system.rows.back().right.head<3>() += m_load;
}

/// Of the residual of bending, off, by the nodes i, i + 1, i + 2 and the twist of the frame of the
/// first segment: P, -Q and -tau, b. Of the angle of torsion: -f, f - g, g, and -1, 1 by the twists
/// of both frames (Bergou et al).
void ElasticRod::lineariseTurn(std::size_t i)
{
    const Turn& turn = m_turnsAtRest[i];
    const Vec3 t = segment(m_laid.nodes, i);
    const Vec3 next = segment(m_laid.nodes, i + 1);
    const Vec3& across = m_laid.across[i];
    const Vec3 aside = t.cross(across);
    const Vec3 rest = turn.cosine * t + turn.byAcross * across + turn.byAside * aside;
    const Vec3 tau = turn.byAcross * aside - turn.byAside * across;
    const Vec3 off = next - rest;
    const double w = m_stiffness[i];
    const double b = 1.0 / m_lengths[i + 1];
    Mat3 P = -t * rest.transpose();
    P.diagonal().array() += turn.cosine;
    P /= m_lengths[i];
    Mat3 Q = P;
    Q.diagonal().array() += b;

    BandedSystem::Row& first = m_system.rows[i];
    BandedSystem::Row& second = m_system.rows[i + 1];
    BandedSystem::Row& third = m_system.rows[i + 2];
    const Mat3 QtP = w * Q.transpose() * P;
    first.diagonal.topLeftCorner<3, 3>() += w * P.transpose() * P;
    second.before.topLeftCorner<3, 3>() -= QtP;
    second.before.bottomLeftCorner<1, 3>() -= w * tau.transpose() * P;
    const Vec3 byTwist = w * Q.transpose() * tau;
    second.diagonal.topLeftCorner<3, 3>() += QtP + w * b * Q.transpose();
    second.diagonal.topRightCorner<3, 1>() += byTwist;
    second.diagonal.bottomLeftCorner<1, 3>() += byTwist.transpose();
    second.diagonal(3, 3) += w * tau.squaredNorm();
    third.secondBefore.topLeftCorner<3, 3>() += w * b * P;
    third.before.topLeftCorner<3, 3>() -= w * b * Q;
    third.before.topRightCorner<3, 1>() -= w * b * tau;
    third.diagonal.diagonal().head<3>().array() += w * b * b;
    first.right.head<3>() -= w * P.transpose() * off;
    second.right.head<3>() += w * Q.transpose() * off;
    second.right[3] += w * tau.dot(off);
    third.right.head<3>() -= w * b * off;

    const Vec3 there = carried(across, t, next);
    const double sine = m_laid.across[i + 1].dot(next.cross(there));
    const Vec3 bend = t.cross(next) / std::max(1.0 + t.dot(next), 1e-3);
    const Vec3 f = bend / m_lengths[i];
    const Vec3 g = bend * b;
    const double c = kTorsionToBending * w;
    const Values byFirst{-f.x(), -f.y(), -f.z(), 0.0};
    const Values bySecond{f.x() - g.x(), f.y() - g.y(), f.z() - g.z(), -1.0};
    const Values byThird{g.x(), g.y(), g.z(), 1.0};
    first.diagonal += c * byFirst * byFirst.transpose();
    second.before += c * bySecond * byFirst.transpose();
    second.diagonal += c * bySecond * bySecond.transpose();
    third.secondBefore += c * byThird * byFirst.transpose();
    third.before += c * byThird * bySecond.transpose();
    third.diagonal += c * byThird * byThird.transpose();
    first.right -= c * sine * byFirst;
    second.right -= c * sine * bySecond;
    third.right -= c * sine * byThird;
}

/// The lengths are held as by springs about the tension that was found before.
void ElasticRod::lineariseTension()
{
    for (std::size_t i = 1; i < m_lengths.size(); ++i) {
        const Vec3 t = segment(m_laid.nodes, i);
        const double k = kStretchToBending * m_material.stiffness / m_lengths[i];
        const double tension = m_tensions[i];
        const double across = (m_hasCompression ? tension : std::max(tension, 0.0)) / m_lengths[i];
        Mat3 block = (k - across) * t * t.transpose();
        block.diagonal().array() += across;
        m_system.rows[i + 1].diagonal.topLeftCorner<3, 3>() += block;
        m_system.rows[i + 1].before.topLeftCorner<3, 3>() -= block;
        m_system.rows[i].diagonal.topLeftCorner<3, 3>() += block;
        m_system.rows[i + 1].right.head<3>() -= tension * t;
        m_system.rows[i].right.head<3>() += tension * t;
    }
}

void ElasticRod::lineariseFriction()
{
    for (std::size_t i = kHeld; i < m_laid.nodes.size(); ++i) {
        if (m_grips[i] <= 0.0)
            continue;
        const Vec3 way = slide(i, m_laid.nodes[i]);
        const double r =
            std::sqrt(way.squaredNorm() + m_likely * m_likely + kFrictionWay * kFrictionWay);
        const Vec3& n = m_normals[i];
        const double hold = m_grips[i] / r;
        m_system.rows[i].diagonal.topLeftCorner<3, 3>() +=
            hold * (Mat3::Identity() - n * n.transpose() - way * way.transpose() / (r * r));
        m_system.rows[i].right.head<3>() -= hold * way;
    }
}

/// What the walls, if they hold a node, and damping do to its equations.
BandedSystem::Support ElasticRod::supportAt(std::size_t node) const
{
    BandedSystem::Support support;
    support.diagonal.diagonal().head<3>().setConstant(m_damping * m_material.stiffness);
    if (!m_isHeld[node])
        return support;
    const WallTouch& touch = m_laid.touches[node];
    const double k = kWallToBending * m_material.stiffness;
    support.diagonal.topLeftCorner<3, 3>() += k * touch.out * touch.out.transpose();
    if (touch.depth > 0.0)
        support.diagonal.topLeftCorner<3, 3>() +=
            k * touch.depth * touch.round * touch.round.transpose();
    support.right.head<3>() = -k * touch.depth * touch.out;
    return support;
}

bool ElasticRod::findWays()
{
    if (findWaysAsIs())
        return true;
    if (!m_hasCompression)
        return false;
    m_hasCompression = false; // it would buckle
    linearise();
    return findWaysAsIs();
}

bool ElasticRod::findWaysAsIs()
{
    bool isFound = false;
    bool isSame = false;
    for (int i = 0; i < kMostWallings && m_solutionsLeft > 0 && !isSame; ++i) {
        for (std::size_t node = kHeld; node < m_laid.nodes.size(); ++node)
            m_system.supports[node] = supportAt(node);
        --m_solutionsLeft;
        if (!m_system.solve(kHeld, m_ways))
            return false;
        isFound = true;
        isSame = true;
        for (std::size_t node = kHeld; node < m_laid.nodes.size(); ++node) {
            const WallTouch& touch = m_laid.touches[node];
            const bool isHeld = touch.depth + touch.out.dot(m_ways[node].head<3>()) > 0.0;
            isSame = isSame && isHeld == m_isHeld[node];
            m_isHeld[node] = isHeld;
        }
    }
    return isFound;
}

void ElasticRod::damp(double times)
{
    m_damping = std::clamp(times * m_damping, kLeastDamping, kMostDamping);
}

void ElasticRod::tryWays(double share)
{
    const std::vector<Vec3>& nodes = m_laid.nodes;
    const auto wayOf = [this](std::size_t node) { return m_ways[node].head<3>(); };
    for (std::size_t i = 0; i < kHeld; ++i)
        m_trial.nodes[i] = nodes[i] + share * wayOf(i);
    m_trial.across[0] = m_laid.across[0];
    for (std::size_t i = 1; i < m_lengths.size(); ++i) {
        const Vec3 step = nodes[i + 1] - nodes[i] + share * (wayOf(i + 1) - wayOf(i));
        const Vec3 t = step.normalized();
        m_trial.nodes[i + 1] = m_trial.nodes[i] + m_lengths[i] * t;
        m_trial.across[i] =
            twisted(carried(m_laid.across[i], segment(nodes, i), t), t, share * m_ways[i + 1][3]);
    }
}

/// Of the segments where the rod lies now, by the ways.
void ElasticRod::findTensions(double share)
{
    for (std::size_t i = 1; i < m_lengths.size(); ++i) {
        const Vec3 change = m_ways[i + 1].head<3>() - m_ways[i].head<3>();
        m_tensions[i] += share * kStretchToBending * m_material.stiffness / m_lengths[i]
                         * segment(m_laid.nodes, i).dot(change);
    }
}

double ElasticRod::improve(const RodWall& wall)
{
    linearise();
    for (int i = 0; i < kMostTries && m_solutionsLeft > 0; ++i) {
        if (findWays()) {
            double promised = 0.0;
            double most = 0.0;
            for (std::size_t node = kHeld; node < m_laid.nodes.size(); ++node) {
                const WallTouch& touch = m_laid.touches[node];
                const double pressed =
                    kWallToBending * m_material.stiffness * std::max(touch.depth, 0.0);
                const auto way = m_ways[node].head<3>();
                promised +=
                    m_system.rows[node].right.dot(m_ways[node]) - pressed * touch.out.dot(way);
                most = std::max(most, way.norm());
            }
            const double share = most > kMostAtOnce ? kMostAtOnce / most : 1.0;
            if (takeTrial(share, promised, wall))
                return share * most;
            if (most < kAtRest)
                break; // it may be lost in the rounding of the sum
        }
        damp(kMoreDamping);
    }
    return 0.0;
}

bool ElasticRod::takeTrial(double share, double promised, const RodWall& wall)
{
    tryWays(share);
    judge(m_trial, wall);
    const double fall = m_laid.sum - m_trial.sum;
    if (!(fall >= kSufficient * share * std::max(promised, 0.0)))
        return false;
    if (fall >= kGood * share * promised)
        m_damping = m_damping > kLeastDamping ? m_damping / kMoreDamping : 0.0;
    findTensions(share);
    std::swap(m_laid, m_trial);
    return true;
}

} // namespace carina
