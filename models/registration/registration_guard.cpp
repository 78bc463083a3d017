#include "models/registration/registration_guard.h"

#include <QCoreApplication>

#include <algorithm>

namespace carina
{
namespace
{

class GuardWords
{
    Q_DECLARE_TR_FUNCTIONS(RegistrationGuard)
};

std::optional<Vec3> tipOf(const std::vector<StylusTip>& styluses, const std::string& tool)
{
    const StylusTip* tip = tipOfTool(styluses, tool);
    return tip ? std::optional{tip->p_SQ} : std::nullopt;
}

std::vector<Vec3> placesOf(const std::vector<Landmark>& landmarks)
{
    std::vector<Vec3> places;
    std::ranges::transform(landmarks, std::back_inserter(places), &Landmark::p_AQ);
    return places;
}

} // namespace

RegistrationGuard::RegistrationGuard(const StationTracking& tracking,
                                     GuardedRegistration registration)
    : m_tracking{tracking},
      m_p_SQ{tipOf(registration.styluses, tracking.toolName(ToolRole::Stylus))},
      m_watch{
          placesOf(registration.landmarks), registration.covariance_A, {.touch = registration.fle}}
{
}

void RegistrationGuard::look()
{
    const auto X_AS = m_tracking.newest(ToolRole::Stylus);
    if (X_AS && m_p_SQ)
        (void)m_watch.push(X_AS->time, X_AS->X_FO * *m_p_SQ, X_AS->validity);
}

QString RegistrationGuard::notice() const
{
    if (report().state != WatchState::Drifted)
        return {};
    return GuardWords::
        tr("The manikin has moved by about %1\u00a0mm since it was registered: register it again")
            .arg(inMillimetres(metres(report().shift_A.norm())), 0, 'f', 0);
}

} // namespace carina
