#include "evaluation/intubation/intubation_motion.h"

#include "engine/anatomy/laryngoscopy/blade_levering.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carina
{
namespace
{

constexpr double kTubeChord = 0.04; ///< metres of way, before the tip is through the teeth
constexpr Length kReadyBeforeTeeth = millimetres(30.0); ///< in front of the teeth, in an adult
const Vec3 kBladeAside_A{0.0, -0.12, 0.12};
constexpr double kLookedAt_s = 0.05;

/// The place of a tube's centreline that has this distance from its tip, the nearest along it;
/// nothing where the tube is too short.
std::optional<Vec3> centreAtDistance(const std::vector<Vec3>& p_E_centre, double distance)
{
    const Vec3& p_E_tip = p_E_centre.back();
    for (std::size_t i = p_E_centre.size() - 1; i > 0; --i) {
        const Vec3 a = p_E_centre[i] - p_E_tip;
        const Vec3 step = p_E_centre[i - 1] - p_E_centre[i];
        if ((a + step).norm() < distance)
            continue;
        // |a + share * step| = distance, with |a| below it
        const double half = a.dot(step) / step.squaredNorm();
        const double rest = (distance * distance - a.squaredNorm()) / step.squaredNorm();
        return Vec3{p_E_centre[i] + (std::sqrt(half * half + rest) - half) * step};
    }
    return std::nullopt;
}

/// Arc length from the place of a line that is nearest to p to the line's end.
double lengthAfter(std::span<const Vec3> line, const Vec3& p)
{
    double least = std::numeric_limits<double>::infinity();
    double before = 0.0;
    double nearest = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec3 step = line[i] - line[i - 1];
        const double share = std::clamp(step.dot(p - line[i - 1]) / step.squaredNorm(), 0.0, 1.0);
        const double distance = (line[i - 1] + share * step - p).norm();
        if (distance < least) {
            least = distance;
            nearest = before + share * step.norm();
        }
        before += step.norm();
    }
    return before - nearest;
}

} // namespace

Result<IntubationMotion> IntubationMotion::make(std::shared_ptr<const MotionPatient> patient,
                                                TubeShape tube, const Blade& blade,
                                                MotionTracks tracks, MotionGrip grip,
                                                std::vector<MotionCommand> commands,
                                                Duration length)
{
    IntubationMotion motion;
    motion.m_patient = std::move(patient);
    motion.m_tube = std::move(tube);
    motion.m_tube.pieces.clear(); // nothing is drawn of it
    motion.m_blade = blade;
    motion.m_tracks = std::move(tracks);
    motion.m_grip = grip;
    motion.m_commands = std::move(commands);
    motion.m_length = length;
    motion.tabulateBlade();
    const AirwayForBlade& airway = motion.m_patient->forBlade;
    const LaryngoscopyPose atTeeth = laryngoscopyPose(
        airway.upper, airway.throat, blade, LaryngoscopyStep::Teeth, grip.lift, airway.held);
    motion.m_X_AL_ready =
        RigidTransform::translation(-airway.upper.size() * kReadyBeforeTeeth.si * motion.inward_A())
        * atTeeth.X_AL;
    motion.m_X_AL_aside = RigidTransform::translation(kBladeAside_A) * motion.m_X_AL_ready;
    for (double t = 0.0; t <= toSeconds(length); t += kLookedAt_s)
        if (!motion.tubeAt(t))
            return fail(Errc::OutOfRange, "the tube is too short for its way");
    return motion;
}

MotionMoment IntubationMotion::at(Duration t) const
{
    const double seconds = toSeconds(t);
    const NeckField neck = neckAt(seconds);
    const RigidTransform& X_AU = neck.X_AU();
    const auto tube = tubeAt(seconds);
    return {.X_AE = X_AU * (tube ? tube->X_AE : m_tube.X_AE),
            .X_AL = laryngoscopeAt(t),
            .X_AJ = jawAt(seconds),
            .head = neck.position()};
}

RigidTransform IntubationMotion::laryngoscopeAt(Duration t) const
{
    return neckAt(toSeconds(t)).X_AU() * bladeAt(toSeconds(t));
}

HeadPosition IntubationMotion::headAt(Duration t) const { return neckAt(toSeconds(t)).position(); }

std::vector<Vec3> IntubationMotion::tubeLine(Duration t) const
{
    const auto tube = tubeAt(toSeconds(t));
    return tube ? tube->line(m_tube.p_E_centre) : std::vector<Vec3>{};
}

TrueTip IntubationMotion::tipAt(Duration t) const
{
    const double seconds = toSeconds(t);
    TrueTip tip = heldTipAt(seconds);
    const NeckField neck = neckAt(seconds);
    if (!neck.isBent())
        return tip;
    const TipWay& way = m_patient->way(tip.target);
    const RigidTransform X_AJ = jawAt(seconds);
    // What of the tube is in the patient keeps its length; a way hardly changes its own.
    constexpr int kSteps = 3;
    const double inside = lengthOfWay(*m_patient, way, way.teeth, tip.along, {X_AJ, {}}).si;
    for (int i = 0; i < kSteps; ++i)
        tip.along += inside - lengthOfWay(*m_patient, way, way.teeth, tip.along, {X_AJ, neck}).si;
    tip.p_A = placeOnWay(*m_patient, way, tip.along, {X_AJ, neck});
    return tip;
}

Length IntubationMotion::bladePastTeeth(Duration t) const
{
    const Vec3 p_A_tip = bladeAt(toSeconds(t)) * middleOfBlade(m_blade.form, 1.0);
    return metres(inward_A().dot(p_A_tip - m_patient->airway.p_A_incisors));
}

Length IntubationMotion::depthAtTeeth(Duration t) const
{
    const TrueTip tip = heldTipAt(toSeconds(t));
    if (tip.along <= m_patient->way(tip.target).teeth)
        return {};
    return metres(lengthAfter(tubeLine(t), m_patient->airway.p_A_incisors));
}

Length IntubationMotion::tipAboveCarina(Duration t) const
{
    const TrueTip tip = tipAt(t);
    const TipWay& way = m_patient->way(tip.target);
    const double seconds = toSeconds(t);
    return lengthOfWay(*m_patient, way, tip.along, way.carina, {jawAt(seconds), neckAt(seconds)});
}

NeckField IntubationMotion::neckAt(double seconds) const
{
    const AirwayLandmarks& l = m_patient->airway;
    return {l.p_A_glottis, l.p_A_incisors, {radians(m_tracks.flexion.at(seconds)), {}}};
}

/// The direction of the ways at the teeth, into the mouth.
Vec3 IntubationMotion::inward_A() const
{
    constexpr double kAhead = 0.01;
    const TipWay& way = m_patient->way(TipTarget::Trachea);
    return (pointAlong(way.line_A, metres(way.teeth + kAhead))
            - pointAlong(way.line_A, metres(way.teeth)))
        .normalized();
}

/// What is between two entries is interpolated: it takes long to find how a blade passes the teeth.
void IntubationMotion::tabulateBlade()
{
    constexpr int kLast = 3 * kBladePoses; // LaryngoscopyStep::Full
    const AirwayForBlade& airway = m_patient->forBlade;
    for (int i = 0; i <= kLast; ++i) {
        const LaryngoscopyPose pose =
            laryngoscopyPose(airway.upper, airway.throat, m_blade, 1.0 + double(i) / kBladePoses,
                             m_grip.lift, airway.held);
        m_inside.push_back({pose.X_AL, pose.X_AJ});
    }
}

IntubationMotion::BladePose IntubationMotion::bladeInside(double value) const
{
    const double entry = std::clamp(value * kBladePoses, 0.0, double(m_inside.size() - 1));
    const auto before = std::min(static_cast<std::size_t>(entry), m_inside.size() - 2);
    const double share = entry - double(before);
    const BladePose& a = m_inside[before];
    const BladePose& b = m_inside[before + 1];
    return {interpolate(a.X_AL, b.X_AL, share), interpolate(a.X_AJ, b.X_AJ, share)};
}

RigidTransform IntubationMotion::jawAt(double seconds) const
{
    const double blade = m_tracks.blade.at(seconds);
    const RigidTransform open = bladeInside(std::max(blade, 0.0)).X_AJ;
    if (blade >= 0.0)
        return open;
    const double byBlade = std::clamp(blade + 2.0, 0.0, 1.0);
    return interpolate({}, open, std::lerp(m_tracks.jaw.at(seconds), 1.0, byBlade));
}

RigidTransform IntubationMotion::bladeAt(double seconds) const
{
    const double value = m_tracks.blade.at(seconds);
    RigidTransform X_AL = bladeInside(std::max(value, 0.0)).X_AL;
    if (value < -1.0)
        X_AL = interpolate(m_X_AL_ready, m_X_AL_aside, -1.0 - value);
    else if (value < 0.0)
        X_AL = interpolate(X_AL, m_X_AL_ready, -value);
    if (const double angle = m_tracks.lever.at(seconds); angle > 0.0)
        X_AL = levered(m_blade.form, X_AL, m_patient->forBlade.upper.p_A_edge(), radians(angle));
    return RigidTransform::translation(m_grip.bladeHand.at(seconds)) * X_AL;
}

TrueTip IntubationMotion::heldTipAt(double seconds) const
{
    const auto turn =
        std::prev(std::ranges::upper_bound(m_tracks.turns.begin() + 1, m_tracks.turns.end(),
                                           seconds, {}, &MotionTracks::Turn::from_s));
    const TipWay& way = m_patient->way(turn->target);
    const HeldTissue tissue{jawAt(seconds), {}};
    const Vec3 trembling = m_grip.tubeHand.at(seconds); // along, and across to both sides
    const double along = way.teeth + m_tracks.tip.at(seconds) + trembling.x();
    constexpr double kBefore = 0.002;
    const Vec3 p_A = placeOnWay(*m_patient, way, along, tissue);
    const Vec3 ahead = p_A - placeOnWay(*m_patient, way, along - kBefore, tissue);
    const Vec3 across = ahead.cross(Vec3::UnitX()).stableNormalized();
    return {turn->target, along, p_A + trembling.y() * Vec3::UnitX() + trembling.z() * across};
}

std::optional<BentTube> IntubationMotion::tubeAt(double seconds) const
{
    return m_grip.bending == TubeBending::Rigid ? rigidTubeAt(seconds) : elasticTubeAt(seconds);
}

std::optional<BentTube> IntubationMotion::rigidTubeAt(double seconds) const
{
    const TrueTip tip = heldTipAt(seconds);
    const TipWay& way = m_patient->way(tip.target);
    const double alongSecond = std::min(tip.along - kTubeChord, way.teeth);
    const Vec3 chord_A =
        tip.p_A - m_grip.corner_A - placeOnWay(*m_patient, way, alongSecond, {jawAt(seconds), {}});
    const auto p_E_second = centreAtDistance(m_tube.p_E_centre, chord_A.norm());
    if (!p_E_second)
        return std::nullopt;
    const auto axes_A = acrossAxesOf(chord_A);
    const auto axes_E = acrossAxesOf(m_tube.p_E_tip - *p_E_second);
    if (!axes_A || !axes_E)
        return std::nullopt;
    const Quat roll = rotationFromVector(m_grip.roll.si * chord_A.normalized());
    const Quat q_AE = roll * Quat{Mat3{*axes_A * axes_E->transpose()}};
    return BentTube{
        {q_AE, tip.p_A - q_AE * m_tube.p_E_tip}, {tip.p_A}, lengthOf(m_tube.p_E_centre)};
}

std::optional<BentTube> IntubationMotion::elasticTubeAt(double seconds) const
{
    const TrueTip tip = heldTipAt(seconds);
    const TipWay& way = m_patient->way(tip.target);
    const TissueAroundWay tissue = tissueAt(seconds);
    const CorridorEnds ends{.held = std::min(tip.along - kTubeChord, way.teeth),
                            .corner_A = m_grip.corner_A,
                            .tip = tip.along,
                            .p_A_tip = tip.p_A};
    return bentTube(tubeCorridor(*m_patient, way, tissue, ends, 0.5 * m_tube.outerDiameter),
                    m_tube.p_E_centre, m_grip.roll);
}

TissueAroundWay IntubationMotion::tissueAt(double seconds) const
{
    TissueAroundWay tissue{.X_AJ = jawAt(seconds)};
    const FollowingThroat throat{m_patient->throat, tissue.X_AJ * m_patient->held.inverse()};
    const UpperAirway airway = followed(m_patient->upper, throat);
    const RigidTransform X_AL = bladeAt(seconds);
    if (isInMouth(airway, m_blade, X_AL))
        tissue.blade = bladeInTissue(airway, m_blade, X_AL);
    return tissue;
}

TubeShape lengthened(TubeShape tube, Length whole)
{
    std::vector<Vec3>& centre = tube.p_E_centre;
    const double missing = (whole - lengthOf(centre)).si;
    if (missing <= 0.0)
        return tube;
    const Vec3 outwards = (centre[0] - centre[1]).normalized();
    centre.insert(centre.begin(), Vec3{centre[0] + missing * outwards});
    return tube;
}

Result<TubeShape> motionTube(const AirwayLandmarks& airway, Length innerDiameter, Length whole)
{
    return makeTube(innerDiameter, airway.path_A, airway.p_A_incisors,
                    usualTipAboveCarina(innerDiameter))
        .map([whole](TubeShape&& tube) { return lengthened(std::move(tube), whole); });
}

std::optional<Length> tubeInside(const MotionPatient& patient, const TubeShape& tube,
                                 TubeBending bending, const TipWay& way, double along)
{
    if (bending == TubeBending::Rigid) {
        const HeldTissue tissue{patient.held, {}};
        const Vec3 chord_A =
            placeOnWay(patient, way, along, tissue) - placeOnWay(patient, way, way.teeth, tissue);
        const auto p_E_atTeeth = centreAtDistance(tube.p_E_centre, chord_A.norm());
        return p_E_atTeeth ? std::optional{metres(lengthAfter(tube.p_E_centre, *p_E_atTeeth))}
                           : std::nullopt;
    }
    const CorridorEnds ends{.held = way.teeth,
                            .tip = along,
                            .p_A_tip = placeOnWay(patient, way, along, {patient.held, {}})};
    const auto bent =
        bentTube(tubeCorridor(patient, way, {patient.held}, ends, 0.5 * tube.outerDiameter),
                 tube.p_E_centre, {});
    return bent ? std::optional{lengthOf(bent->p_A_inside)} : std::nullopt;
}

const Blade& motionBlade(const UpperAirway& upper)
{
    if (upper.size() >= 0.9)
        return bladeOf(BladeKind::Macintosh3);
    if (upper.size() >= 0.65)
        return bladeOf(BladeKind::Macintosh2);
    return bladeOf(upper.size() >= 0.5 ? BladeKind::Miller1 : BladeKind::Miller0);
}

} // namespace carina
