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

/// A tracked tube in a virtual airway, in two shapes: as measured, its curve at rest at the pose of
/// its connector; and constrained, an elastic rod that lies inside of the lumen. A fold of steps of
/// kTubeStep: deterministic, with the connector's pose and the lumen of the moment.
///
/// It is in the airway while its curve as measured passes the teeth within kBeside and its tip lies
/// behind them; otherwise it is as measured, and where no rod is found, as with its connector deep
/// in the mouth. Inside it lies along one way (AirwayWay): the one to whose middle the measured tip
/// is nearest. It goes over to another one that is nearer by kNearer, and by kNearerEach more of
/// each metre that its tip is past the fork: a tip deep in the trachea does not get into the
/// oesophagus. From the connector to kBeforeTeeth it is in free space, held by a hand and stiffer
/// by kHeldByHand, and from there on inside of the sections of the way.
///
/// The way ends where a tube so thick is stopped. A place that has become too narrow behind the tip
/// does not let go of the tube, but yields to it. One that is first seen inside is taken
/// to have passed what lies before its tip, as nobody knows how it got there.
class TubeInLumen
{
public:
    /// @param p_E_rest centre line at rest from the connector to the tip, as it was calibrated
    /// @pre the line has at least two points, and no two neighbours are equal
    TubeInLumen(const TubeSize& size, std::span<const Vec3> p_E_rest);

    /// @param p_E_rest its curve at rest from now on, as long as before; empty: as it was
    void step(const RigidTransform& X_AE, const MovedLumen& lumen,
              std::span<const Vec3> p_E_rest = {});
    /// A step of one that is found anew, with its tip about here: that tells the way that it lies
    /// in and how far it has come, in place of its curve as measured.
    /// @param isHeldUp at a place that it has not passed then: the first from kFoundBefore before
    ///                 that tip on
    void found(const RigidTransform& X_AE, const Vec3& p_A_tip, bool isHeldUp,
               const MovedLumen& lumen, std::span<const Vec3> p_E_rest = {});

    [[nodiscard]] const TubeSize& size() const { return m_size; }
    /// Centre line in A, from the connector to the tip.
    [[nodiscard]] std::span<const Vec3> constrained() const { return m_rod.nodes(); }
    [[nodiscard]] std::vector<Vec3> measured() const { return m_rod.nodesAtRest(); }
    [[nodiscard]] const TubeTip& tip() const { return m_tip; }
    /// By how much the connector is ahead of where the tube is held, as it was stopped.
    [[nodiscard]] Length heldBack() const { return metres(m_rod.heldBack()); }

    static constexpr int kPieces = 64;
    static constexpr Length kBeside = millimetres(30.0); ///< of ours, as those that follow
    static constexpr Length kNearer = millimetres(1.0);
    static constexpr double kNearerEach = 0.3;
    static constexpr double kHeldByHand = 30.0;
    static constexpr Length kBeforeTeeth = millimetres(6.0);
    static constexpr Length kFoundBefore = millimetres(10.0);

private:
    /// The way that it lies in, from in front of the teeth to its end: at first along the trunk.
    struct Way {
        AirwayWay which = AirwayWay::Trunk;
        double branch =
            0.0; ///< along the trunk: where it branches off; the end of the trunk itself
    };
    /// Of the guide, in lengths along it.
    struct OnGuide {
        double clamp = 0.0;  ///< the connector
        double join = 0.0;   ///< where it goes on along the way, `joined` along that
        double branch = 0.0; ///< where the way branches off; infinite in the trunk
        double joined = 0.0;
    };

    void lieIn(const MovedLumen& lumen, const RigidTransform& X_AE, const Vec3& p_A_tip,
               Length before = {});
    [[nodiscard]] bool isFoundInside(std::span<const Vec3> measured, const Vec3& p_A_tip,
                                     const MovedLumen& lumen) const;
    [[nodiscard]] AirwayWay nearestWay(const Vec3& p_A_tip, const MovedLumen& lumen,
                                       bool isHeld) const;
    void guideAlong(const Vec3& p_A, const Vec3& direction, const MovedLumen& lumen);
    void addSections(const MovedWay& way, double from, double until);
    [[nodiscard]] double stopAhead(double place, const MovedLumen& lumen) const;
    [[nodiscard]] double wayAt(double alongGuide) const;
    [[nodiscard]] double guideAt(double alongWay) const;
    [[nodiscard]] double tipOnWay() const { return wayAt(m_rod.alongGuide(kPieces)); }
    void judgeTip(const MovedLumen& lumen);
    [[nodiscard]] Length depthAtTeeth(const MovedLumen& lumen) const;

    TubeSize m_size;
    ElasticRod m_rod;
    RodGuide m_guide;
    OnGuide m_onGuide;
    bool m_isInside = false;
    Way m_way;
    TubeTip m_tip;
};

/// The step of the fold, seconds.
inline constexpr double kTubeStep = 0.01;

} // namespace carina
