#pragma once

#include "engine/scoring/course/try_metrics.h"
#include "tests/engine/scoring/course/hand_written_course.h"

namespace carina::test
{

/// The good try, of which all was measured: nothing in it deserves advice.
inline TryMetrics goodTry()
{
    TryMetrics metrics = courseOf(goodCourse().events(), courseTime(50.0));
    metrics.depthWanted = millimetres(200.0);
    metrics.headExtension = degrees(22.0);
    metrics.oxygen = OxygenFigures{.first = 1.0, .lowest = 0.98, .lowestAt = courseTime(29.0)};
    metrics.incisors = ForceFigures{.peakAt = courseTime(10.0)};
    metrics.tongue = ForceFigures{.peak = newtons(32.0),
                                  .peakAt = courseTime(18.0),
                                  .mean = newtons(20.0),
                                  .touched = std::chrono::seconds{12},
                                  .impulse = 240.0};
    metrics.plane = PlaneFigures{.measured = std::chrono::seconds{14}, .squaredTilt = 2.5e-3};
    metrics.hand = MotionFigures{.watched = std::chrono::seconds{14},
                                 .measured = std::chrono::seconds{13},
                                 .path = metres(0.6),
                                 .meanAcceleration = 0.5,
                                 .meanJerk = 5.0,
                                 .jerkiest = courseTime(11.0),
                                 .smoothness = -9.0};
    metrics.head = MotionFigures{.watched = std::chrono::seconds{40},
                                 .measured = std::chrono::seconds{39},
                                 .path = metres(0.3),
                                 .verticalTravel = metres(0.12),
                                 .meanAcceleration = 0.2,
                                 .meanJerk = 2.0,
                                 .jerkiest = courseTime(12.0),
                                 .smoothness = -10.0};
    metrics.checks.fill(true);
    return metrics;
}

/// Tube in the oesophagus from 20 s to the end at 80 s, not recognised.
inline TryMetrics oesophagealTry()
{
    HandWrittenCourse course;
    course.at(10.0, IntubationStep::BladeIn)
        .at(17.0, IntubationStep::TubePastTeeth)
        .at(20.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus)
        .at(24.0, IntubationStep::BladeOut)
        .at(30.0, IntubationStep::FirstBreath);
    return courseOf(course.events(), courseTime(80.0));
}

} // namespace carina::test
