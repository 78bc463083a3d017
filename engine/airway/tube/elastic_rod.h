#pragma once

#include "engine/airway/tube/banded_system.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <span>
#include <vector>

namespace carina
{

/// Where a place lies at a wall.
struct WallTouch {
    double depth = -1.0;     ///< metres beyond the wall; below 0 in the free space
    Vec3 out = Vec3::Zero(); ///< gradient of the depth; zero where no wall is near
    /// Of a wall close around the place: second derivatives of the depth are round * round^T.
    Vec3 round = Vec3::Zero();
};

/// The walls around a rod. The depth is continuous.
class RodWall
{
public:
    virtual ~RodWall() = default;
    /// @param node of the rod, from 0 at its clamp
    [[nodiscard]] virtual WallTouch at(std::size_t node, const Vec3& p_A) const = 0;
};

/// No wall.
class FreeSpace final : public RodWall
{
public:
    [[nodiscard]] WallTouch at(std::size_t /*node*/, const Vec3& /*p_A*/) const override
    {
        return {};
    }
};

struct RodMaterial {
    double stiffness = 1e-3; ///< against bending, N m^2
    /// Coulomb's coefficient of a lubricated tube on wet mucosa: of ours.
    double friction = 0.15;
};

/// An elastic rod without mass that is held at its first segment, as a tube at its connector, and
/// cannot be stretched.
///
/// A discrete elastic rod (Bergou et al, ACM Trans Graph 2008;27:63 and 2010;29:116) of segments
/// t_i, unit, with lengths l_i and a frame each, (t_i, a_i, t_i x a_i). It is laid so that
///
///     sum B / (2 h_i) |t_i+1 - t_i+1,rest|^2 + sum C / h_i (1 - cos m_i) + sum k / 2 depth_j^2
///         + sum mu N_j sqrt(|d_j|^2 + s^2) - f . x_tip
///
/// is least: bending away from the curve at rest, which is given in the frame of the segment
/// before; torsion, m_i being the angle by which the next frame is twisted against this one carried
/// on to it without rotation about it; depth beyond the walls; and friction. d_j is the way of a
/// node along its wall since the step before, N_j its force on the wall then. So the friction is
/// that of Coulomb above a few s per step, and below that the rod creeps.
///
/// step() finds the minimum by Newton's method in the ways of the nodes and the twists of the
/// frames, with lengths held by multipliers, and then turns the segments by these ways: so lengths
/// are kept whatever the ways. The matrix is that of the squares of bending and torsion, tension,
/// friction and walls, without compression where with it it would be indefinite. It is banded, so
/// that a solution costs in proportion to the number of segments. Walls hold those nodes that would
/// otherwise go beyond them in the linear equations (an active set). Ways that would raise the sum
/// are damped (Levenberg and Marquardt). What holds the rod moves first, and the rod with it by the
/// same equations. After that the sum only falls: while clamp and walls rest the rod cannot gain
/// energy. Deterministic; it begins with where it lay before.
///
/// A step has at most kMostSolutions solutions; what is left then, as of a rod that is pushed hard
/// against a stop and buckles, is left to the next one.
///
/// Positions in one frame A, metres.
class ElasticRod
{
public:
    /// The rod in its rest curve.
    /// @param p_E_rest in the frame E of what holds it, from there to its tip
    /// @pre at least four points, no two neighbours equal; stiffness above 0
    ElasticRod(const RodMaterial& material, std::span<const Vec3> p_E_rest);

    /// Lays it in its rest curve, held at this pose.
    void lay(const RigidTransform& X_AE);
    /// Lays it with its segments in the directions of those between other places.
    /// @pre as many as nodes, no two neighbours equal
    void lay(const RigidTransform& X_AE, std::span<const Vec3> p_A);

    /// From now on what lies before this node is stiffer by a factor.
    void stiffenBefore(std::size_t node, double factor);

    /// Moves what holds it to this pose, and lets it come to rest.
    /// @param f_A_tip a load at its tip, newtons
    void step(const RigidTransform& X_AE, const RodWall& wall, const Vec3& f_A_tip = Vec3::Zero());
    /// Lets it come to rest where it is held without friction, as after it was laid.
    void comeToRest(const RodWall& wall);

    [[nodiscard]] std::span<const Vec3> nodes() const { return m_laid.nodes; }
    /// The nodes in its rest curve, held where it is now.
    [[nodiscard]] std::vector<Vec3> nodesAtRest() const;
    [[nodiscard]] std::span<const WallTouch> touches() const { return m_laid.touches; }
    /// Force with which a node presses on the wall, newtons.
    [[nodiscard]] double force(std::size_t node) const;
    /// Of bending and torsion, joules.
    [[nodiscard]] double energy() const { return elastic(m_laid); }
    /// Length at rest from the clamp to a node, metres.
    [[nodiscard]] double along(std::size_t node) const { return m_along[node]; }

    /// Of a unit of bending stiffness: of the walls k, per m^3. Of ours: a tube that is pushed
    /// against a stop yields by less than 0.2 mm.
    static constexpr double kWallToBending = 1e8;
    /// C of a unit of bending stiffness: 1 / (1 + nu) of a round tube, which as soft PVC hardly
    /// changes its volume (nu = 0.5).
    static constexpr double kTorsionToBending = 1.0 / 1.5;
    static constexpr double kFrictionWay = 2e-5; ///< s, metres: of ours
    static constexpr std::size_t kHeld = 2;      ///< nodes that what holds it determines
    static constexpr int kMostSolutions = 9;     ///< of the linear equations in a step: of ours

private:
    using Values = BandedSystem::Values; ///< of a node, and of the frame of the segment before it

    /// Bending from one segment to the next: in the frame of the first the second one is at rest
    /// cosine t + byAcross a + byAside t x a.
    struct Turn {
        double cosine = 1.0;
        double byAcross = 0.0;
        double byAside = 0.0;
        double perLength = 0.0; ///< B / h where it is not stiffened
    };

    [[nodiscard]] Vec3 segment(std::span<const Vec3> nodes, std::size_t i) const
    {
        return (nodes[i + 1] - nodes[i]) / m_lengths[i];
    }
    /// How the rod lies.
    struct Laid {
        std::vector<Vec3> nodes;
        std::vector<Vec3> across; ///< a_i of the segments
        std::vector<WallTouch> touches;
        double sum = 0.0; ///< that is to be least
    };
    /// What the clamp determines.
    struct Held {
        std::array<Vec3, kHeld> nodes;
        Vec3 across;
    };

    [[nodiscard]] double elastic(const Laid& laid) const;
    /// Finds the touches and the sum.
    void judge(Laid& laid, const RodWall& wall) const;
    void carryFrames();
    void grip();
    [[nodiscard]] Held heldAt(const RigidTransform& X_AE) const;
    void moveClamp(const RigidTransform& X_AE, const RodWall& wall);
    [[nodiscard]] bool followClamp(const Held& held, const RodWall& wall);
    void moveAsWhole(const RigidTransform& moved, const Held& held);
    void linearise();
    void lineariseTurn(std::size_t i);
    void lineariseTension();
    void lineariseFriction();
    [[nodiscard]] BandedSystem::Support supportAt(std::size_t node) const;
    /// Finds the ways of the nodes, and which walls hold them.
    [[nodiscard]] bool findWays();
    [[nodiscard]] bool findWaysAsIs();
    void damp(double times);
    /// Turns the segments so far along these ways: m_trial.
    void tryWays(double share);
    void findTensions(double share);
    /// One of Newton's steps. @returns by how much it moved the node that it moved most, metres.
    [[nodiscard]] double improve(const RodWall& wall);
    [[nodiscard]] bool takeTrial(double share, double promised, const RodWall& wall);
    /// Of the way of a node since the step before the part along its wall.
    [[nodiscard]] Vec3 slide(std::size_t node, const Vec3& p) const;

    RodMaterial m_material;
    std::vector<Vec3> m_rest; ///< in E
    std::vector<double> m_lengths;
    std::vector<double> m_along;
    std::vector<Turn> m_turnsAtRest;
    std::vector<double> m_stiffness; ///< B / h of each turn
    Vec3 m_firstAcross_E;            ///< the frame of the first segment

    RigidTransform m_X_AE;
    Laid m_laid;
    std::vector<double> m_tensions; ///< of the segments, newtons: what keeps their lengths
    std::vector<bool> m_isHeld;     ///< by a wall, in the linear equations
    std::vector<Vec3> m_before;     ///< the nodes before the step
    std::vector<Vec3> m_normals;    ///< of the walls then, unit; zero where none was touched
    std::vector<double> m_grips;    ///< mu N_j
    Vec3 m_load = Vec3::Zero();
    double m_likely = 0.0; ///< way of a node in this step, while none is known

    int m_solutionsLeft = 0;      ///< of the linear equations, in this step
    bool m_hasCompression = true; ///< in the linear equations
    double m_damping = 0.0;       ///< of the ways, of a unit of bending stiffness, per m^3
    BandedSystem m_system;        ///< the walls and the damping are its supports
    std::vector<Values> m_ways;   ///< of nodes, and twists, by one of Newton's steps
    Laid m_trial;
    Laid m_best;
    std::vector<Values> m_bestWays;
};

} // namespace carina
