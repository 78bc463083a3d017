#pragma once

#include "apps/lab/intubation/intubation_subject.h"
#include "engine/airway/monitor/airway_moment.h"
#include "engine/airway/tube/elastic_tube.h"
#include "engine/anatomy/laryngoscopy/blade_levering.h"
#include "engine/anatomy/laryngoscopy/laryngoscopy_path.h"

#include <optional>
#include <vector>

namespace carina::lab
{

/// Poses of one time in the frame A of the anatomy as it was registered.
struct SeenTools {
    PoseSample tube;         ///< X_AE
    PoseSample laryngoscope; ///< X_AL
    PoseSample jaw;          ///< X_AJ of the mandible in the frame of the head
    HeadPosition head;
};

/// Makes of poses what the monitor of an intubation takes: the ways of the patient as they are
/// drawn in a program, the tube in both shapes, and the blade's tip.
///
/// As measured the tube is its curve at rest at the pose of its connector. The patient's own has
/// the form of the airway: it bends with the neck and keeps its length, as one that is fixed at the
/// teeth. As shown it is an elastic rod in the lumen of the moment (ElasticTube); and as
/// measured until it is laid, farther than kInFront from the teeth, and in a subject without a
/// lumen. That both are apart tells something only of a tube that was calibrated. The glottis that
/// is seen is not measured: nothing is drawn here.
class WatchedAirway
{
public:
    /// @param connectorAt the tube's poses at all times up to those that are taken
    /// @pre the subject, and what connectorAt reads, outlive this
    WatchedAirway(const IntubationSubject& subject, const Blade& blade,
                  ElasticTube::ConnectorAt connectorAt);

    /// A tip farther in front of the teeth is in no lumen, which is not moved then: of ours.
    static constexpr Length kInFront = millimetres(30.0);

    /// @param tools in ascending time
    [[nodiscard]] AirwayMoment take(const SeenTools& tools);

    /// What the blade touched in the latest moment.
    [[nodiscard]] const BladeEffort& effort() const { return m_effort; }

private:
    [[nodiscard]] FollowingThroat throatOf(const SeenTools& tools) const;
    [[nodiscard]] BladeField tissueAt(const SeenTools& tools, const FollowingThroat& throat) const;
    [[nodiscard]] std::vector<Vec3> measuredTube(const SeenTools& tools,
                                                 const NeckField& neck) const;
    void followTube(const SeenTools& tools, const FollowingThroat& throat, const BladeField& blade);
    [[nodiscard]] BladeSeen bladeAt(const SeenTools& tools, const FollowingThroat& throat);

    const IntubationSubject& m_subject;
    Blade m_blade;
    ElasticTube::ConnectorAt m_connectorAt;
    std::optional<ElasticTube> m_tube; ///< where there is a lumen
    bool m_isNear = true;              ///< its tip was in the body, or just in front of it
    LeveringWatch m_levering;
    BladeEffort m_effort;
};

} // namespace carina::lab
