#pragma once

#include "engine/display/display_geometry.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/registration/fit/uncertain_transform.h"
#include "engine/registration/landmarks/landmark_catalogue.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// The pages of preparing a site, in their order.
enum class SiteStep : std::uint8_t { Overview, Tracker, Stylus, Landmarks, Touch, Fit, Verify };

/// What was changed beneath a result, so that it no longer follows from what it rests on: the
/// deepest first.
enum class StaleCause : std::uint8_t { Tracker, Stylus, Landmarks, Manikin, Touches, Fit };

/// The axis of a tool, from a spin calibration.
struct StylusAxis {
    Vec3 axis_S = Vec3::UnitZ(); ///< unit, towards the tip
    Angle wobble{};              ///< RMS
    std::string calibratedAt{};  ///< ISO 8601
};

/// The tip of a stylus, from pivot calibration.
struct StylusTip {
    Vec3 p_SQ = Vec3::Zero();         ///< in the stylus frame S, metres
    double rms = 0.0;                 ///< of the calibration, metres
    std::string calibratedAt{};       ///< ISO 8601, such as "2004-03-27T10:15:00Z"
    std::string tool{};               ///< as the tracker names it; empty where that is not known
    Mat3 covariance_S = Mat3::Zero(); ///< of p_SQ, m^2; zero where it is not known
    int poses = 0;
    int outliers = 0;
    std::optional<StylusAxis> axis{};
};

/// The calibration of a tool, or the only one that names none; null where there is none.
[[nodiscard]] const StylusTip* tipOfTool(const std::vector<StylusTip>& styluses,
                                         const std::string& tool);

/// A landmark as it was touched.
struct TouchedPoint {
    std::string landmark{};       ///< its name in the catalogue
    Vec3 p_TQ = Vec3::Zero();     ///< in the tracker frame T, metres
    double spread = 0.0;          ///< of the tip's positions, metres
    Quat q_TS = Quat::Identity(); ///< how the stylus was held
    std::optional<StaleCause> stale{};
};

/// How far a touched landmark stays from its place in the anatomy.
struct LandmarkResidual {
    std::string landmark{};
    double residual = 0.0;           ///< metres
    std::optional<double> leftOut{}; ///< from the fit of all others, metres
};

/// A refinement of a registration on a surface that was swabbed.
struct SiteSwab {
    std::string surface{}; ///< its name in the patient
    int points = 0;
    int outliers = 0;
    double startRms = 0.0; ///< of the distances before, metres
    double rms = 0.0;      ///< after
    double moved = 0.0;    ///< the longest way that a point of the swab went, metres
};

/// The manikin was moved, and laid anew by some of its landmarks.
struct SiteRelay {
    std::string at{}; ///< ISO 8601
    std::string operatorName{};
    int landmarks = 0;
    double rms = 0.0; ///< metres
};

/// Where the anatomy lies on the manikin.
struct SiteRegistration {
    RigidTransform X_AM;
    RigidTransform X_AT; ///< when the landmarks were touched; ever since, if the manikin is static
    /// The manikin in the frame of its chin probe while the mouth is closed: with a chin probe the
    /// manikin may be moved, X_AT = X_AM * X_JM^-1 * X_JT.
    std::optional<RigidTransform> X_JM{};
    std::optional<RigidTransform> X_BM{}; ///< in the frame of its body probe, which it goes with
    double rms = 0.0;                     ///< FRE, metres
    std::vector<LandmarkResidual> residuals{};
    Mat6 covariance_A = Mat6::Zero(); ///< of X_AM: see UncertainTransform
    double fle = 0.0;                 ///< estimated from the residuals, metres
    double degrees = 0.0;             ///< of freedom of that estimate; 0 where there is none
    std::string madeAt{};             ///< ISO 8601; empty where it is not known
    std::string operatorName{};
    std::optional<SiteSwab> swab{};
    std::vector<SiteRelay> relays{}; ///< oldest first
    std::optional<StaleCause> stale{};
};

/// A place that was touched to check the registration, and not used in the fit.
struct VerifiedPoint {
    std::string name{};
    Vec3 p_AQ = Vec3::Zero();
    Vec3 p_TQ = Vec3::Zero();
    double error = 0.0; ///< | X_AT p_TQ - p_AQ |, metres
    double bound = 0.0; ///< that 95 % of such errors stay below, metres
};

enum class Verdict : std::uint8_t { Open, Good, NotGood };

/// What checking the registration came to.
struct SiteVerification {
    Verdict verdict = Verdict::Open;
    std::string at{}; ///< ISO 8601, of the verdict; empty while it is open
    std::string operatorName{};
    std::vector<VerifiedPoint> points{}; ///< none twice
    std::optional<StaleCause> stale{};
};

/// All that is known of a site: its tracker, styluses, manikin and display.
struct Site {
    SiteStep step = SiteStep::Tracker; ///< the one that is next
    std::string operatorName{};        ///< who works on it; empty where nobody said
    std::string tracker{};             ///< which tracker, in words; empty before it is chosen
    std::vector<StylusTip> styluses{}; ///< one for each tool
    std::string patient{};             ///< its name as shown; empty where it is not known
    std::optional<LandmarkCatalogue> catalogue{};
    std::vector<TouchedPoint> touched{}; ///< of the catalogue, none twice
    std::optional<SiteRegistration> registration{};
    /// While the manikin, which was moved, is laid anew: its landmarks touched again so far.
    std::optional<std::vector<TouchedPoint>> relay{};
    std::optional<SiteVerification> verification{};
    std::optional<DisplayGeometry> display{};

    /// See tipOfTool.
    [[nodiscard]] const StylusTip* stylus(const std::string& tool) const
    {
        return tipOfTool(styluses, tool);
    }
};

} // namespace carina
