#pragma once

#include "engine/registration/fit/uncertain_transform.h"
#include "engine/registration/landmarks/dwell_detector.h"

#include <deque>
#include <optional>
#include <vector>

namespace carina
{

enum class WatchState : std::uint8_t {
    Unchecked, ///< nothing was seen yet that would tell
    Good,      ///< what was seen agrees with the registration
    Drifted,   ///< it does not: the manikin, the tracker or a probe was moved
};

/// A landmark of the registration, touched during a session.
struct LandmarkCheck {
    SessionTime time{};       ///< when the touch began
    std::size_t landmark = 0; ///< its place in the catalogue
    Vec3 d_A = Vec3::Zero();  ///< from the landmark's place to the tip, in A, metres
};

/// What the latest checks say.
struct WatchReport {
    WatchState state = WatchState::Unchecked;
    /// That a registration which still holds would show what the latest checks show; at most 1.
    double chance = 1.0;
    std::size_t checks = 0;      ///< how many of the latest show a shift most clearly
    Vec3 shift_A = Vec3::Zero(); ///< of these, best estimate, metres: the anatomy lies so far
                                 ///< from where it is drawn
    std::optional<SessionTime> since{}; ///< of the first of these, where drifted
};

/// Whether a covariance leaves no motion certain, as RegistrationWatch takes it.
[[nodiscard]] bool isPositiveDefinite(const Mat6& covariance);

/// Watches whether a registration still holds: whenever the stylus rests on a known landmark, the
/// tip has to be where the landmark is drawn.
///
/// The deviations d_i of checks follow
///
///     d_i = w x p_AQ_i + v + s + e_i
///
/// with the registration's own error (w, v) of the covariance that was predicted for it, the same
/// in all checks; e_i of a touch; and a shift s, 0 as long as nothing moved. Of the latest 1, 2, 4,
/// 8 and 16 checks two things are tested: the best estimate of s by generalised least squares
/// (chi-squared with 3 degrees of freedom), and all deviations with s = 0 (3 n), which turns show
/// in. The chance is the least of the nine tests times nine (Bonferroni). Drifted is what has a
/// chance below `limit`, so that of a thousand registrations with twenty checks each no more than
/// one is called so wrongly.
///
/// A landmark that is further than `search` from the tip is not taken for touched: where all has
/// moved that far, nothing is checked.
class RegistrationWatch
{
public:
    struct Settings {
        Length touch = millimetres(1.0);   ///< root of the expected squared length of e
        Length search = millimetres(15.0); ///< of the tip round a landmark
        double limit = 1e-3 / 20.0;
        DwellDetector::Settings dwell{};
    };

    /// @param p_AQ         the landmarks, metres
    /// @param covariance_A of X_AT as UncertainTransform has it
    /// @pre the covariance is positive definite, there is a landmark, and touch is above 0.
    RegistrationWatch(std::vector<Vec3> p_AQ, const Mat6& covariance_A, const Settings& settings);

    /// Takes the next position of the stylus's tip as the registration has it.
    /// @param p_A_tip metres
    /// @returns the check, with the sample that completes one.
    std::optional<LandmarkCheck> push(SessionTime time, const Vec3& p_A_tip, Validity validity);

    /// Takes a check.
    void add(const LandmarkCheck& check);

    [[nodiscard]] const WatchReport& report() const { return m_report; }
    [[nodiscard]] const std::deque<LandmarkCheck>& latest() const { return m_latest; }

private:
    void judge();

    std::vector<Vec3> m_p_AQ;
    Mat6 m_information; ///< of the registration, in units of a touch's variance
    Settings m_settings;
    DwellDetector m_dwell;
    std::deque<LandmarkCheck> m_latest; ///< ascending in time
    WatchReport m_report;
};

} // namespace carina
