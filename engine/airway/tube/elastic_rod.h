#pragma once

#include "engine/airway/tube/walled_ways.h"
#include "engine/geometry/rigid_transform.h"

#include <limits>
#include <span>
#include <vector>

namespace carina
{

/// What holds a rod, and what it lies along.
struct RodHold {
    RigidTransform X_AE{};           ///< of what holds its first segment
    const RodGuide* guide = nullptr; ///< begins straight, in the direction of that segment
    double first = 0.0;              ///< along the guide: where its first node is held
    double stop = std::numeric_limits<double>::infinity(); ///< beyond which no tip goes
    double inFreeSpace = 1.0; ///< by so much it is stiffer where the guide is free
};

/// An elastic rod without mass that is held at its first segment, as a tube at its connector, and
/// cannot be stretched. It lies along a guide, inside of the sections of that, where
///
///     sum B_i / (2 l^3) |M_i^T (x_i-1 - 2 x_i + x_i+1) - k_i|^2 - f . x_tip
///
/// is least: a discrete elastic rod after Bergou et al (ACM Trans Graph 2008;27:63), whose
/// curvature of a turn by phi, 2 tan(phi / 2), is 2 sin(phi / 2) here, of segments of equal length
/// l. M_i are two axes across it at a node, carried from what holds it along the rod without
/// rotation about it, and k_i the same of its curve at rest: so it is as if it could not be
/// twisted. Lengths are held by multipliers.
///
/// Each step solves this with the sections and axes as the step before left them (WalledWays), and
/// goes there: one of Newton's steps. Walls are springs so stiff that a node is beyond them by
/// micrometres; for what is drawn it is put onto them, and the lengths are made exact by sliding
/// the nodes along the guide, by a few millimetres; where that is not enough, as where the rod goes
/// across its guide, the length counts. Elsewhere the rod is inside of the sections after each
/// step, whatever is left of the sum. Walls push across the guide and not along it: there is no
/// friction. Inside of the sections a node is slowed as it goes across the guide, as by a dashpot,
/// by so much as a spring of kDrag would hold it back in a step. Without that it would leap by
/// centimetres between ways to lie that are nearly as good, at moments that noise decides. It goes
/// where the sum is least all the same, later: how the rod lies at rest depends on where it is
/// held, and on its past only where there are two such ways.
///
/// What would push its tip beyond the stop holds the rod by so much farther back instead, as the
/// proxy of a haptic device stays at a wall (Zilles and Salisbury, IROS 1995): it is drawn behind
/// the hand that pushes it, and does not buckle. Later it comes on by at most kMostOn in a step.
///
/// Deterministic. Positions in one frame A, metres.
class ElasticRod
{
public:
    /// The rod in its rest curve.
    /// @param stiffness against bending, N m^2
    /// @param p_E_rest in the frame E of what holds it, from there to its tip, at equal distances
    /// @pre at least four points, no two neighbours equal; stiffness above 0
    ElasticRod(double stiffness, std::span<const Vec3> p_E_rest);

    /// Has another rest curve from now on. @pre as many points, and as long
    void setRest(std::span<const Vec3> p_E_rest);
    /// Lays it in its rest curve, held at this pose: without a guide.
    void lay(const RigidTransform& X_AE);
    /// Lays it as at rest up to a node, which is `entered` along the guide, and from there on in
    /// the middle of that, and takes a step.
    void layAlong(const RodHold& hold, std::size_t entry, double entered);
    /// A step, to where it is held now. @pre it was laid along a guide
    /// @param f_A_tip a load at its tip, newtons
    /// Where its solution folds, it lies as it did along the guide, and the next step solves from
    /// there.
    /// @returns false where it was lost, as after a jump, or stays folded: it has to be laid anew
    [[nodiscard]] bool step(const RodHold& hold, const Vec3& f_A_tip = Vec3::Zero());

    [[nodiscard]] std::span<const Vec3> nodes() const { return m_nodes; }
    /// The nodes in its rest curve, held where it is now; and held at another pose.
    [[nodiscard]] std::vector<Vec3> nodesAtRest() const { return nodesAtRest(m_X_AE); }
    [[nodiscard]] std::vector<Vec3> nodesAtRest(const RigidTransform& X_AE) const;
    /// Where a node is along the guide. @pre it was laid along one
    [[nodiscard]] double alongGuide(std::size_t node) const { return m_drawn[node].along; }
    /// By how much it is held farther back than it should be, as it was stopped.
    [[nodiscard]] double heldBack() const { return m_heldBack; }
    /// Length from the first node to another, metres.
    [[nodiscard]] double along(std::size_t node) const { return double(node) * m_length; }

    static constexpr std::size_t kHeld = 2; ///< nodes that what holds it determines
    static constexpr double kMostOn = 2e-3; ///< metres; of ours

private:
    struct Turn {
        double byFirst = 0.0, bySecond = 0.0; ///< k_i
        double stiffness = 1.0;               ///< B_i of a unit of B
    };
    struct Axes {
        Vec3 first, second; ///< M_i, unit, perpendicular
    };

    [[nodiscard]] double improve(const RodHold& hold, const Vec3& load);
    [[nodiscard]] bool isFolded() const;
    void beginAsDrawn();
    void place(const RodHold& hold);
    void carryAxes(std::span<const Vec3> nodes, const Vec3& across);
    void addBending(double inFreeSpace);
    void addTension();
    void addDrag();
    void takeTension();
    void go(std::size_t node, const Vec3& way, const RodGuide& guide);
    void holdBack(double stop);
    void draw(const RodHold& hold);
    [[nodiscard]] Vec3 bentBeyondRest(std::size_t node) const;
    [[nodiscard]] double perUnit() const; ///< B / l^3

    double m_stiffness;
    std::vector<Vec3> m_rest; ///< in E
    double m_length = 0.0;    ///< l
    Vec3 m_across_E;          ///< the first axis at the first segment
    std::vector<Turn> m_turns;

    RigidTransform m_X_AE;
    double m_heldBack = 0.0;
    int m_lost = 0; ///< steps, to the latest
    // As it is solved: beyond walls, and stretched, by micrometres.
    WalledWays m_walled;
    std::vector<Vec3> m_solved;
    std::vector<std::size_t> m_segments; ///< of the guide
    std::vector<Axes> m_axes;
    std::vector<double> m_tensions; ///< of the segments, in units of B / l^3
    // As it is drawn.
    std::vector<GuidedPlace> m_drawn;
    std::vector<Vec3> m_nodes;
};

} // namespace carina
