#pragma once

#include "engine/lungs/mechanics/body_position.h"
#include "models/station/headset_view.h"
#include "models/station/station_view.h"

namespace carina
{

/// Whether a headset's picture is seen from a head that a person turns by mouse: no tracker here
/// has a tool for the head.
[[nodiscard]] bool looksByMouse(const StationMoment& moment, ViewOutput output);

/// The place beside a patient from which a person looks.
struct PlaceBeside {
    Vec3 p_A_mouth = Vec3::Zero(); ///< metres
    BodyPosition position{};       ///< which says what is up
    Angle turn{};                  ///< of the side that was chosen for the person (PlaceChosen)
};

/// A head that a person turns and moves by mouse. It stands beside the patient, by itself looking
/// at the mouth: at the head end of one who lies, in front of one who sits, or at the side that was
/// chosen for the person, where that side is beside the patient and not above or below. It turns
/// about its own place, and moves along the line from there to the mouth.
class HeadByMouse
{
public:
    static constexpr double kUsualDistance = 0.6; ///< metres from the mouth
    static constexpr double kNearest = 0.15;      ///< metres
    static constexpr double kFarthest = 2.5;      ///< metres
    /// Of the head above the mouth, seen from there: so steep that the head of who works at the
    /// head end, 0.4 m from the mouth at 45 degrees, is not in the line.
    static constexpr Angle kElevation = degrees(70.0);
    /// Of the direction it looks in, up and down from level.
    static constexpr Angle kSteepest = degrees(85.0);
    static constexpr Angle kTurnPerHeight = radians(1.2); ///< of the picture

    /// Turns the head so that what it sees moves to the right and down, in fractions of the
    /// picture's height.
    void turn(double right, double down);
    /// Divides the distance to the mouth. @pre factor > 0
    void comeNearer(double factor);
    /// Takes its usual place again.
    void standAgain() { *this = {}; }

    /// X_AH, without roll.
    [[nodiscard]] RigidTransform poseAt(const PlaceBeside& place) const;

private:
    double m_yaw = 0.0;              ///< radians about what is up, to the left
    double m_pitch = -kElevation.si; ///< radians up from level
    double m_distance = kUsualDistance;
};

} // namespace carina
