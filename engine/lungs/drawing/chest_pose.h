#pragma once

#include "engine/anatomy/chest/chest_region.h"
#include "engine/geometry/deformation/chest_field.h"
#include "engine/lungs/drawing/volume_cubic.h"

#include <array>
#include <optional>

namespace carina
{

/// How far each way of moving has gone in one lung; 0 at functional residual capacity, lying down.
struct LungPose {
    /// 1 lowers the base by 7.5 % of the lungs' height at the back and by 11 % of that in front.
    /// The base of the domes lies higher and goes less; a quiet breath takes 2.3.
    double diaphragm = 0.0;
    /// 1 moves the front forward by 1.8 % of the lungs' height and the side outward by up to two
    /// thirds of that; a quiet breath takes 1.6.
    double ribs = 0.0;
    /// 1 lets the inside of the lung sink by 4 % of the lungs' height towards the back, as in
    /// someone who lies on it; -1 towards the front.
    double gravity = 0.0;
    /// The share of its extent that a lung loses towards its hilum; below 0 what it gains, as
    /// where air is trapped in it.
    double collapse = 0.0;

    friend LungPose operator+(const LungPose& a, const LungPose& b)
    {
        return {a.diaphragm + b.diaphragm, a.ribs + b.ribs, a.gravity + b.gravity,
                a.collapse + b.collapse};
    }
    friend LungPose operator*(double k, const LungPose& a)
    {
        return {k * a.diaphragm, k * a.ribs, k * a.gravity, k * a.collapse};
    }
    friend bool operator==(const LungPose&, const LungPose&) = default;
};

/// Breathing, lying down. Diaphragm and inside go together as the landmarks of five people did; the
/// ribs take the larger part in it that lets them make room for two fifths of the gas, as was
/// measured from outside (docs/deformation.md).
inline constexpr LungPose kQuietBreath{1.0, 0.65, 0.15, 0.0};

/// The shape of a whole chest.
struct ChestPose {
    std::array<LungPose, 2> lungs; ///< right, left
    /// How far what lies between the lungs has gone to the left, of half the chest's width.
    double mediastinalShift = 0.0;

    friend bool operator==(const ChestPose&, const ChestPose&) = default;
};

[[nodiscard]] constexpr std::size_t indexOf(Side side) { return side == Side::Right ? 0 : 1; }

/// What moves a region in a pose. The lungs' motion is their own; what lies between or around both
/// goes with each on its side.
///
/// - Diaphragm and bronchi go with the lungs, and the diaphragm stays where a lung collapses.
/// - The wall goes forward and outward with the lungs beneath, and upward besides, while the lungs
///   slide down along it.
/// - Lower lobes slide along the oblique fissure, forward and down, by 0.15 % of the lungs' height
///   (0.4 mm in an adult) in the middle of the lung at diaphragm 1.
/// - The mediastinum shifts, and otherwise stays.
[[nodiscard]] ChestMotion motionOf(ChestRegion region, const ChestPose& pose,
                                   const ChestField& field);

/// Poses in which the field keeps its orientation: det (I + grad d) > 0.2 everywhere in the box of
/// the lungs and a fifth of its size around it. With the limits below,
///
///     max (diaphragm, ribs, gravity, each / its limit) + collapse / its limit
///         + shift into the lung / kMostShift <= 1
///
/// while the shift away from a lung is at most kMostShift.
///
/// @returns the left side of this, for the lung for which it is greater; infinity for a greater
///          shift.
[[nodiscard]] double rangeTaken(const ChestPose& pose);

inline constexpr double kLeastBreath = -3.0;    ///< diaphragm and ribs, breathed out
inline constexpr double kGreatestBreath = 10.0; ///< breathed in
inline constexpr double kMostGravity = 1.6;     ///< either way
inline constexpr double kMostCollapse = 0.37;   ///< a quarter of the volume is left
inline constexpr double kLeastCollapse = -0.55; ///< 3.7 times the volume
inline constexpr double kMostShift = 0.25;

/// The amplitudes s for which a lung may be posed as given + s along, in a chest whose mediastinum
/// is shifted towards this lung by `shiftInto` (negative away from it).
///
/// @returns nothing where no amplitude is within the range.
/// @pre `along` is not rest.
[[nodiscard]] std::optional<AmplitudeRange>
amplitudesWithin(const LungPose& given, const LungPose& along, double shiftInto);

/// The pose with every departure from rest multiplied: for teaching, where the true motion is hard
/// to see. Drawn volumes are then not those of the patient, and a view must say so. As far as the
/// range goes.
[[nodiscard]] ChestPose exaggerated(const ChestPose& pose, double factor);

} // namespace carina
