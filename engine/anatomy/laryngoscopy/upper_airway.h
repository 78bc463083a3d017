#pragma once

#include "engine/anatomy/anatomy.h"
#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/deformation/airway_field.h"
#include "engine/geometry/deformation/throat_field.h"

#include <optional>
#include <span>

namespace carina
{

/// The trachea's wall at kNarrowingOfWindpipe below the cords, in A, metres.
struct WindpipePlace {
    Vec3 p_A_middle = Vec3::Zero(); ///< between its sides, and between its front and back
    Length halfWidth{};             ///< from there to the outside of its wall
    Length halfDepth{};
};

/// From the middle of the glottis to the carina in the reference man.
inline constexpr Length kReferenceWindpipe = millimetres(127.0);
/// Where a trachea is narrowed, below the middle of his glottis: the second to fourth ring.
inline constexpr Length kNarrowingOfWindpipe = millimetres(42.0);

/// The places by which a laryngoscope finds its way and what it shows is measured, in A, metres.
struct UpperAirway {
    Vec3 p_A_incisors = Vec3::Zero(); ///< midpoint of the upper incisors' edge
    Vec3 p_A_uvula = Vec3::Zero();    ///< its tip
    Vec3 p_A_epiglottisBase = Vec3::Zero();
    Vec3 p_A_epiglottisTip = Vec3::Zero(); ///< middle of its free edge
    Vec3 p_A_vallecula = Vec3::Zero();     ///< in front of the epiglottis, at kValleculaHeight
    Vec3 p_A_commissure = Vec3::Zero();    ///< anterior: where both cords meet in front
    Vec3 p_A_notch = Vec3::Zero();         ///< interarytenoid: between their ends behind
    Vec3 up_A = Vec3::UnitZ();             ///< along the trachea towards the head; unit
    std::vector<Vec3> path_A;              ///< of a tube, from the incisors to the glottis
    std::optional<Vec3> p_A_tongue;        ///< its middle, where there is one
    std::optional<Vec3> p_A_upperLip;      ///< their middles in the midplane, where there are any
    std::optional<Vec3> p_A_lowerLip;
    Length toCarina{};                     ///< from the middle of the glottis
    std::optional<WindpipePlace> windpipe; ///< where there is a trachea
    std::optional<Vec3> p_A_neck;          ///< the skin in front of that, where there is any
    bool hasIncisors = false;              ///< whether teeth are where the incisors' edge is
    Vec3 d_A_incisors = Vec3::Zero();      ///< by which events have moved this edge
    std::optional<Length> mostOpening;     ///< of the mouth at the incisors, where events limit it
    double drawnOut = 1.0;                 ///< the way from incisors to glottis, by a bent neck

    /// To the front, perpendicular to up_A; unit.
    [[nodiscard]] Vec3 forward_A() const;
    /// Length of the glottis, from commissure to notch.
    [[nodiscard]] Length glottis() const;
    /// Of the way from the incisors to the middle of the glottis in a neck that is not bent,
    /// kReferenceWay being 1.
    [[nodiscard]] double size() const;
    /// Of the larynx with its epiglottis: by the length of the glottis, kReferenceGlottis being 1,
    /// between a quarter of size() and size(). A child's is small for the way to it.
    [[nodiscard]] double larynxSize() const;
    /// Of the way from the middle of the glottis to the carina, kReferenceWindpipe being 1.
    [[nodiscard]] double windpipeSize() const { return toCarina / kReferenceWindpipe; }
    /// The upper incisors' edge as events have moved it.
    [[nodiscard]] Vec3 p_A_edge() const { return p_A_incisors + d_A_incisors; }
};

/// That way in the reference man.
inline constexpr Length kReferenceWay = millimetres(87.6);

/// A glottis that is in proportion to the way from the incisors: shorter than a man's open one (23
/// mm, Miller, 6th edition), so that the larynx of grown people has the size of their airway.
inline constexpr Length kReferenceGlottis = millimetres(20.0);

/// Height of the vallecula's floor, as a share of the way from the epiglottis' base to its tip: of
/// ours. Its free part is about two thirds of its length.
inline constexpr double kValleculaHeight = 0.3;

/// Finds these places from surfaces and landmarks of a patient:
///
/// - epiglottis: the part of that role, its lowest and highest places near the midplane;
/// - cords: the parts whose names contain "vocal", but not "vestibular"; their ends in front and
///   behind;
/// - uvula: the lowest place of the part whose name contains "uvula", or else "soft palate";
/// - tongue: the mean of the vertices of that role, in the midplane; it may be missing;
/// - lips: of the parts for which isLip holds, the mean of the vertices near the midplane; they may
///   be missing;
/// - windpipe: how far the part of that role reaches at its level; it may be missing;
/// - neck: the foremost of the skin near the midplane at the same level; it may be missing.
///
/// @returns NoAirway with what is missing
[[nodiscard]] Result<UpperAirway> upperAirwayOf(std::span<const AnatomyPart> parts,
                                                const AirwayLandmarks& landmarks);

/// Whether a part is called "upper lip" or "lower lip", in capitals or not.
[[nodiscard]] bool isLip(const AnatomyPart& part);

/// The same places where events have changed their tissue, before they follow the jaw. The way of a
/// tube stays.
[[nodiscard]] UpperAirway changed(UpperAirway airway, const AirwayField& changes);

/// The same places as a neck has taken them.
[[nodiscard]] UpperAirway bent(UpperAirway airway, const NeckField& neck);

/// The same places after they have moved with head and neck and followed the jaw; the jaw leaves
/// palate, lips, tongue and incisors.
[[nodiscard]] UpperAirway followed(UpperAirway airway, const FollowingThroat& throat);

/// The angles between the axes by which positions of the head are compared (Adnet et al,
/// Anesthesiology 2001;94:83): that of the mouth, parallel to the hard palate, which is +y of the
/// head; the line of sight from the incisors to the middle of the glottis; and that of the larynx.
struct AirwayAxes {
    Angle mouthToSight;
    Angle sightToLarynx;
};
/// @param airway as the neck has taken it
[[nodiscard]] AirwayAxes airwayAxes(const UpperAirway& airway, const NeckField& neck);

/// The same places in another frame F that is at X_FA; up_A and the like are then given in F.
[[nodiscard]] UpperAirway seenFrom(const RigidTransform& X_FA, UpperAirway airway);

} // namespace carina
