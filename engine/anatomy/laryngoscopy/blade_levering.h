#pragma once

#include "engine/anatomy/laryngoscopy/blade_contact.h"

#include <optional>

namespace carina
{

/// How somebody handles a blade.
enum class BladeHandling : std::uint8_t {
    Neither,  ///< the tongue is hardly displaced
    Lifting,  ///< it is, and the hand carries the load
    Levering, ///< the blade lies on the upper incisors and is turned about them
};

/// "neither", "lifting" or "levering".
[[nodiscard]] const char* handlingName(BladeHandling handling);

/// What a blade touches, and how it got there.
struct BladeEffort {
    BladeContact contact;
    BladeHandling handling = BladeHandling::Neither;
    bool isOnTeeth = false;     ///< and not yet more than kTeethLetGo away from them
    double leveringShare = 0.0; ///< 0 to 1, as LeveringWatch has it
    Force teeth{};              ///< on the upper incisors
};

/// Tells levering on the teeth from lifting, and estimates what the teeth bear, from a blade's
/// poses in their order; time does not count.
///
/// Teeth that are not touched bear nothing, however a blade is turned: the hand alone does. Once
/// the blade's underside is within kTeethTouched of the incisors' edge, its motion from there is a
/// turn about the transverse axis x_L through the midpoint of that edge, by the angle a, and what
/// is left: a translation and other turns. Of the way of the tip along the handle (y of L then),
///
///     turned = (R(a) - 1) (p_tip - p_incisors) . y_L     lifted = (way of the tip) . y_L - turned
///
/// `turned` is levering, and leveringShare = turned / (turned + lifted), each at least 0. A couple
/// turns the blade there, and what the tongue answers at the tip the teeth answer at the edge, with
/// the same force: kTongueStiffness times `turned`, but no more than the tongue bears. It fades as
/// the blade leaves the teeth, up to kTeethLetGo. Where teeth would be deep inside the blade, which
/// those of a manikin cannot, and those of a patient without one can, BladeContact::teethByDepth
/// counts where it is more. All this is seen from the head, in its frame U: where a blade touched
/// the teeth goes with these, however long and far the head is moved.
class LeveringWatch
{
public:
    /// @param moved the places after they have followed the jaw
    /// @param X_AU how the head lies (NeckField::X_AU)
    BladeEffort take(const UpperAirway& moved, const Blade& blade, const RigidTransform& X_AL,
                     const RigidTransform& X_AU = {});

    /// Forgets what was before.
    void reset() { *this = {}; }

private:
    /// The blade where it touched the teeth.
    std::optional<RigidTransform> m_X_UL;
    BladeHandling m_handling = BladeHandling::Neither;
};

/// Of ours: two thresholds each, so that noise at one of them changes nothing.
inline constexpr Length kTeethTouched = millimetres(0.2);
inline constexpr Length kTeethLetGo = millimetres(1.0);
inline constexpr double kLeversFrom = 0.5; ///< leveringShare
inline constexpr double kLeversUntil = 0.3;
inline constexpr Length kTurnedFrom = millimetres(2.0); ///< of the tip
inline constexpr Length kTurnedUntil = millimetres(1.0);
inline constexpr Length kLiftsFrom = millimetres(3.0); ///< depth in the tongue
inline constexpr Length kLiftsUntil = millimetres(2.0);

/// A blade in the midsagittal plane after its handle was tipped back by an angle, as somebody does
/// who levers: about its tip until its underside meets the incisors' edge, and about this edge from
/// there on.
[[nodiscard]] RigidTransform levered(const BladeForm& form, const RigidTransform& X_AL,
                                     const Vec3& p_A_incisors, Angle angle);

} // namespace carina
