#include "engine/tracking/simulated/scripted_hands.h"

#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina
{

namespace
{

// The tube's part of a period, as phases from 0 to 1.
constexpr double kBroughtInFrom = 0.10;
constexpr double kInPlaceFrom = 0.50;
constexpr double kWithdrawnFrom = 0.70;

constexpr double kChord = 0.04;         // m of path, of the tube before it is through the teeth
constexpr double kShortestChord = 0.01; // m; a shorter one is that of a path that turns back
constexpr int kWaypoints = 400;
constexpr double kParallel = 1e-3; // rad, to x

// From the incisors, in A: x to the patient's left, y posterior, z superior.
const Vec3 kCondyles = 0.088 * Vec3{0.0, std::cos(degrees(26.0).si), std::sin(degrees(26.0).si)};
const Vec3 kChin{0.0, 0.0, -0.045};
const Vec3 kEyes{0.0, -0.30, 0.30};
const Vec3 kBesideCheek{0.13, 0.03, 0.0};
const Vec3 kGrip{0.0, 0.0, 0.03}; // of the hand that holds the tube, in E
const Vec3 kSceneCentre{0.05, -0.14, -0.03};
const Vec3 kTracker = 1.25 * Vec3{3.0, -1.0, 0.0}.normalized(); // from the centre of the scene

constexpr Angle kOpenMouth = degrees(20.0);
constexpr Angle kMouthAroundTube = degrees(8.0);
constexpr double kSway = 0.02; // m

/// 0 before `from`, 1 after `until`, and between them a rise with no speed at either end.
double eased(double x, double from, double until)
{
    const double u = std::clamp((x - from) / (until - from), 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

/// The axes (across, third, direction) of a direction and the x axis, each in some frame; nothing
/// where there is no direction or it is that of x.
std::optional<Mat3> axesAlong(const Vec3& direction)
{
    const double length = direction.norm();
    if (length == 0.0)
        return std::nullopt;
    const Vec3 along = direction / length;
    const Vec3 across = Vec3::UnitX() - along.x() * along;
    if (across.norm() < kParallel)
        return std::nullopt;
    Mat3 axes;
    axes << across.normalized(), along.cross(across.normalized()), along;
    return axes;
}

/// X_AV of a view V from p_A_eye to p_A_target: -z ahead, +y as far anterior as it can.
RigidTransform lookingAt(const Vec3& p_A_eye, const Vec3& p_A_target)
{
    const Vec3 back = (p_A_eye - p_A_target).normalized();
    const Vec3 right = (-Vec3::UnitY()).cross(back).normalized();
    Mat3 R_AV;
    R_AV << right, back.cross(right), back;
    return {Quat{R_AV}, p_A_eye};
}

std::size_t nearestIndex(const std::vector<Vec3>& points, const Vec3& p)
{
    const auto nearest =
        std::ranges::min_element(points, {}, [&p](const Vec3& q) { return (q - p).squaredNorm(); });
    return static_cast<std::size_t>(nearest - points.begin());
}

bool allFinite(const HandScript& script)
{
    const auto isFinite = [](const Vec3& p) { return p.allFinite(); };
    return isFinite(script.p_A_incisors) && std::isfinite(script.restAboveCarina.si)
           && isFinite(script.X_TA.translation()) && std::ranges::all_of(script.path_A, isFinite)
           && std::ranges::all_of(script.p_E_centre, isFinite);
}

bool turnsBack(const std::vector<Vec3>& p_E_centre)
{
    return std::ranges::adjacent_find(p_E_centre,
                                      [&](const Vec3& back, const Vec3& front) {
                                          return (back - p_E_centre.back()).norm()
                                                 < (front - p_E_centre.back()).norm();
                                      })
           != p_E_centre.end();
}

} // namespace

Result<ScriptedHands> ScriptedHands::make(HandScript script)
{
    if (!allFinite(script))
        return fail(Errc::NotFinite, "a number of the scripted hands is not finite");
    if (script.path_A.empty() || script.p_E_centre.empty() || script.period <= Duration::zero())
        return fail(Errc::OutOfRange, "the scripted hands have no path, no tube or no period");
    ScriptedHands hands{std::move(script)};
    const std::vector<Vec3>& path_A = hands.m_script.path_A;
    hands.m_along.push_back(0.0);
    for (std::size_t i = 1; i < path_A.size(); ++i)
        hands.m_along.push_back(hands.m_along.back() + (path_A[i] - path_A[i - 1]).norm());
    hands.m_alongAtTeeth = hands.m_along[nearestIndex(path_A, hands.m_script.p_A_incisors)];
    hands.m_turnsBack = turnsBack(hands.m_script.p_E_centre);
    const double rest = hands.m_script.restAboveCarina.si;
    if (rest < 0.0 || rest >= hands.m_along.back())
        return fail(Errc::OutOfRange, "the path of the tube is too short for its final depth");
    if (!hands.layWaypoints(hands.m_along.back() - rest))
        return fail(Errc::OutOfRange,
                    "the path of the tube has no direction or the tube is too short");
    return hands;
}

bool ScriptedHands::layWaypoints(double end)
{
    std::optional<RigidTransform> lastX_AE;
    for (int i = 0; i <= kWaypoints; ++i) {
        Waypoint next{.along = end * i / kWaypoints};
        const std::optional<RigidTransform> X_AE = tubeAlong(next.along);
        if (!X_AE)
            return false;
        if (lastX_AE) {
            const double tip = next.along - m_waypoints.back().along;
            const double connector = (X_AE->translation() - lastX_AE->translation()).norm();
            next.travel = m_waypoints.back().travel + std::max(tip, connector);
        }
        m_waypoints.push_back(next);
        lastX_AE = X_AE;
    }
    return true;
}

std::optional<RigidTransform> ScriptedHands::operator()(ToolRole tool, SessionTime t) const
{
    const double phase = phaseAt(t);
    switch (tool) {
    case ToolRole::Head:
        return m_script.X_TA * headAt(phase);
    case ToolRole::Jaw:
        return m_script.X_TA * jawAt(phase);
    case ToolRole::Tube:
        return tubeAt(phase);
    case ToolRole::Stylus:
        return m_script.X_TA
               * RigidTransform::translation(stylusBesideCheek(m_script.p_A_incisors));
    case ToolRole::Hand: {
        const auto X_TE = tubeAt(phase);
        return X_TE ? std::optional{*X_TE * handOnTube()} : std::nullopt;
    }
    case ToolRole::Manikin:
    case ToolRole::Chest:
    case ToolRole::Laryngoscope:
    case ToolRole::Other:
        break;
    }
    return std::nullopt;
}

RigidTransform ScriptedHands::closedJaw() const
{
    return RigidTransform::translation(m_script.p_A_incisors + kChin);
}

double ScriptedHands::phaseAt(SessionTime t) const
{
    const Duration into = t.time_since_epoch() % m_script.period;
    const Duration positive = into < Duration::zero() ? into + m_script.period : into;
    return toSeconds(positive) / toSeconds(m_script.period);
}

/// Before its first point the path goes on straight.
Vec3 ScriptedHands::pathPoint(double along) const
{
    const std::vector<Vec3>& path_A = m_script.path_A;
    const auto after = std::ranges::upper_bound(m_along, along);
    if (after == m_along.end())
        return path_A.back();
    const auto i = std::max<std::size_t>(1, static_cast<std::size_t>(after - m_along.begin()));
    const double share = (along - m_along[i - 1]) / (m_along[i] - m_along[i - 1]);
    return path_A[i - 1] + share * (path_A[i] - path_A[i - 1]);
}

/// The point of the tube's centreline that is so far from its tip along it, in E; nothing where the
/// tube is too short.
std::optional<Vec3> ScriptedHands::centreAt(double fromTip) const
{
    const std::vector<Vec3>& p_E_centre = m_script.p_E_centre;
    for (std::size_t i = p_E_centre.size() - 1; i > 0; --i) {
        const Vec3 step = p_E_centre[i - 1] - p_E_centre[i];
        if (fromTip <= step.norm())
            return p_E_centre[i] + fromTip / step.norm() * step;
        fromTip -= step.norm();
    }
    return std::nullopt;
}

/// The point of the tube's centreline nearest to the tip along it that has this distance from the
/// tip, in E; nothing where the tube is too short.
std::optional<Vec3> ScriptedHands::centreAtDistance(double fromTip) const
{
    const std::vector<Vec3>& p_E_centre = m_script.p_E_centre;
    const Vec3& p_E_tip = p_E_centre.back();
    for (std::size_t i = p_E_centre.size() - 1; i > 0; --i) {
        const Vec3 a = p_E_centre[i] - p_E_tip;
        const Vec3 step = p_E_centre[i - 1] - p_E_centre[i];
        if ((a + step).norm() < fromTip)
            continue;
        // |a + share * step| = fromTip, with |a| below it
        const double half = a.dot(step) / step.squaredNorm();
        const double rest = (fromTip * fromTip - a.squaredNorm()) / step.squaredNorm();
        return p_E_centre[i] + (std::sqrt(half * half + rest) - half) * step;
    }
    return std::nullopt;
}

std::optional<RigidTransform> ScriptedHands::tubeAlong(double along) const
{
    const Vec3 p_A_tip = pathPoint(along);
    const double alongSecond = std::min(along - kChord, m_alongAtTeeth);
    const Vec3 chord_A = p_A_tip - pathPoint(alongSecond);
    if (chord_A.norm() < kShortestChord)
        return std::nullopt;
    const std::optional<Vec3> p_E_second =
        m_turnsBack ? centreAt(along - alongSecond) : centreAtDistance(chord_A.norm());
    if (!p_E_second)
        return std::nullopt;
    const Vec3& p_E_tip = m_script.p_E_centre.back();
    const std::optional<Mat3> axes_A = axesAlong(chord_A);
    const std::optional<Mat3> axes_E = axesAlong(p_E_tip - *p_E_second);
    if (!axes_A || !axes_E)
        return std::nullopt;
    const Quat q_AE{Mat3{*axes_A * axes_E->transpose()}};
    return RigidTransform{q_AE, p_A_tip - q_AE * p_E_tip};
}

std::optional<RigidTransform> ScriptedHands::tubeAt(double phase) const
{
    const double share =
        eased(phase, kBroughtInFrom, kInPlaceFrom) - eased(phase, kWithdrawnFrom, 1.0);
    const double travel = share * m_waypoints.back().travel;
    const auto next = std::ranges::upper_bound(m_waypoints, travel, {}, &Waypoint::travel);
    const Waypoint& b = next == m_waypoints.end() ? m_waypoints.back() : *next;
    const Waypoint& a = *std::prev(next);
    const double step = b.travel - a.travel;
    const double along =
        step > 0.0 ? a.along + (travel - a.travel) / step * (b.along - a.along) : b.along;
    const std::optional<RigidTransform> X_AE = tubeAlong(along);
    return X_AE ? std::optional{m_script.X_TA * *X_AE} : std::nullopt;
}

RigidTransform ScriptedHands::jawAt(double phase) const
{
    const double shutsFrom = kInPlaceFrom + 0.02;
    const double opensAgain = kWithdrawnFrom - 0.07;
    const Angle opening = kOpenMouth * (eased(phase, 0.0, 0.15) - eased(phase, 0.92, 1.0))
                          + (kMouthAroundTube - kOpenMouth)
                                * (eased(phase, shutsFrom, shutsFrom + 0.08)
                                   - eased(phase, opensAgain, kWithdrawnFrom));
    return movedJaw(m_script.p_A_incisors, opening) * closedJaw();
}

RigidTransform ScriptedHands::headAt(double phase) const
{
    const double turn = 2.0 * std::numbers::pi * phase;
    const Vec3 sway_A{kSway * std::sin(turn), 0.5 * kSway * std::sin(3.0 * turn),
                      0.5 * kSway * std::sin(2.0 * turn)};
    return lookingAt(m_script.p_A_incisors + kEyes + sway_A, m_script.p_A_incisors);
}

RigidTransform handOnTube() { return RigidTransform::translation(kGrip); }

Vec3 stylusBesideCheek(const Vec3& p_A_incisors) { return p_A_incisors + kBesideCheek; }

RigidTransform movedJaw(const Vec3& p_A_incisors, Angle opening, Length forward, double size)
{
    const Vec3 p_A_condyles = p_A_incisors + size * kCondyles;
    return RigidTransform::translation(p_A_condyles - size * forward.si * Vec3::UnitY())
           * RigidTransform{rotationFromVector(opening.si * Vec3::UnitX()), Vec3::Zero()}
           * RigidTransform::translation(-p_A_condyles);
}

RigidTransform patientBeforeTracker(const Vec3& p_A_incisors)
{
    const Vec3 p_A_centre = p_A_incisors + kSceneCentre;
    return lookingAt(p_A_centre + kTracker, p_A_centre).inverse();
}

} // namespace carina
