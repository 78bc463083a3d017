#include "models/registration/registration_guard.h"

#include <algorithm>

namespace carina
{
namespace
{

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

} // namespace carina
