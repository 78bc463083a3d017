#pragma once

#include "engine/geometry/fit/motion_covariance.h"
#include "engine/registration/landmarks/dwell_detector.h"

#include <deque>
#include <optional>
#include <vector>

namespace carina
{

/// Whether a registration still holds.
enum class WatchState : std::uint8_t {
    Unchecked, ///< there was no check yet
    Good,      ///< the checks agree with the registration
    Drifted,   ///< they do not: the manikin, the tracker or a probe was moved
};

/// A landmark of the registration, touched during a session.
struct LandmarkCheck {
    SessionTime time{};       ///< when the touch began
    std::size_t landmark = 0; ///< its index in the catalogue
    Vec3 d_A = Vec3::Zero();  ///< deviation from the landmark to the tip, in A, metres
};

/// The result of the latest checks.
struct WatchReport {
    WatchState state = WatchState::Unchecked;
    /// The p-value, at most 1: probability of deviations like these while the registration holds.
    double chance = 1.0;
    std::size_t checks = 0; ///< number of latest checks with the most significant shift
    /// Estimated shift by these checks, metres: from where the anatomy is drawn to its true place.
    Vec3 shift_A = Vec3::Zero();
    std::optional<SessionTime> since{}; ///< time of the first of these checks, where drifted
};

/// Whether a covariance is positive definite, as RegistrationWatch requires.
[[nodiscard]] bool isPositiveDefinite(const Mat6& covariance);

/// Monitors whether a registration still holds: whenever the stylus rests near a landmark, the tip
/// should be where the landmark is drawn.
///
/// The model of the deviations d_i is
///
///     d_i = w x p_AQ_i + v + s + e_i
///
/// with the error (w, v) of the registration, of covariance covariance_A and the same in all
/// checks; the error e_i of a touch; and a shift s, which is 0 as long as nothing moved. The latest
/// 1, 2, 4, 8 and 16 checks are tested in two ways: the estimate of s by generalised least squares
/// (chi-squared with 3 degrees of freedom), and all deviations under s = 0 (3 n degrees of
/// freedom), which also detects rotations. The chance is the smallest p-value of the nine different
/// tests times nine (Bonferroni correction). The state is Drifted where the chance is below
/// `limit`, chosen so that at most one of 1000 registrations with 20 checks each is wrongly called
/// drifted.
///
/// Where no landmark is within `search` of the tip there is no check, so a shift larger than this
/// is not detected.
class RegistrationWatch
{
public:
    struct Settings {
        Length touch = millimetres(1.0);   ///< RMS length of e
        Length search = millimetres(15.0); ///< largest distance of a checked landmark from the tip
        double limit = 1e-3 / 20.0;
        DwellDetector::Settings dwell{};
    };

    /// @param p_AQ         the landmarks, metres
    /// @param covariance_A covariance of X_AT, see Mat6 (motion_covariance.h)
    /// @pre the covariance is positive definite, there is a landmark, and touch is above 0.
    RegistrationWatch(std::vector<Vec3> p_AQ, const Mat6& covariance_A, const Settings& settings);

    /// Takes the next position of the stylus tip, converted to A by the registration, metres.
    /// @returns the check, with the sample that completes one.
    std::optional<LandmarkCheck> push(SessionTime time, const Vec3& p_A_tip, Validity validity);

    /// Adds a check and updates the report.
    void add(const LandmarkCheck& check);

    [[nodiscard]] const WatchReport& report() const { return m_report; }
    /// The latest checks, at most 16, oldest first.
    [[nodiscard]] const std::deque<LandmarkCheck>& latest() const { return m_latest; }

private:
    void judge();

    std::vector<Vec3> m_p_AQ;
    Mat6 m_information; ///< inverse of covariance_A, times the variance of a touch
    Settings m_settings;
    DwellDetector m_dwell;
    std::deque<LandmarkCheck> m_latest; ///< ascending in time
    WatchReport m_report;
};

} // namespace carina
