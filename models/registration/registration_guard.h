#pragma once

#include "engine/io/site/site.h"
#include "engine/registration/landmarks/landmark_catalogue.h"
#include "engine/registration/watch/registration_watch.h"
#include "engine/session/station_tracking.h"

#include <QString>

#include <optional>
#include <vector>

namespace carina
{

/// What a registration is watched by.
struct GuardedRegistration {
    std::vector<StylusTip> styluses; ///< of the site
    std::vector<Landmark> landmarks;
    Mat6 covariance_A = Mat6::Zero(); ///< of X_AM
    Length fle;                       ///< of a touch
};

/// Watches during a session whether the manikin still lies where it was registered: whenever the
/// stylus rests on a landmark, its tip has to be where the landmark is drawn.
class RegistrationGuard
{
public:
    /// Nothing is watched without the tip of the stylus that is tracked.
    /// @pre tracking outlives this; the covariance is positive definite.
    RegistrationGuard(const StationTracking& tracking, GuardedRegistration registration);

    /// Takes in where the stylus is now; to be called some twenty times a second.
    void look();

    [[nodiscard]] const WatchReport& report() const { return m_watch.report(); }
    /// That the registration has drifted, and by how much, in a sentence; empty while it has not.
    [[nodiscard]] QString notice() const;

private:
    const StationTracking& m_tracking;
    std::optional<Vec3> m_p_SQ;
    RegistrationWatch m_watch;
};

} // namespace carina
