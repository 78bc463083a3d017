#include "engine/anatomy/laryngoscopy/blade_levering.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carina
{
namespace
{

/// Ways of a blade's tip along the handle, each at least 0.
struct TipWays {
    Length turned{};
    Length lifted{};

    [[nodiscard]] double share() const
    {
        return turned.si > 0.0 ? turned / (turned + lifted) : 0.0;
    }
};

TipWays waysSince(const RigidTransform& X_AL_from, const RigidTransform& X_AL,
                  const BladeForm& form, const Vec3& p_A_incisors)
{
    const Vec3 p_L_tip = middleOfBlade(form, 1.0);
    const Vec3 p_A_from = X_AL_from * p_L_tip;
    const Vec3 across = X_AL_from.rotation() * Vec3::UnitX();
    const Vec3 handle = X_AL_from.rotation() * Vec3::UnitY();
    const Vec3 turn = rotationVector(X_AL.rotation() * X_AL_from.rotation().inverse());
    const Vec3 arm = p_A_from - p_A_incisors;
    const Quat pitch = rotationFromVector(turn.dot(across) * across);
    const double turned = (pitch * arm - arm).dot(handle);
    const double all = (X_AL * p_L_tip - p_A_from).dot(handle);
    return {metres(std::max(turned, 0.0)), metres(std::max(all - turned, 0.0))};
}

/// 1 on the teeth, 0 from kTeethLetGo on.
double touching(Length clearance)
{
    return std::clamp((kTeethLetGo - clearance) / (kTeethLetGo - kTeethTouched), 0.0, 1.0);
}

BladeHandling handlingAfter(BladeHandling before, const BladeEffort& now, Length turned)
{
    const bool wasLevering = before == BladeHandling::Levering;
    const bool isLevering = now.isOnTeeth
                            && now.leveringShare >= (wasLevering ? kLeversUntil : kLeversFrom)
                            && turned >= (wasLevering ? kTurnedUntil : kTurnedFrom);
    if (isLevering)
        return BladeHandling::Levering;
    const Length least = before == BladeHandling::Neither ? kLiftsFrom : kLiftsUntil;
    return now.contact.tongueDepth >= least ? BladeHandling::Lifting : BladeHandling::Neither;
}

RigidTransform turnedAbout(const Vec3& p_A, const RigidTransform& X_AL, Angle angle)
{
    const Vec3 across = X_AL.rotation() * Vec3::UnitX();
    return RigidTransform::translation(p_A)
           * RigidTransform{rotationFromVector(angle.si * across), Vec3::Zero()}
           * RigidTransform::translation(-p_A) * X_AL;
}

} // namespace

const char* handlingName(BladeHandling handling)
{
    switch (handling) {
    case BladeHandling::Neither:
        return "neither";
    case BladeHandling::Lifting:
        return "lifting";
    case BladeHandling::Levering:
        break;
    }
    return "levering";
}

BladeEffort LeveringWatch::take(const UpperAirway& moved, const Blade& blade,
                                const RigidTransform& X_AL, const RigidTransform& X_AU)
{
    BladeEffort effort{.contact = bladeContact(moved, blade, X_AL)};
    const Length clearance = effort.contact.teethClearance.value_or(kTeethLetGo);
    if (clearance >= kTeethLetGo)
        m_X_UL.reset();
    else if (!m_X_UL && clearance <= kTeethTouched)
        m_X_UL = X_AU.inverse() * X_AL;
    effort.isOnTeeth = m_X_UL.has_value();
    TipWays ways;
    if (m_X_UL) {
        ways = waysSince(X_AU * *m_X_UL, X_AL, blade.form, moved.p_A_edge());
        const Force answer = springForce(moved.size() * kTongueStiffness, ways.turned);
        effort.leveringShare = ways.share();
        effort.teeth = std::max(touching(clearance) * std::min(answer, effort.contact.tongue),
                                effort.contact.teethByDepth);
    }
    m_handling = handlingAfter(m_handling, effort, ways.turned);
    effort.handling = m_handling;
    return effort;
}

RigidTransform levered(const BladeForm& form, const RigidTransform& X_AL, const Vec3& p_A_incisors,
                       Angle angle)
{
    constexpr int kHalvings = 40;
    const Vec3 p_A_tip = X_AL * middleOfBlade(form, 1.0);
    const auto isFree = [&](double turn) {
        const RigidTransform turned = turnedAbout(p_A_tip, X_AL, radians(turn));
        return belowUnderside(form, turned.inverse() * p_A_incisors) > Length{};
    };
    if (isFree(angle.si))
        return turnedAbout(p_A_tip, X_AL, angle);
    double least = 0.0;
    double most = angle.si;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = std::midpoint(least, most);
        (isFree(middle) ? least : most) = middle;
    }
    return turnedAbout(p_A_incisors, turnedAbout(p_A_tip, X_AL, radians(least)),
                       radians(angle.si - least));
}

} // namespace carina
