#include "engine/anatomy/laryngoscopy/blade_contact.h"

#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace carina
{
namespace
{

constexpr int kEdgePoints = 15;                      ///< to either side of the incisors' midpoint
constexpr Length kEpiglottisBack = millimetres(2.0); ///< from its middle, in an adult

std::optional<Length> clearanceOfTeeth(const UpperAirway& moved, const BladeForm& form,
                                       const RigidTransform& X_AL)
{
    const RigidTransform X_LA = X_AL.inverse();
    const Vec3 half_A = moved.size() * kHalfIncisors.si * Vec3::UnitX();
    std::optional<Length> least;
    for (int i = -kEdgePoints; i <= kEdgePoints; ++i) {
        const Vec3 p_L = X_LA * Vec3{moved.p_A_edge() + double(i) / kEdgePoints * half_A};
        const double along = -p_L.z() / form.reach;
        if (std::abs(p_L.x()) > 0.5 * form.width || along < 0.0 || along > 1.0)
            continue;
        const Length clearance = belowUnderside(form, p_L);
        least = least ? std::min(*least, clearance) : clearance;
    }
    return least;
}

/// From the nearest place of a polyline to a point. @param end how far the last of it goes on, in
/// shares of its length
Vec3 fromWay(std::span<const Vec3> way, const Vec3& p_A, double end)
{
    Vec3 least = p_A - way.front();
    for (std::size_t i = 1; i < way.size(); ++i) {
        const Vec3 step = way[i] - way[i - 1];
        const double length = step.squaredNorm();
        const double share = length > 0.0 ? step.dot(p_A - way[i - 1]) / length : 0.0;
        const double most = i + 1 == way.size() ? end : 1.0;
        const Vec3 away = p_A - way[i - 1] - std::clamp(share, 0.0, most) * step;
        if (away.squaredNorm() < least.squaredNorm())
            least = away;
    }
    return least;
}

/// In the vallecula there is tissue below the tip; behind the epiglottis there is none.
Length depthInTongue(const UpperAirway& moved, const Blade& blade, const Vec3& p_A_tip)
{
    constexpr double kOpen = std::numeric_limits<double>::max();
    const auto way = restingWay(moved, blade);
    const bool isBeforeTeeth = (p_A_tip - way[0]).dot(way[1] - way[0]) <= 0.0;
    if (isBeforeTeeth)
        return {};
    Vec3 away = fromWay(way, p_A_tip, blade.lift == EpiglottisLift::Direct ? kOpen : 1.0);
    const Vec3 across = moved.up_A.cross(moved.forward_A());
    away -= away.dot(across) * across;
    return metres(liftDirection(moved).dot(away) > 0.0 ? away.norm() : 0.0);
}

bool isOnEpiglottis(const UpperAirway& moved, const Blade& blade, const RigidTransform& X_AL)
{
    if (blade.lift == EpiglottisLift::Direct)
        return !bladeInTissue(moved, blade, X_AL).frame().tilt.isZero();
    const Vec3 p_A_tip = X_AL * middleOfBlade(blade.form, 1.0);
    const Vec3 whole = moved.p_A_epiglottisTip - moved.p_A_epiglottisBase;
    const double height =
        moved.up_A.dot(p_A_tip - moved.p_A_epiglottisBase) / moved.up_A.dot(whole);
    if (height < 0.0 || height > 1.0)
        return false;
    const Vec3 p_A_epiglottis = moved.p_A_epiglottisBase + height * whole;
    const double before = moved.forward_A().dot(p_A_tip - p_A_epiglottis);
    return before < kBladeHalfThickness
           && before > -kBladeHalfThickness - moved.larynxSize() * kEpiglottisBack.si;
}

} // namespace

Force springForce(double stiffness, Length depth)
{
    return newtons(std::clamp(stiffness * depth.si, 0.0, kMostForce.si));
}

BladeContact bladeContact(const UpperAirway& moved, const Blade& blade, const RigidTransform& X_AL)
{
    BladeContact contact;
    contact.teethClearance = clearanceOfTeeth(moved, blade.form, X_AL);
    if (contact.teethClearance)
        contact.teethByDepth = springForce(kTeethStiffness, -1.0 * *contact.teethClearance);
    contact.tongueDepth = depthInTongue(moved, blade, X_AL * middleOfBlade(blade.form, 1.0));
    contact.tongue = springForce(moved.size() * kTongueStiffness, contact.tongueDepth);
    contact.isOnEpiglottis = isOnEpiglottis(moved, blade, X_AL);
    if (contact.isOnEpiglottis && blade.lift == EpiglottisLift::Direct)
        contact.epiglottis = contact.tongue;
    return contact;
}

} // namespace carina
