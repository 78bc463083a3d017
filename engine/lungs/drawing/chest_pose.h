#pragma once

#include "engine/anatomy/chest/chest_region.h"
#include "engine/geometry/deformation/chest_field.h"
#include "engine/lungs/drawing/volume_cubic.h"

#include <array>
#include <optional>

namespace carina
{

/// The amplitude of each mode of motion of one lung; all 0 at functional residual capacity, supine.
struct LungPose {
    /// 1 lowers the base by 7.5 % of the lungs' height at the back and by 11 % of it in front. The
    /// base under the domes, which lies higher, moves less. A quiet breath takes 2.3.
    double diaphragm = 0.0;
    /// 1 moves the front forward by 1.8 % of the lungs' height and the side outward by up to two
    /// thirds of that; a quiet breath takes 1.6.
    double ribs = 0.0;
    /// 1 moves the inside of the lung by 4 % of the lungs' height towards the back, -1 towards the
    /// front, relative to its place supine.
    double gravity = 0.0;
    /// The share of its extent that a lung loses towards its hilum; negative where it is inflated,
    /// as by trapped gas.
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

/// Quiet breathing, supine. Diaphragm and gravity are in the ratio fitted to landmarks in the lungs
/// of five people. The ribs move more than in that fit, as was measured from outside. A direction
/// only: drawnPose() gives the ribs the share of the breath that is the patient's, 35 to 45 % by
/// sex and age (ChestShape::ribShare, docs/deformation.md).
inline constexpr LungPose kQuietBreath{1.0, 0.65, 0.15, 0.0};

/// The shape of a whole chest.
struct ChestPose {
    std::array<LungPose, 2> lungs; ///< right, left
    /// Shift of the mediastinum towards the patient's left, as a share of half the chest's width.
    double mediastinalShift = 0.0;
    /// Where chest wall and diaphragm of each side stand, when not with the lungs: gas or liquid
    /// lies between. Their collapse is 0.
    std::optional<std::array<LungPose, 2>> walls{};

    friend bool operator==(const ChestPose&, const ChestPose&) = default;
};

/// Index of a side in arrays of two lungs: right 0, left 1.
[[nodiscard]] constexpr std::size_t indexOf(Side side) { return side == Side::Right ? 0 : 1; }

/// How a region moves in a pose. Each lung moves by its own pose; what lies between or around the
/// lungs moves on each side with the lung of that side.
///
/// - Bronchi move with the lungs. So does the diaphragm, except by a collapse, unless
///   ChestPose::walls says where it stands; its attachment below the lungs hardly moves.
/// - The wall moves forward and outward with the lung beneath it (or as ChestPose::walls says), and
///   upward besides, while the lung slides down along it.
/// - Lower lobes slide along the oblique fissure, forward and down, by 0.15 % of the lungs' height
///   (0.4 mm in an adult) in the middle of the lung at diaphragm 1.
/// - The mediastinum only shifts.
[[nodiscard]] ChestMotion motionOf(ChestRegion region, const ChestPose& pose,
                                   const ChestField& field);

/// The range of poses in which the field keeps its orientation, that is det(I + grad d) > 0.1
/// everywhere in the box of the lungs and a fifth of its size around it. With the limits below,
///
///     max (diaphragm, ribs, gravity, each / its limit) + collapse / its limit
///         + shift into the lung / kMostShift <= 1
///
/// and a shift away from a lung is at most kMostShift. The limit of the collapse is
/// kMostCollapseAlone where a lung does nothing else.
///
/// @returns the left side of this inequality, for the lung for which it is greater; infinity where
///          the shift exceeds kMostShift.
[[nodiscard]] double rangeTaken(const ChestPose& pose);

inline constexpr double kLeastBreath = -3.0;    ///< diaphragm and ribs, expiration
inline constexpr double kGreatestBreath = 10.0; ///< ribs, inspiration
/// Diaphragm, inspiration: its sheet above the attachment is then flat, and lies within the skin.
inline constexpr double kMostDescent = 4.2;
inline constexpr double kMostGravity = 1.6;  ///< either way
inline constexpr double kMostCollapse = 0.4; ///< a fifth of the volume is left
/// Of a lung with no other amplitude: a sixth of the volume is left, and a quarter of it where the
/// mediastinum is shifted away from it by a quarter of half the chest's width.
inline constexpr double kMostCollapseAlone = 0.46;
/// 4.1 times the volume. At -0.65 the lungs of an obese patient who sits with COPD would come out
/// of the skin, below.
inline constexpr double kLeastCollapse = -0.6;
inline constexpr double kMostShift = 0.4; ///< of half the chest's width, either way

/// The amplitudes s for which the pose given + s along of a lung is within the range, in a chest
/// whose mediastinum is shifted towards this lung by `shiftInto` (negative away from it).
///
/// @returns nothing where no amplitude is within the range.
/// @pre `along` is not all 0.
[[nodiscard]] std::optional<AmplitudeRange>
amplitudesWithin(const LungPose& given, const LungPose& along, double shiftInto);

/// The pose with every amplitude multiplied by `factor`, at most as far as the range allows: for
/// teaching, where the true motion is hard to see. The drawn volumes are then not those of the
/// patient, and a view must say so.
[[nodiscard]] ChestPose exaggerated(const ChestPose& pose, double factor);

} // namespace carina
