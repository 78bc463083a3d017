#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"

#include "engine/anatomy/airway/centreline.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace carina
{
namespace
{

/// Blade and jaw in one step. The incisors are 98 mm from the hinge: 20 degrees open them by 34 mm,
/// within the mouth openings of adults (32 to 77 mm); the jaw comes forward as in a jaw thrust.
struct StepFigures {
    Angle opening;
    Length forward;
    double lift = 0.0; ///< of the whole
};
struct NamedStep {
    const char* name;
    StepFigures figures;
};
constexpr std::array kSteps{NamedStep{"teeth", {degrees(16.0), millimetres(0.0), 0.0}},
                            NamedStep{"uvula", {degrees(18.0), millimetres(0.0), 0.0}},
                            NamedStep{"epiglottis", {degrees(20.0), millimetres(0.0), 0.0}},
                            NamedStep{"partial_view", {degrees(20.0), millimetres(5.5), 0.7}},
                            NamedStep{"full_view", {degrees(20.0), millimetres(8.0), 1.0}}};

const NamedStep& namedStep(LaryngoscopyStep step)
{
    return kSteps.at(static_cast<std::size_t>(step));
}

/// Where a progress is: from one step a share of the way to another.
struct BetweenSteps {
    LaryngoscopyStep from;
    LaryngoscopyStep to;
    double share;
};

BetweenSteps betweenSteps(double progress)
{
    const double within = std::clamp(progress, 0.0, double(kSteps.size() - 1));
    const double from = std::floor(within);
    return {static_cast<LaryngoscopyStep>(from), static_cast<LaryngoscopyStep>(std::ceil(within)),
            within - from};
}

StepFigures figuresAt(const BetweenSteps& at)
{
    const StepFigures& a = namedStep(at.from).figures;
    const StepFigures& b = namedStep(at.to).figures;
    return {a.opening + at.share * (b.opening - a.opening),
            a.forward + at.share * (b.forward - a.forward), std::lerp(a.lift, b.lift, at.share)};
}

/// Midway between the condyles of the reference man, behind and above the edge of his upper
/// incisors, as shares of the way from these to his glottis (87.6 mm).
const Vec3 kJawHinge{0.0, 87.0 / 87.6, 45.0 / 87.6};

/// Lengths of the tip's way are those of an adult, in proportion: what is said of epiglottis and
/// larynx to the size of the larynx, the rest to that of the airway.
constexpr Length kTipBelowTeeth = millimetres(9.0);
constexpr Length kTipBeforeEpiglottis = millimetres(14.0);
constexpr Length kTipInVallecula = millimetres(4.0); ///< in front of the epiglottis
constexpr Length kTipBehindEpiglottis = millimetres(5.0);
constexpr double kUvulaShare = 0.55; ///< of the way from the teeth to the epiglottis
constexpr double kIntoTongue = 0.5;  ///< of the way from its back to the straight line
constexpr double kDirectShare = 0.6; ///< of the epiglottis' height, where a straight tip lifts it

constexpr Length kReachOfLigament = millimetres(18.0); ///< above the vallecula, where a tip is felt
constexpr double kLever = 1.2; ///< of the vallecula's way forward over that of the tip
constexpr Length kMostTilt = millimetres(18.0);       ///< of the vallecula
constexpr Length kBehindThickness = millimetres(2.0); ///< from the epiglottis' middle to its back

/// The hinge of the larynx, from the base of the epiglottis: below the cords. What lies so far
/// behind that base tilts wholly, higher up what lies farther back, too, and arytenoids little.
constexpr Length kHingeBelow = millimetres(10.0);
constexpr Length kHingeBehind = millimetres(8.0);
constexpr double kHingeSlope = 0.4;
constexpr Length kFadesBehind = millimetres(14.0);

double sizeOf(const UpperAirway& airway) { return airway.size(); }

/// No farther than the mouth opens.
Angle withinMouth(const UpperAirway& airway, Angle opening)
{
    if (!airway.mostOpening)
        return opening;
    const double toIncisors = sizeOf(airway) * kReferenceWay.si * kJawHinge.norm();
    const double most = 2.0 * std::asin(std::min(0.5 * airway.mostOpening->si / toIncisors, 1.0));
    return radians(std::min(opening.si, most));
}

RigidTransform jawIn(const UpperAirway& airway, const StepFigures& step)
{
    const double size = sizeOf(airway);
    const Angle opening = withinMouth(airway, step.opening);
    const Vec3 p_A_hinge = airway.p_A_incisors + size * kReferenceWay.si * kJawHinge;
    return RigidTransform::translation(p_A_hinge - size * step.forward.si * Vec3::UnitY())
           * RigidTransform{rotationFromVector(opening.si * Vec3::UnitX()), Vec3::Zero()}
           * RigidTransform::translation(-p_A_hinge);
}

/// A blade in the midsagittal plane with its tip at a place, ahead at an angle from the feet to the
/// back; x of L is to the patient's right, as it is for who stands behind the head.
RigidTransform bladeAt(const BladeForm& form, const Vec3& p_A_tip, Angle ahead)
{
    Mat3 R_AL;
    R_AL.col(0) = -Vec3::UnitX();
    R_AL.col(1) = Vec3{0.0, -std::cos(ahead.si), -std::sin(ahead.si)};
    R_AL.col(2) = R_AL.col(0).cross(R_AL.col(1));
    return {Quat{R_AL}, p_A_tip - R_AL * middleOfBlade(form, 1.0)};
}

/// The same, turned about its tip so that it passes the teeth: the clearance grows with the angle.
RigidTransform pastTeeth(const BladeForm& form, const Vec3& p_A_tip, const Vec3& p_A_incisors)
{
    constexpr int kHalvings = 40;
    double least = degrees(40.0).si;
    double most = degrees(115.0).si;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = std::midpoint(least, most);
        const RigidTransform X_AL = bladeAt(form, p_A_tip, radians(middle));
        const Length clearance = belowUnderside(form, X_AL.inverse() * p_A_incisors);
        (clearance < kTeethClearance ? least : most) = middle;
    }
    return bladeAt(form, p_A_tip, radians(most));
}

/// The height above the base of the epiglottis, along the trachea.
double heightOf(const UpperAirway& airway, const Vec3& p_A)
{
    return airway.up_A.dot(p_A - airway.p_A_epiglottisBase);
}

/// A place of the epiglottis at a height.
Vec3 onEpiglottis(const UpperAirway& airway, double height)
{
    const Vec3 whole = airway.p_A_epiglottisTip - airway.p_A_epiglottisBase;
    return airway.p_A_epiglottisBase + height / airway.up_A.dot(whole) * whole;
}

/// Along the way over the tongue, up to the place nearest to the tip of the epiglottis.
Centreline wayToEpiglottis(const UpperAirway& moved)
{
    const auto nearest = std::ranges::min_element(moved.path_A, {}, [&](const Vec3& p_A) {
        return (p_A - moved.p_A_epiglottisTip).squaredNorm();
    });
    return {moved.path_A.begin(), nearest + 1};
}

/// Where the tip is before the lift that takes it to the floor of the vallecula, or deeper behind
/// the epiglottis.
Vec3 placedTip(const UpperAirway& moved, const Blade& blade, Length lift)
{
    const double size = moved.larynxSize();
    if (blade.lift == EpiglottisLift::Ligament) {
        const double above = -lift.si * moved.up_A.dot(liftDirection(moved));
        return moved.p_A_vallecula + size * kTipInVallecula.si * moved.forward_A()
               + above * moved.up_A;
    }
    const double height = kDirectShare * heightOf(moved, moved.p_A_epiglottisTip);
    return onEpiglottis(moved, height) - size * kTipBehindEpiglottis.si * moved.forward_A();
}

/// Pressed into the tongue at a length of the way over it: between it and the straight line.
Vec3 overTongue(const UpperAirway& moved, const Centreline& way, Length along)
{
    const Vec3 straight =
        moved.p_A_incisors + along / lengthOf(way) * (moved.p_A_vallecula - moved.p_A_incisors);
    return pointAlong(way, along) + kIntoTongue * (straight - pointAlong(way, along));
}

Vec3 tipIn(LaryngoscopyStep step, const UpperAirway& moved, const Blade& blade, Length lift)
{
    const double size = sizeOf(moved);
    const Centreline way = wayToEpiglottis(moved);
    switch (step) {
    case LaryngoscopyStep::Teeth:
        return moved.p_A_edge() - size * kTipBelowTeeth.si * Vec3::UnitZ();
    case LaryngoscopyStep::Uvula:
        return overTongue(moved, way, kUvulaShare * lengthOf(way));
    case LaryngoscopyStep::Epiglottis:
        if (blade.lift == EpiglottisLift::Direct)
            return overTongue(moved, way, lengthOf(way) - size * kTipBeforeEpiglottis);
        return moved.p_A_vallecula
               + moved.larynxSize()
                     * (kTipInVallecula.si * moved.forward_A() + kReachOfLigament.si * moved.up_A);
    case LaryngoscopyStep::Partial:
    case LaryngoscopyStep::Full:
        break;
    }
    return placedTip(moved, blade, lift);
}

/// How far forward the epiglottis is taken at its vallecula by what pulls at the ligament.
double pulledBy(const UpperAirway& moved, const Vec3& p_A_tip)
{
    const double size = moved.larynxSize();
    const double over = heightOf(moved, p_A_tip - moved.p_A_vallecula + moved.p_A_epiglottisBase);
    const double felt = 1.0 - formula::step(over / (size * kReachOfLigament.si)).value;
    const double forward =
        moved.forward_A().dot(p_A_tip - moved.p_A_vallecula) - size * kTipInVallecula.si;
    return felt * kLever * std::max(forward, 0.0);
}

/// An epiglottis that has fallen back tilts wholly, too. Its vallecula is above its base and its
/// tip far above that, however a jaw has turned them.
LarynxHinge hingeOf(const UpperAirway& moved)
{
    constexpr double kLeastRise = 0.1; // of its length
    const double size = moved.larynxSize();
    const Vec3 whole = moved.p_A_epiglottisTip - moved.p_A_epiglottisBase;
    const double rise = std::max(kLeastRise * whole.norm(), moved.up_A.dot(whole));
    const double lean = -moved.forward_A().dot(whole) / rise;
    const Vec3 p_A_hinge = moved.p_A_epiglottisBase - size * kHingeBelow.si * moved.up_A
                           - size * kHingeBehind.si * moved.forward_A();
    return {.p_A = p_A_hinge,
            .up_A = moved.up_A,
            .forward_A = moved.forward_A(),
            .height = metres(
                std::max(size * kHingeBelow.si, moved.up_A.dot(moved.p_A_vallecula - p_A_hinge))),
            .behind = size * kFadesBehind,
            .slope = std::max(kHingeSlope, lean)};
}

/// The share by which a place goes with a tilted larynx.
double tiltingShare(const LarynxHinge& hinge, const Vec3& p_A)
{
    BladeField tilted;
    tilted.tiltLarynx(hinge, hinge.behind);
    return larynxTilt<double>(tilted.frame(), p_A).d.dot(hinge.forward_A) / hinge.behind.si;
}

/// What of a blade lifts the epiglottis: its tip, or where the tip is deeper than kDirectShare of
/// the epiglottis' height, what of the blade is at that height.
Vec3 liftingPlace(const UpperAirway& moved, const BladeForm& form, const RigidTransform& X_AL)
{
    constexpr int kHalvings = 30;
    const double height = kDirectShare * heightOf(moved, moved.p_A_epiglottisTip);
    const auto placeAt = [&](double along) { return Vec3{X_AL * middleOfBlade(form, along)}; };
    const auto isDeeper = [&](double along) { return heightOf(moved, placeAt(along)) < height; };
    if (!isDeeper(1.0) || isDeeper(0.0))
        return placeAt(1.0);
    double above = 0.0;
    double deeper = 1.0;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = std::midpoint(above, deeper);
        (isDeeper(middle) ? deeper : above) = middle;
    }
    return placeAt(above);
}

/// The same by what of a blade is behind it.
double liftedBy(const UpperAirway& moved, const Vec3& p_A_blade, const LarynxHinge& hinge)
{
    const double height = heightOf(moved, p_A_blade);
    if (height <= 0.0 || height > heightOf(moved, moved.p_A_epiglottisTip))
        return 0.0;
    const Vec3 p_A_lifted = onEpiglottis(moved, height);
    const double behind = moved.forward_A().dot(p_A_blade - p_A_lifted);
    const double wanted = behind + kBladeHalfThickness + moved.larynxSize() * kBehindThickness.si;
    constexpr double kLeastShare = 0.01;
    return std::max(wanted, 0.0) / std::max(tiltingShare(hinge, p_A_lifted), kLeastShare);
}

/// That of who is smaller than a small adult is less, and with a straight blade in children less
/// than in proportion: it holds the epiglottis itself, and more than opens the view would take
/// tongue and floor of the mouth off the throat behind them.
Length liftIn(const UpperAirway& airway, EpiglottisLift by, Length lift)
{
    constexpr double kSmallAdult = 0.9;
    constexpr double kChild = 0.85; // of that
    constexpr double kStraightInChildren = 0.75;
    const double share = std::min(sizeOf(airway) / kSmallAdult, 1.0);
    if (by == EpiglottisLift::Ligament)
        return share * lift;
    const double grown = std::max(share - kChild, 0.0) / (1.0 - kChild);
    return share * std::lerp(kStraightInChildren, 1.0, grown) * lift;
}

/// How far the vallecula is taken forward at most, metres: as far as a blade goes for a larynx of
/// the size of its airway; for a smaller one less, so that nothing folds behind it.
double mostTilt(const UpperAirway& moved)
{
    constexpr double kSmallLarynx = 1.5; // 1.93 times where it fades; BladeField allows 2
    return std::min(sizeOf(moved), kSmallLarynx * moved.larynxSize()) * kMostTilt.si;
}

double distanceToWay(const Centreline& way, const Vec3& p_A)
{
    double least = (p_A - way.front()).norm();
    for (std::size_t i = 1; i < way.size(); ++i) {
        const Vec3 step = way[i] - way[i - 1];
        const double length = step.squaredNorm();
        const double share = length > 0.0 ? step.dot(p_A - way[i - 1]) / length : 0.0;
        least = std::min(least, (p_A - way[i - 1] - std::clamp(share, 0.0, 1.0) * step).norm());
    }
    return least;
}

} // namespace

const char* stepName(LaryngoscopyStep step) { return namedStep(step).name; }

double liftShare(LaryngoscopyStep step) { return namedStep(step).figures.lift; }

Vec3 liftDirection(const UpperAirway& airway)
{
    return (airway.forward_A() - airway.up_A).normalized();
}

std::array<Vec3, 4> restingWay(const UpperAirway& moved, const Blade& blade)
{
    const auto placeIn = [&](LaryngoscopyStep step) { return tipIn(step, moved, blade, {}); };
    return {placeIn(LaryngoscopyStep::Teeth), placeIn(LaryngoscopyStep::Uvula),
            placeIn(LaryngoscopyStep::Epiglottis), placeIn(LaryngoscopyStep::Full)};
}

BladeField bladeInTissue(const UpperAirway& moved, const Blade& blade, const RigidTransform& X_AL)
{
    BladeField field{blade.form, X_AL};
    const Vec3 p_A_tip = X_AL * middleOfBlade(blade.form, 1.0);
    const LarynxHinge hinge = hingeOf(moved);
    const double forward = blade.lift == EpiglottisLift::Ligament
                               ? pulledBy(moved, p_A_tip)
                               : liftedBy(moved, liftingPlace(moved, blade.form, X_AL), hinge);
    field.tiltLarynx(hinge, metres(std::min(forward, mostTilt(moved))));
    return field;
}

bool isInMouth(const UpperAirway& moved, const Blade& blade, const RigidTransform& X_AL)
{
    const Vec3 p_A_tip = X_AL * middleOfBlade(blade.form, 1.0);
    const double distance =
        std::min(distanceToWay(moved.path_A, p_A_tip), (p_A_tip - moved.p_A_vallecula).norm());
    return distance <= sizeOf(moved) * kMostFromWay.si;
}

LaryngoscopyPose laryngoscopyPose(const UpperAirway& airway, const ThroatField& throat,
                                  const Blade& blade, LaryngoscopyStep step, Length lift,
                                  const RigidTransform& held, const NeckField& neck)
{
    return laryngoscopyPose(airway, throat, blade, double(step), lift, held, neck);
}

LaryngoscopyPose laryngoscopyPose(const UpperAirway& airway, const ThroatField& throat,
                                  const Blade& blade, double progress, Length lift,
                                  const RigidTransform& held, const NeckField& neck)
{
    const BetweenSteps at = betweenSteps(progress);
    const StepFigures figures = figuresAt(at);
    const Length whole = liftIn(airway, blade.lift, lift);
    LaryngoscopyPose pose;
    pose.X_AJ = jawIn(airway, figures);
    pose.lift = figures.lift * whole;
    const UpperAirway moved = followed(airway, {throat, pose.X_AJ * held.inverse(), neck});
    const UpperAirway inHead = seenFrom(neck.X_AU().inverse(), moved);
    const Vec3 p_U_from = tipIn(at.from, inHead, blade, whole);
    const Vec3 p_U_placed = p_U_from + at.share * (tipIn(at.to, inHead, blade, whole) - p_U_from);
    const Vec3 p_U_tip = p_U_placed + pose.lift.si * liftDirection(inHead);
    pose.X_AL = neck.X_AU() * pastTeeth(blade.form, p_U_tip, inHead.p_A_edge());
    pose.field = bladeInTissue(moved, blade, pose.X_AL);
    return pose;
}

} // namespace carina
