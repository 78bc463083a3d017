#pragma once

#include "engine/display/display_geometry.h"
#include "engine/geometry/fit/motion_covariance.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/io/site/site_device.h"
#include "engine/io/site/site_manikin.h"
#include "engine/io/site/site_tool.h"
#include "engine/registration/landmarks/landmark_catalogue.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// The pages of site preparation, in their order.
enum class SiteStep : std::uint8_t {
    Overview,
    Tracker,
    Stylus,
    Landmarks,
    Touch,
    Fit,
    Verify,
    Tools
};

/// Why a result is out of date: the input that was changed after it was computed, the most basic
/// first.
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

/// The calibration of a tool, else the one stored without a tool's name; nullptr where there is
/// neither.
[[nodiscard]] const StylusTip* tipOfTool(const std::vector<StylusTip>& styluses,
                                         const std::string& tool);

/// A landmark touched with the stylus.
struct TouchedPoint {
    std::string landmark{};       ///< its name in the catalogue
    Vec3 p_TQ = Vec3::Zero();     ///< in the tracker frame T, metres
    double spread = 0.0;          ///< of the tip's positions while it was held there, metres
    Quat q_TS = Quat::Identity(); ///< orientation of the stylus
    bool isFitted = false;        ///< it is in one of Site::localisations
    /// With which the tracker saw the tip meanwhile, RMS, metres; where that is known.
    std::optional<double> seenError{};
    std::optional<StaleCause> stale{};
};

/// Distance of a touched landmark from its place in the anatomy after the fit.
struct LandmarkResidual {
    std::string landmark{};
    double residual = 0.0;           ///< metres
    std::optional<double> leftOut{}; ///< with the fit of all other landmarks, metres
};

/// Refinement of a registration on a surface that was swabbed with the stylus.
struct SiteSwab {
    std::string surface{}; ///< its name in the patient
    int points = 0;
    int outliers = 0;
    double startRms = 0.0; ///< of the distances before the refinement, metres
    double rms = 0.0;      ///< after
    double moved = 0.0;    ///< longest displacement of a swab point, metres
};

/// A repeated registration with some of the landmarks, after the manikin was moved.
struct SiteRelay {
    std::string at{}; ///< ISO 8601
    std::string operatorName{};
    int landmarks = 0;
    double rms = 0.0; ///< metres
};

/// Registration of the anatomy A to the manikin M.
struct SiteRegistration {
    RigidTransform X_AM;
    RigidTransform X_AT; ///< when the landmarks were touched; still valid if the manikin is static
    /// The manikin in the frame J of its chin probe while the mouth is closed: with a chin probe
    /// the manikin may be moved, X_AT = X_AM * X_JM^-1 * X_JT.
    std::optional<RigidTransform> X_JM{};
    std::optional<RigidTransform> X_BM{}; ///< in the frame B of its body probe, with which it moves
    double rms = 0.0;                     ///< FRE, metres
    std::vector<LandmarkResidual> residuals{};
    Mat6 covariance_A = Mat6::Zero(); ///< of X_AM: see Mat6 (motion_covariance.h)
    double fle = 0.0;     ///< fiducial localisation error, estimated from the residuals, metres
    double degrees = 0.0; ///< degrees of freedom of that estimate; 0 where there is none
    int pooled = 0;       ///< how many earlier registrations are in that estimate
    int disagreeing = 0;  ///< how many are not, since their errors are unlike those of this one
    std::string madeAt{}; ///< ISO 8601; empty where it is not known
    std::string operatorName{};
    std::optional<SiteSwab> swab{};
    std::vector<SiteRelay> relays{}; ///< oldest first
    std::optional<StaleCause> stale{};
};

/// The fiducial localisation error of one registration, from its residuals alone.
struct SiteLocalisation {
    double rms = 0.0;     ///< metres, above 0
    double degrees = 0.0; ///< degrees of freedom, above 0
    std::string at{};     ///< ISO 8601; empty where it is not known
    std::string operatorName{};
};

/// A point touched to check the registration, not used in the fit.
struct VerifiedPoint {
    std::string name{};
    Vec3 p_AQ = Vec3::Zero();
    Vec3 p_TQ = Vec3::Zero();
    double error = 0.0; ///< | X_AT p_TQ - p_AQ |, metres
    double bound = 0.0; ///< 95 % of such errors are below this, metres
};

enum class Verdict : std::uint8_t { Open, Good, NotGood };

/// The result of checking the registration.
struct SiteVerification {
    Verdict verdict = Verdict::Open;
    std::string at{}; ///< ISO 8601, of the verdict; empty while it is open
    std::string operatorName{};
    std::vector<VerifiedPoint> points{}; ///< none twice
    std::optional<StaleCause> stale{};
};

/// The data of a site: its tracker, styluses, manikin and display.
struct Site {
    SiteStep step = SiteStep::Tracker; ///< the next one
    std::string operatorName{};        ///< empty where it is not known
    std::string tracker{};             ///< which tracker, in words; empty before it is chosen
    std::vector<SiteDevice> devices{}; ///< that track here; the frame T is that of the first
    std::vector<StylusTip> styluses{}; ///< one for each tool
    std::vector<SiteTool> tools{};     ///< tube and laryngoscope, one for each role
    std::string patient{};             ///< its name as shown; empty where it is not known
    std::optional<LandmarkCatalogue> catalogue{};
    std::vector<TouchedPoint> touched{}; ///< of the catalogue, none twice
    std::optional<SiteRegistration> registration{};
    /// Of the registrations made here, oldest first; no two share a touch. The registration is in
    /// the last one, unless another person's touches are in it, too.
    std::vector<SiteLocalisation> localisations{};
    /// While the manikin is registered again after it was moved: the landmarks touched so far.
    std::optional<std::vector<TouchedPoint>> relay{};
    std::optional<SiteVerification> verification{};
    std::optional<DisplayGeometry> display{};
    SiteManikin manikin{};

    /// See tipOfTool.
    [[nodiscard]] const StylusTip* stylus(const std::string& tool) const
    {
        return tipOfTool(styluses, tool);
    }
};

} // namespace carina
