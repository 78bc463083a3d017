#pragma once

#include <QString>

#include <cstdint>

namespace carina
{

/// Who can come into a session that is hosted here.
enum class SessionReach : std::uint8_t {
    ThisComputer,
    Network, ///< and finds it there
    ByLink,  ///< from anywhere that reaches this computer; it is announced to nobody
};

/// One sentence on what it means.
[[nodiscard]] QString reachMeaning(SessionReach reach);

/// What a person decides about a session before it begins.
struct SessionPlan {
    QString name{};
    QString patient{}; ///< words of patientFromWords; with a folder how its patient breathes
    QString folder{};  ///< of surfaces, whose patient is laid; empty: a built-in one
    QString site{};    ///< file of the wizard, by which readiness is judged; empty: none
    SessionReach reach = SessionReach::ThisComputer;
};

/// What has to be corrected, as a sentence; empty if the session can begin.
[[nodiscard]] QString faultOf(const SessionPlan& plan);

} // namespace carina
