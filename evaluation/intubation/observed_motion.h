#pragma once

#include "engine/tracking/pose_sample.h"
#include "evaluation/intubation/intubation_motion.h"

#include <vector>

namespace carina
{

/// How a tracker and a registration see a motion.
struct ObservationSettings {
    Frequency rate = hertz(60.0);
    Duration jitter = std::chrono::microseconds{800}; ///< of the exposures, standard deviation
    Length noise = millimetres(0.35);                 ///< root mean square of a position
    Angle rotationNoise = degrees(0.25); ///< root mean square; of ours, about that of four markers
                                         ///< on 45 mm
    double dropouts = 0.02;              ///< share of the exposures of a tool that are lost
    Length registration = millimetres(1.5); ///< root mean square, at the origin of A
    Angle registrationTurn = degrees(1.0);  ///< root mean square
};

/// Poses in the frame A' of the anatomy as it was registered, which is not quite A.
struct ObservedMotion {
    RigidTransform X_AprimeA; ///< the registration's error
    std::vector<PoseSample> tube;
    std::vector<PoseSample> laryngoscope;
    std::vector<PoseSample> jaw; ///< X_AJ of the mandible in the frame of the head
};

/// Looks at a motion from its start to its end. A tool is lost for one exposure or, in every fourth
/// case, for a burst of 5 to 25; a lost sample has the pose before. Time 0 of the motion is
/// `start`.
[[nodiscard]] ObservedMotion observed(const IntubationMotion& motion,
                                      const ObservationSettings& settings, SessionTime start,
                                      std::mt19937& random);

} // namespace carina
