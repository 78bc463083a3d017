#pragma once

#include "engine/airway/monitor/intubation_event.h"
#include "engine/physiology/vitals.h"

#include <cmath>
#include <vector>

namespace carina::test
{

/// Seconds of a session as a time.
inline SessionTime courseTime(double seconds)
{
    return SessionTime{std::chrono::nanoseconds{std::llround(seconds * 1e9)}};
}

inline Vitals saturatedBy(double arterialSaturation)
{
    Vitals vitals;
    vitals.arterialSaturation = arterialSaturation;
    return vitals;
}

/// The events of a try, written one after the other; the seat and the depths stay until they are
/// changed.
class HandWrittenCourse
{
public:
    HandWrittenCourse& at(double seconds, IntubationStep step)
    {
        m_now.at = courseTime(seconds);
        m_now.step = step;
        m_events.push_back(m_now);
        return *this;
    }
    HandWrittenCourse& at(double seconds, IntubationStep step, TubeSeat seat)
    {
        m_now.seat = seat;
        return at(seconds, step);
    }
    HandWrittenCourse& deep(double atTeeth_mm, double aboveCarina_mm)
    {
        m_now.depthAtTeeth = millimetres(atTeeth_mm);
        m_now.tipAboveCarina = millimetres(aboveCarina_mm);
        return *this;
    }
    HandWrittenCourse& seen(double glotticOpening)
    {
        m_now.glotticOpening = glotticOpening;
        return *this;
    }
    HandWrittenCourse& sure(double confidence)
    {
        m_now.confidence = confidence;
        return *this;
    }
    [[nodiscard]] const std::vector<IntubationEvent>& events() const { return m_events; }

private:
    IntubationEvent m_now;
    std::vector<IntubationEvent> m_events;
};

/// Blade in at 10 s, view at 14 s, through the cords at 20 s, blade out at 24 s, cuff at 26 s and
/// first breath at 30 s, 200 mm deep and 30 mm above the carina.
inline HandWrittenCourse goodCourse()
{
    HandWrittenCourse course;
    course.at(10.0, IntubationStep::BladeIn)
        .seen(0.8)
        .at(14.0, IntubationStep::GlottisSeen)
        .at(17.0, IntubationStep::TubePastTeeth)
        .at(20.0, IntubationStep::ThroughCords, TubeSeat::Trachea)
        .deep(200.0, 30.0)
        .at(24.0, IntubationStep::BladeOut)
        .at(26.0, IntubationStep::CuffInflated)
        .at(30.0, IntubationStep::FirstBreath);
    return course;
}

/// In the oesophagus from 20 to 60 s and ventilated there at 30 s; then as the good one, with the
/// blade in again at 65 s and the first breath at 85 s.
inline HandWrittenCourse lateRecognition()
{
    HandWrittenCourse course;
    course.at(10.0, IntubationStep::BladeIn)
        .at(17.0, IntubationStep::TubePastTeeth)
        .at(20.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus)
        .at(24.0, IntubationStep::BladeOut)
        .at(30.0, IntubationStep::FirstBreath)
        .at(60.0, IntubationStep::OutOfOesophagus, TubeSeat::None)
        .at(61.0, IntubationStep::TubeOut)
        .at(65.0, IntubationStep::BladeIn)
        .seen(0.5)
        .at(70.0, IntubationStep::GlottisSeen)
        .at(72.0, IntubationStep::TubePastTeeth)
        .at(75.0, IntubationStep::ThroughCords, TubeSeat::Trachea)
        .deep(205.0, 25.0)
        .at(78.0, IntubationStep::BladeOut)
        .at(85.0, IntubationStep::FirstBreath);
    return course;
}

} // namespace carina::test
