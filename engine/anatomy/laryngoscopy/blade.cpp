#include "engine/anatomy/laryngoscopy/blade.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

namespace carina
{
namespace
{

constexpr Length kTipAboveAxis = millimetres(16.0); ///< of the camera, where the tip is
constexpr Length kPastTeeth = millimetres(3.0);     ///< the eye's line, from their edge

constexpr std::array kBlades{
    Blade{"macintosh-0", {0.080, 0.008, 0.0072, 0.011}, EpiglottisLift::Ligament, {0.027}},
    Blade{"macintosh-1", {0.090, 0.009, 0.0081, 0.013}, EpiglottisLift::Ligament, {0.030}},
    Blade{"macintosh-2", {0.105, 0.010, 0.0095, 0.015}, EpiglottisLift::Ligament, {0.035}},
    Blade{"macintosh-3", {0.130, 0.012, 0.0117, 0.016}, EpiglottisLift::Ligament, {0.040}},
    Blade{"macintosh-4", {0.155, 0.014, 0.0140, 0.017}, EpiglottisLift::Ligament, {0.045}},
    Blade{"miller-0", {0.078, 0.003, 0.0010, 0.009}, EpiglottisLift::Direct, {0.026}},
    Blade{"miller-1", {0.102, 0.003, 0.0013, 0.011}, EpiglottisLift::Direct, {0.040}},
    Blade{"miller-2", {0.155, 0.004, 0.0020, 0.013}, EpiglottisLift::Direct, {0.045}},
    Blade{"hyperangulated", {0.095, 0.020, 0.0190, 0.018}, EpiglottisLift::Ligament, {0.035}}};

/// X_FD of an eye that looks at a target, with this direction up in its picture.
RigidTransform lookingAt(const Vec3& p_F_eye, const Vec3& p_F_target, const Vec3& up_F)
{
    Mat3 R;
    R.col(2) = (p_F_eye - p_F_target).normalized();
    R.col(0) = up_F.cross(R.col(2)).normalized();
    R.col(1) = R.col(2).cross(R.col(0));
    return {Quat{R}, p_F_eye};
}

} // namespace

const Blade& bladeOf(BladeKind kind) { return kBlades.at(static_cast<std::size_t>(kind)); }

std::optional<BladeKind> bladeFromName(std::string_view name)
{
    const auto* found = std::ranges::find_if(
        kBladeKinds, [name](BladeKind kind) { return bladeOf(kind).name == name; });
    return found == kBladeKinds.end() ? std::nullopt : std::optional{*found};
}

std::optional<BladeKind> bladeOfTool(std::string_view name)
{
    std::string words{name};
    std::ranges::transform(words, words.begin(), [](unsigned char c) {
        return std::isalnum(c) != 0 ? static_cast<char>(std::tolower(c)) : '-';
    });
    const auto* found = std::ranges::find_if(kBladeKinds, [&words](BladeKind kind) {
        return words.find(bladeOf(kind).name) != std::string::npos;
    });
    return found == kBladeKinds.end() ? std::nullopt : std::optional{*found};
}

Length belowUnderside(const BladeForm& form, const Vec3& p_L)
{
    const double face = formula::bladeFace(form.rise, form.sag, -p_L.z() / form.reach).value;
    return metres(face - kBladeHalfThickness - p_L.y());
}

RigidTransform cameraOnBlade(const Blade& blade)
{
    const double share = 1.0 - blade.cameraToTip.si / blade.form.reach;
    const Vec3 p_L_eye = middleOfBlade(blade.form, share)
                         - (kBladeHalfThickness + kScopeBelowBlade.si) * Vec3::UnitY();
    // Less on the blades of small children, whose camera is near the tip.
    const Length above = std::min(kTipAboveAxis, blade.cameraToTip - kTipAboveAxis);
    const Vec3 p_L_target = middleOfBlade(blade.form, 1.0) - above.si * Vec3::UnitY();
    return lookingAt(p_L_eye, p_L_target, Vec3::UnitY());
}

RigidTransform eyePastBlade(const Blade& blade, const RigidTransform& X_AL,
                            const Vec3& p_A_incisors, const Vec3& p_A_target)
{
    const Vec3 out_A = X_AL.rotation() * Vec3::UnitY();
    const Vec3 p_L_incisors = X_AL.inverse() * p_A_incisors;
    const double share = -p_L_incisors.z() / blade.form.reach;
    const double gap =
        middleOfBlade(blade.form, share).y() - kBladeHalfThickness - p_L_incisors.y();
    const Vec3 p_A_gap = p_A_incisors + std::clamp(0.5 * gap, 0.0, kPastTeeth.si) * out_A;
    const Vec3 away = (p_A_gap - p_A_target).normalized();
    return lookingAt(p_A_gap + kReadingDistance.si * away, p_A_target, out_A);
}

} // namespace carina
