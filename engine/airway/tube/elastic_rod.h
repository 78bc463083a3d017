#pragma once

#include "engine/airway/tube/banded_system.h"
#include "engine/geometry/rigid_transform.h"

#include <span>
#include <vector>

namespace carina
{

/// Where a place lies at a wall.
struct WallTouch {
    double depth = -1.0;     ///< metres beyond the wall; below 0 in the free space
    Vec3 out = Vec3::Zero(); ///< gradient of the depth, where that is above 0
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

/// An elastic rod without mass that is held at its first segment, as a tube at its connector.
///
/// A discrete elastic rod (Bergou et al, ACM Trans Graph 2008;27:63) of segments t_i with rest
/// lengths l_i. It is laid so that
///
///     sum B / (2 h_i) |t_i+1 - R_i t_i|^2 + sum K / (2 l_i) (|e_i| - l_i)^2
///         + sum k / 2 depth_j^2 + sum mu N_j sqrt(|d_j|^2 + s^2) - f . x_tip
///
/// is least: bending away from the curve at rest, of which R_i is the turn from one segment to the
/// next; stretching, which K keeps below a thousandth; depth beyond the walls; and friction. d_j is
/// the way of a node along its wall since the step before, N_j its force on the wall then. So the
/// friction is that of Coulomb above a few s per step, and below that the rod creeps.
///
/// No twist: the frame in which R_i is given is carried from the clamp along the rod without
/// rotation about it, as in a rod that is far stiffer against torsion than against bending. It is
/// computed once per step, and so are the forces of the torque that holds it so (the gradient of
/// the angle by which carrying turns it, as Bergou et al have it).
///
/// step() finds the minimum by Newton's method with a matrix that is never indefinite: that of the
/// bending is exact for these R_i, of stretch and walls the part that is not negative is taken. Its
/// bandwidth is 8, so that a step costs in proportion to the number of segments. What would raise
/// the sum is shortened, at last with the frames as they then are: so it only falls, and while
/// clamp and walls rest the rod cannot gain energy. Deterministic; it begins with where it lay
/// before.
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
    /// Lays it along other places. @pre as many as nodes, no two neighbours equal
    void lay(const RigidTransform& X_AE, std::span<const Vec3> p_A);

    /// From now on what lies before this node is stiffer by a factor.
    void stiffenBefore(std::size_t node, double factor);

    /// Moves what holds it to this pose, and lets it come to rest.
    /// @param f_A_tip a load at its tip, newtons
    void step(const RigidTransform& X_AE, const RodWall& wall, const Vec3& f_A_tip = Vec3::Zero());

    [[nodiscard]] std::span<const Vec3> nodes() const { return m_nodes; }
    /// The nodes in its rest curve, held where it is now.
    [[nodiscard]] std::vector<Vec3> nodesAtRest() const;
    [[nodiscard]] std::span<const WallTouch> touches() const { return m_touches; }
    /// Force with which a node presses on the wall, newtons.
    [[nodiscard]] double force(std::size_t node) const;
    /// Of bending and stretching, joules, with the frames as they lie now.
    [[nodiscard]] double energy() const;
    /// Length at rest from the clamp to a node, metres.
    [[nodiscard]] double along(std::size_t node) const { return m_along[node]; }

    /// Of a unit of bending stiffness: of the stretching K, per m^2, and of the walls k, per m^3.
    /// Of ours: a tube that is pushed against a stop yields by less than 0.2 mm.
    static constexpr double kStretchToBending = 2e7;
    static constexpr double kWallToBending = 1e8;
    static constexpr double kFrictionWay = 2e-5; ///< s, metres: of ours
    static constexpr std::size_t kHeld = 2;      ///< nodes that what holds it determines

private:
    /// Bending from one segment to the next.
    struct Turn {
        double cosine = 1.0; ///< of the angle at rest
        double sine = 0.0;
        double across = 0.0; ///< its axis in the carried frame
        double aside = 0.0;
        double perLength = 0.0; ///< B / h where it is not stiffened
    };

    void carryFrames();
    void addBending();
    void grip();
    void holdTwist();
    [[nodiscard]] double twisting(std::span<const Vec3> nodes) const;
    /// Goes on as in the step before, where that lowers the sum.
    void foresee(const RodWall& wall);
    /// Shortens the way since the start of a step until the sum has not risen.
    void settle(const RodWall& wall, double before);
    /// The sum that is to be least with these nodes, but for twisting(); fills their touches.
    [[nodiscard]] double sumOf(std::span<const Vec3> nodes, const RodWall& wall,
                               std::vector<WallTouch>& touches) const;
    [[nodiscard]] double stretching(std::span<const Vec3> nodes) const;
    [[nodiscard]] double bending(std::span<const Vec3> nodes) const;
    void linearise();
    void lineariseSegment(std::size_t segment);
    void lineariseTouch(std::size_t node);
    /// One of Newton's steps. @returns by how much it moved the node that it moved most, metres.
    [[nodiscard]] double improve(const RodWall& wall);
    void add(BandedSystem<8>& system, std::size_t row, std::size_t column, const Mat3& block) const;
    void push(std::size_t node, const Vec3& gradient);
    /// Of the way of a node since the step before the part along its wall.
    [[nodiscard]] Vec3 slide(std::size_t node, const Vec3& p) const;

    RodMaterial m_material;
    std::vector<Vec3> m_rest; ///< in E
    std::vector<double> m_lengths;
    std::vector<double> m_along;
    std::vector<Turn> m_turnsAtRest;
    std::vector<double> m_stiffness; ///< B / h of each turn
    Vec3 m_firstAcross_E;            ///< the carried frame at the clamp: beside the first segment

    RigidTransform m_X_AE;
    std::vector<Vec3> m_nodes;
    std::vector<WallTouch> m_touches;
    std::vector<Mat3> m_turns;     ///< R_i
    std::vector<Vec3> m_axes;      ///< of these, unit
    std::vector<double> m_torques; ///< that hold the frames, N m
    std::vector<Vec3> m_twist;     ///< gradient by these
    std::vector<Vec3> m_start;     ///< of a step, with what holds it where it is then
    std::vector<Vec3> m_ways;      ///< of the nodes in the last step
    std::vector<Vec3> m_before;    ///< the step
    std::vector<Vec3> m_normals;   ///< of the walls then, unit; zero where none was touched
    std::vector<double> m_grips;   ///< mu N_j
    Vec3 m_load = Vec3::Zero();

    double m_sum = 0.0;        ///< that is to be least, as the nodes lie
    BandedSystem<8> m_bending; ///< its part that does not change during a step
    BandedSystem<8> m_system;
    std::vector<Vec3> m_trial;
    std::vector<WallTouch> m_trialTouches;
};

} // namespace carina
