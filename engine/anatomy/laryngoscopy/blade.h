#pragma once

#include "engine/core/units.h"
#include "engine/geometry/deformation/blade_field.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace carina
{

/// The blades of laryngoscopes that there are.
enum class BladeKind : std::uint8_t {
    Macintosh0, ///< curved; for the newborn
    Macintosh1, ///< for infants and small children
    Macintosh2, ///< for older children and small adults
    Macintosh3,
    Macintosh4,
    Miller0,        ///< straight, with a tip that rises a little; for the newborn
    Miller1,        ///< for infants
    Miller2,        ///< for children
    Hyperangulated, ///< bent so much that one cannot see past it
};
inline constexpr std::array kBladeKinds{
    BladeKind::Macintosh0, BladeKind::Macintosh1, BladeKind::Macintosh2,
    BladeKind::Macintosh3, BladeKind::Macintosh4, BladeKind::Miller0,
    BladeKind::Miller1,    BladeKind::Miller2,    BladeKind::Hyperangulated};

/// What the tip of a blade lifts the epiglottis by.
enum class EpiglottisLift : std::uint8_t {
    Ligament, ///< the tip is in the vallecula and pulls at the hyoepiglottic ligament
    Direct,   ///< the tip is behind the epiglottis and lifts it itself
};

/// One kind of blade, in the frame L of BladeForm.
struct Blade {
    std::string_view name; ///< in commands and logs: "macintosh-3"
    BladeForm form;
    EpiglottisLift lift = EpiglottisLift::Ligament;
    Length cameraToTip; ///< along the blade, where it is a video laryngoscope's
};

/// Lengths are those that makers' catalogues call by these sizes (Macintosh 0, 1, 2, 3, 4: about
/// 80, 90, 105, 130, 155 mm; Miller 0, 1, 2: 78, 102, 155 mm). The other sizes are of ours, as no
/// published profiles were found: a Macintosh sags by 0.09 of its length; a hyperangulated blade
/// turns by 76 degrees from heel to tip, 42 of them within its middle half, as its makers say about
/// 60; cameras are about a third of the way from the tip.
[[nodiscard]] const Blade& bladeOf(BladeKind kind);

/// The blade with this name; nothing for an unknown name.
[[nodiscard]] std::optional<BladeKind> bladeFromName(std::string_view name);

/// The blade that a tool's name tells, as "Macintosh 4" or "blade miller-2"; nothing where it tells
/// none.
[[nodiscard]] std::optional<BladeKind> bladeOfTool(std::string_view name);

/// How far a place is from the underside of a blade, along y of L: above 0 where the place is on
/// the side of palate and upper teeth, less than 0 where it would be inside the blade or beyond. Of
/// a place before the heel or beyond the tip, from the face as it would go straight on.
[[nodiscard]] Length belowUnderside(const BladeForm& form, const Vec3& p_L);

/// Vertical field of view of a video laryngoscope with a picture of 4:3: the usual 80 degrees along
/// the diagonal.
inline constexpr Angle kScopeFieldOfView = degrees(53.4);

/// X_LD of the camera of a video laryngoscope (D: +x right, +y up, looking along -z): on the
/// underside, kScopeBelowBlade away from it, looking ahead so that the tip is in the upper part of
/// the picture.
[[nodiscard]] RigidTransform cameraOnBlade(const Blade& blade);
inline constexpr Length kScopeBelowBlade = millimetres(6.0);

/// X_AD of the eye of who looks past a blade: at kReadingDistance in front of the upper incisors,
/// on the line from what is to be seen through the gap between teeth and blade; up in its picture
/// is what is in front in the patient.
/// @pre the target is not in the incisors
[[nodiscard]] RigidTransform eyePastBlade(const Blade& blade, const RigidTransform& X_AL,
                                          const Vec3& p_A_incisors, const Vec3& p_A_target);
inline constexpr Length kReadingDistance = millimetres(300.0);

} // namespace carina
