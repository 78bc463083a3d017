#pragma once

#include "engine/core/units.h"
#include "engine/registration/registration_watch.h"

#include <optional>

namespace carina
{

/// What two probes on one manikin say of each other.
struct ProbePairReport {
    WatchState state = WatchState::Unchecked;
    double chance = 1.0;                ///< that probes which sit where they sat are seen so
    Vec3 shift_B = Vec3::Zero();        ///< of the chin probe from where it was, in B, metres
    Angle turn{};                       ///< and by which angle
    std::optional<SessionTime> since{}; ///< where drifted: from then on it was so without a break
};

/// Watches the body probe B and the chin probe J of a manikin while its mouth is closed: X_BJ has
/// to be what it was at registration. Where it is not, one of them slipped, or the mouth is not
/// shut.
///
/// Of each full `window` in which both are seen the mean deviation is tested: the shift d of J's
/// origin and the turn w,
///
///     chi^2 = |d|^2 / sigma_d^2 + |w|^2 / sigma_w^2
///
/// with 6 degrees of freedom. The sigmas are of how well a closed mouth comes to where it was, and
/// of the registration's sight of it; a tracker's noise counts little in a mean. Consecutive
/// windows of one closing are alike, so the chance is one for each closing, not for each window.
class ProbePairWatch
{
public:
    struct Settings {
        Length shift = millimetres(0.7); ///< sigma along each axis
        Angle turn = degrees(0.5);       ///< sigma about each axis
        double limit = 5e-5;             ///< below this chance it has drifted
        Duration window = std::chrono::seconds{1};
        Duration longestGap = std::chrono::milliseconds{200}; ///< without both seen
    };

    ProbePairWatch(const RigidTransform& X_BJ_registered, const Settings& settings)
        : m_registered{X_BJ_registered}, m_settings{settings}
    {
    }

    /// Takes the next X_BJ; only while the mouth is closed (opened). A sample that is lost or
    /// not newer than the last is left out; after a gap the window begins anew.
    void push(SessionTime time, const RigidTransform& X_BJ, Validity validity);
    /// The mouth opens: what was not yet a full window is forgotten.
    void opened() { m_samples = 0; }

    [[nodiscard]] const ProbePairReport& report() const { return m_report; }

private:
    void judge(SessionTime from);

    RigidTransform m_registered; ///< X_BJ
    Settings m_settings;
    ProbePairReport m_report;
    SessionTime m_from{};
    std::optional<SessionTime> m_last;
    Vec3 m_shifts = Vec3::Zero(); ///< sums over the window
    Vec3 m_turns = Vec3::Zero();
    int m_samples = 0;
};

} // namespace carina
