#pragma once

#include "engine/tracking/simulated/scripted_hands.h"

#include <cmath>
#include <numbers>

namespace carina::test
{

/// A tube's way of an adult, drawn by walking in 1 mm steps in the plane x = 0: 10 cm towards the
/// incisors and 3 cm on, 20 degrees upwards; a bend of 5 cm radius down to the trachea; 12 cm down
/// it. Ends at the carina, the origin of A.
struct AirwayWalk {
    std::vector<Vec3> path_A;
    Vec3 p_A_incisors = Vec3::Zero();
};

inline AirwayWalk walkAirway()
{
    constexpr double kStep = 0.001;
    constexpr double kRadius = 0.05;
    AirwayWalk walk;
    Vec3 p = Vec3::Zero();
    double heading = degrees(20.0).si; // above posterior
    const auto step = [&] {
        walk.path_A.push_back(p);
        p += kStep * Vec3{0.0, std::cos(heading), std::sin(heading)};
    };
    for (int i = 0; i < 100; ++i)
        step();
    walk.p_A_incisors = p;
    for (int i = 0; i < 30; ++i)
        step();
    for (; heading > -0.5 * std::numbers::pi; heading -= kStep / kRadius)
        step();
    heading = -0.5 * std::numbers::pi;
    for (int i = 0; i < 120; ++i)
        step();
    walk.path_A.push_back(p);
    for (Vec3& point : walk.path_A)
        point -= p;
    walk.p_A_incisors -= p;
    return walk;
}

/// The hands of that airway, with a tube that lies along it from 5 cm in front of the incisors to
/// `rest` above the carina. In its final place +y of E points along the trachea.
inline HandScript scriptOfWalk(Length rest = millimetres(30.0))
{
    const AirwayWalk walk = walkAirway();
    HandScript script;
    script.path_A = walk.path_A;
    script.p_A_incisors = walk.p_A_incisors;
    script.X_TA = patientBeforeTracker(walk.p_A_incisors);
    script.restAboveCarina = rest;
    constexpr std::size_t kFirst = 50; // of the path's points, which are 1 mm apart
    const auto last = walk.path_A.size() - 1 - static_cast<std::size_t>(std::lround(rest.si * 1e3));
    Mat3 R_AE;
    R_AE << Vec3::UnitX(), -Vec3::UnitZ(), Vec3::UnitY();
    for (std::size_t i = kFirst; i <= last; ++i)
        script.p_E_centre.emplace_back(R_AE.transpose() * (walk.path_A[i] - walk.path_A[kFirst]));
    return script;
}

} // namespace carina::test
