#pragma once

#include "engine/airway/monitor/intubation_monitor.h"
#include "engine/anatomy/airway/airway_measure.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/geometry/rotation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <random>
#include <vector>

namespace carina::test
{

/// An airway that is drawn by hand, in the plane x = 0: a quarter of a circle from the incisors,
/// 60 mm in radius, down to the glottis, and 125 mm of straight trachea to the carina, the origin.
inline AirwayLandmarks drawnAirway()
{
    constexpr double kRadius = 0.060;
    constexpr double kTrachea = 0.125;
    constexpr int kPieces = 60;
    AirwayLandmarks airway;
    const Vec3 centre{0.0, -kRadius, kTrachea};
    for (int i = 0; i <= kPieces; ++i) {
        const double angle = 0.5 * std::numbers::pi * (1.0 - double(i) / kPieces);
        airway.path_A.emplace_back(centre + kRadius * Vec3{0.0, std::cos(angle), std::sin(angle)});
    }
    airway.p_A_incisors = airway.path_A.front();
    airway.p_A_glottis = airway.path_A.back();
    for (int i = 1; i <= 60; ++i)
        airway.path_A.emplace_back(0.0, 0.0, kTrachea * (1.0 - double(i) / 60.0));
    return airway;
}

inline PatientWays drawnWays() { return patientWays(drawnAirway(), std::nullopt, {}); }

/// Where a tube goes in truth.
enum class Route { Trachea, RightMain, LeftMain, Oesophagus };

/// The line that its tip follows, from 150 mm in front of the incisors, which are at along = 150
/// mm. In the glottis it lies behind the middle, as tubes do.
inline Centreline routeOf(const PatientWays& ways, Route route)
{
    const Vec3 in = ways.inward_A();
    Centreline line;
    for (int i = 0; i < 75; ++i)
        line.emplace_back(ways.p_A_incisors() - (0.150 - 0.002 * i) * in);
    if (route == Route::Oesophagus) {
        const auto aboveLarynx = ways.overTongue.end() - 15; // some 23 mm
        line.insert(line.end(), ways.overTongue.begin(), aboveLarynx);
        line.insert(line.end(), ways.oesophagus.begin(), ways.oesophagus.end());
        return evenlySpaced(line, millimetres(2.0));
    }
    constexpr double kBehindMiddle = 0.003;
    line.insert(line.end(), ways.overTongue.begin(), ways.overTongue.end() - 1);
    for (const Vec3& p : ways.trachea) {
        const double height = std::max(p.z() - 0.5 * ways.p_A_glottis().z(), 0.0);
        line.emplace_back(
            p + Vec3{0.0, kBehindMiddle * height / (0.5 * ways.p_A_glottis().z()), 0.0});
    }
    if (route == Route::RightMain)
        line.push_back(ways.p_A_rightEnd);
    if (route == Route::LeftMain)
        line.push_back(ways.p_A_leftEnd);
    return evenlySpaced(line, millimetres(2.0));
}

/// How far along a route its tip passes the cords' plane, from the incisors.
inline double cordsAlong(const PatientWays& ways, Route route)
{
    const Centreline line = routeOf(ways, route);
    double along = -0.150;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double before = (line[i - 1] - ways.p_A_glottis()).dot(ways.up_A());
        const double after = (line[i] - ways.p_A_glottis()).dot(ways.up_A());
        const double length = (line[i] - line[i - 1]).norm();
        if (before > 0.0 && after <= 0.0)
            return along + before / (before - after) * length;
        along += length;
    }
    return along;
}

/// How far along its route the tip is, in metres, by seconds; the blade's tip likewise along the
/// way into the mouth, from the incisors.
struct Motion {
    std::function<double(double)> tip;
    std::function<double(double)> blade = [](double) { return -0.1; };
    double seconds = 10.0;
};

/// From outside to a depth beyond the incisors at a speed, beginning at a time.
inline std::function<double(double)> inserted(double depth, double speed, double from = 1.0)
{
    return [=](double t) { return 0.150 + std::clamp(-0.060 + speed * (t - from), -0.060, depth); };
}

/// What a tracker makes of it.
struct Disturbance {
    double noise = 0.35e-3; // m, of each axis
    double dropouts = 0.02; // share of the samples
    RigidTransform X_AA{};  // the registration's error
};

/// An error of 1.5 mm and 1 degree, root mean squares, about the incisors.
inline RigidTransform drawnRegistration(std::mt19937& random, const Vec3& p_A_incisors)
{
    std::normal_distribution<double> normal;
    const auto vector = [&] { return Vec3{normal(random), normal(random), normal(random)}; };
    const double share = 1.0 / std::sqrt(3.0);
    const RigidTransform turn{rotationFromVector(share * degrees(1.0).si * vector()), Vec3::Zero()};
    return RigidTransform::translation(p_A_incisors + share * 1.5e-3 * vector()) * turn
           * RigidTransform::translation(-p_A_incisors);
}

/// What a monitor said of a run.
struct MonitoredRun {
    std::vector<IntubationEvent> events;
    IntubationCourse course;

    [[nodiscard]] std::vector<IntubationEvent> of(IntubationStep step) const
    {
        std::vector<IntubationEvent> found;
        std::ranges::copy_if(events, std::back_inserter(found),
                             [step](const IntubationEvent& event) { return event.step == step; });
        return found;
    }
};

/// The moments of a run, 50 a second.
/// @param waysAt the patient's ways at a time, as they are drawn; the tube follows those of 0 s
inline std::vector<AirwayMoment> momentsOf(
    Route route, const Motion& motion, const Disturbance& disturbance, std::mt19937& random,
    const std::function<PatientWays(double)>& waysAt = [](double) { return drawnWays(); })
{
    std::normal_distribution<double> noise{0.0, disturbance.noise};
    std::bernoulli_distribution drops{disturbance.dropouts};
    const Centreline line = routeOf(waysAt(0.0), route);
    std::vector<AirwayMoment> moments;
    for (int i = 0; i < int(50.0 * motion.seconds); ++i) {
        const double t = 0.02 * i;
        const PatientWays ways = waysAt(t);
        const Vec3 d{noise(random), noise(random), noise(random)};
        const double tip = motion.tip(t);
        std::vector<Vec3> tube;
        for (double along = std::max(tip - 0.28, 0.0); along < tip; along += 0.004)
            tube.emplace_back(disturbance.X_AA * pointAlong(line, metres(along)) + d);
        tube.emplace_back(disturbance.X_AA * pointAlong(line, metres(tip)) + d);
        const Validity seen = drops(random) ? Validity::Lost : Validity::Tracked;
        const BladeSeen blade{
            .validity = seen,
            .p_A_tip = ways.p_A_incisors() + motion.blade(t) * ways.inward_A() + d,
            .glottis = motion.blade(t) > 0.03 ? std::optional{0.6} : std::nullopt};
        moments.push_back(airwayMoment(SessionTime{fromSeconds(t)}, ways, {seen, tube, {}}, blade));
    }
    return moments;
}

inline MonitoredRun monitored(const std::vector<AirwayMoment>& moments)
{
    IntubationMonitor monitor;
    MonitoredRun run;
    for (const AirwayMoment& moment : moments)
        std::ranges::copy(monitor.take(moment), std::back_inserter(run.events));
    run.course = monitor.course();
    return run;
}

inline double secondsOf(const IntubationEvent& event)
{
    return toSeconds(event.at.time_since_epoch());
}

} // namespace carina::test
