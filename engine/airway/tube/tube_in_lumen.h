#pragma once

#include "engine/airway/lumen/moved_lumen.h"
#include "engine/airway/tube/elastic_rod.h"
#include "engine/airway/tube/tube_size.h"
#include "engine/lungs/mechanics/tube_place.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace carina
{

/// Where the tip of a tube is in the airway.
struct TubeTip {
    Vec3 p_A = Vec3::Zero();
    AirwayWay way = AirwayWay::Trunk;
    TubeSeat seat = TubeSeat::None;
    bool isPastTeeth = false;
    bool isStopped = false; ///< by a place that is too narrow for it, or by the end of the way
    Length depth{};         ///< of the tube at the teeth, along the tube; 0 outside
    Length pastGlottis{};   ///< along the airway; below 0 above the cords; not in the oesophagus
    Length aboveCarina{};   ///< along the airway; below 0 beyond; not in the oesophagus
};

/// A place where the tube presses on a wall.
struct TubeContact {
    Length along{}; ///< the tube, from its connector
    Vec3 p_A = Vec3::Zero();
    Vec3 out_A = Vec3::UnitZ(); ///< unit, out of the lumen
    Force force{};              ///< by the assumed stiffness of the tube
};

/// A tracked tube in a virtual airway, in two shapes: as measured, its curve at rest at the pose of
/// its connector; and constrained, an elastic rod that stays in the lumen. A fold of steps of
/// kTubeStep: deterministic, with the connector's pose and the lumen of the moment.
///
/// Each step the nodes of the rod have one way each (AirwayWay), and the way of the tip ends where
/// a tube so thick is stopped. A place that has become too narrow behind the tip does not let go of
/// the tube, but holds it in its middle.
///
/// What of the tube lies outside of the mouth is as measured and is held by a hand: it meets no
/// wall, and is stiffer by kHeldByHand. A tip gets into the mouth through the funnel in front of
/// the teeth; one that passes beside that stays outside, until the tube as measured lies in the
/// airway from the teeth to its tip, as one does that is simulated and goes straight through a
/// chin.
///
/// A connector that moved by more than kMostAtOnce or kMostTurn within a step is moved in several;
/// where these would be more than kMostParts, as after it was lost, the tube is laid anew: in the
/// way whose middle is nearest to the measured tip, and as deep as measured, from where it comes to
/// rest without friction, as nobody knows how it got there. So it is where it has come to lie
/// outside by more than kLost, as after a lumen has jumped. That takes as long as many steps.
class TubeInLumen
{
public:
    /// @param p_E_rest centre line at rest from the connector to the tip, as it was calibrated
    /// @pre the line has at least two points, and no two neighbours are equal
    TubeInLumen(const TubeSize& size, std::span<const Vec3> p_E_rest);

    void step(const RigidTransform& X_AE, const MovedLumen& lumen);

    [[nodiscard]] const TubeSize& size() const { return m_size; }
    /// Centre line in A, from the connector to the tip.
    [[nodiscard]] std::span<const Vec3> constrained() const { return m_rod.nodes(); }
    [[nodiscard]] std::vector<Vec3> measured() const { return m_rod.nodesAtRest(); }
    /// Its length along that to each of its points.
    [[nodiscard]] Length along(std::size_t point) const { return metres(m_rod.along(point)); }
    [[nodiscard]] const TubeTip& tip() const { return m_tip; }
    [[nodiscard]] std::vector<TubeContact> contacts() const;
    /// Distance of the tips of both shapes; and the greatest of all their points.
    [[nodiscard]] Length apart() const;
    [[nodiscard]] Length farthestApart() const;
    /// By how much it lies outside the lumen where it does so most; 0 inside.
    [[nodiscard]] Length outside() const;

    static constexpr int kPieces = 64;
    static constexpr Length kMostAtOnce = millimetres(5.0); ///< of ours, as those that follow
    static constexpr Angle kMostTurn = degrees(4.0);
    static constexpr int kMostParts = 32;
    /// A tip that comes in is at most so far beyond the wall of the funnel.
    static constexpr Length kCaught = millimetres(10.0);
    static constexpr double kHeldByHand = 8.0;
    static constexpr Length kLost = millimetres(5.0);

private:
    /// The lumen around each node.
    class Walls final : public RodWall
    {
    public:
        [[nodiscard]] WallTouch at(std::size_t node, const Vec3& p_A) const override;
        void choose(const MovedLumen& lumen, std::span<const Vec3> nodes);
        /// The first node from which on the tube is inside; as many as there are nodes outside.
        [[nodiscard]] std::size_t firstInside() const { return m_firstInside; }
        /// The tube was laid anew, and is inside from this node on.
        void takeIn(std::size_t first);

        struct Node {
            AirwayWay way = AirwayWay::Trunk;
            std::size_t segment = 0;
            MovedPiece piece; ///< around where it is as a step begins; not of the tip
        };
        [[nodiscard]] const Node& node(std::size_t i) const { return m_nodes[i]; }
        [[nodiscard]] double stop(AirwayWay way) const { return m_stops[std::size_t(way)]; }

    private:
        [[nodiscard]] Node chosen(const Vec3& p_A) const;
        [[nodiscard]] double stopAhead(AirwayWay which, double place, double before) const;
        [[nodiscard]] std::size_t entered(std::span<const Vec3> nodes);
        [[nodiscard]] bool isInFront(const Vec3& p_A, Node node) const;

        const MovedLumen* m_lumen = nullptr; ///< during a step
        mutable std::vector<Node> m_nodes;   ///< the search begins where the last one ended
        std::array<double, kAirwayWays> m_stops{};
        std::size_t m_firstInside = kPieces + 1;
        bool m_isKnown = false; ///< whether the nodes have ways from the step before
    };

    void relax(const RigidTransform& X_AE, const MovedLumen& lumen);
    [[nodiscard]] bool isFoundInside(const MovedLumen& lumen) const;
    [[nodiscard]] static bool passesTeeth(std::span<const Vec3> nodes, const MovedLumen& lumen);
    void layAnew(const RigidTransform& X_AE, const MovedLumen& lumen);
    void layAlong(const MovedWay& path, const MovedLumen& lumen, std::size_t entry,
                  const RigidTransform& X_AE);
    void judgeTip(const MovedLumen& lumen);
    [[nodiscard]] Length depthAtTeeth(const MovedLumen& lumen) const;

    TubeSize m_size;
    ElasticRod m_rod;
    Walls m_walls;
    TubeTip m_tip;
    RigidTransform m_X_AE;
    bool m_hasBegun = false;
};

/// The step of the fold, seconds.
inline constexpr double kTubeStep = 0.01;

} // namespace carina
