#pragma once

#include "apps/lab/intubation/intubation_subject.h"
#include "engine/airway/monitor/airway_moment.h"
#include "engine/anatomy/laryngoscopy/blade_levering.h"
#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"

namespace carina::lab
{

/// Poses of one time in the frame A of the anatomy as it was registered.
struct SeenTools {
    PoseSample tube;         ///< X_AE
    PoseSample laryngoscope; ///< X_AL
    PoseSample jaw;          ///< X_AJ of the mandible in the frame of the head
    HeadPosition head;
};

/// Makes of poses what the monitor of an intubation takes: the ways of the patient as jaw and neck
/// have taken them, the tube's curve, and the blade's tip.
///
/// The tube is the patient's own, which has the form of the airway, so that it has one shape only.
/// It bends with the neck and keeps its length, as one that is fixed at the teeth. The glottis that
/// is seen is not measured: nothing is drawn here.
class WatchedAirway
{
public:
    /// @pre the subject outlives this
    WatchedAirway(const IntubationSubject& subject, const Blade& blade)
        : m_subject{subject}, m_blade{blade}
    {
    }

    /// @param tools in ascending time
    [[nodiscard]] AirwayMoment take(const SeenTools& tools);

    /// What the blade touched in the latest moment.
    [[nodiscard]] const BladeEffort& effort() const { return m_effort; }

private:
    [[nodiscard]] PatientWays waysAt(const SeenTools& tools, const NeckField& neck) const;
    [[nodiscard]] BladeSeen bladeAt(const SeenTools& tools, const NeckField& neck);

    const IntubationSubject& m_subject;
    Blade m_blade;
    LeveringWatch m_levering;
    BladeEffort m_effort;
};

} // namespace carina::lab
