#pragma once

#include "engine/io/site/site.h"
#include "engine/registration/landmarks/landmark_catalogue.h"
#include "engine/registration/watch/registration_watch.h"
#include "engine/session/station_tracking.h"

#include <optional>
#include <vector>

namespace carina
{

/// What is needed to monitor a registration.
struct GuardedRegistration {
    std::vector<StylusTip> styluses; ///< of the site
    std::vector<Landmark> landmarks;
    Mat6 covariance_A = Mat6::Zero(); ///< of X_AM
    Length fle;                       ///< RMS error of one touch
};

/// Checks during a session whether the manikin is still where it was registered: when the stylus
/// rests on a landmark, its tip must be where the landmark is drawn.
class RegistrationGuard
{
public:
    /// Without a calibrated tip of the tracked stylus nothing is checked.
    /// @pre tracking outlives this; the covariance is positive definite.
    RegistrationGuard(const StationTracking& tracking, GuardedRegistration registration);

    /// Reads the present pose of the stylus; to be called about 20 times a second.
    void look();

    [[nodiscard]] const WatchReport& report() const { return m_watch.report(); }

private:
    const StationTracking& m_tracking;
    std::optional<Vec3> m_p_SQ;
    RegistrationWatch m_watch;
};

} // namespace carina
