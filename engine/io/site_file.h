#pragma once

#include "engine/core/result.h"
#include "engine/display/display_geometry.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/registration/landmark_catalogue.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace carina
{

/// The steps of preparing a site, in their order.
enum class SiteStep : std::uint8_t { Tracker, Stylus, Landmarks, Touch, Fit, Verify };

/// The tip of the site's stylus, from pivot calibration.
struct StylusTip {
    Vec3 p_SQ = Vec3::Zero();   ///< in the stylus frame S, metres
    double rms = 0.0;           ///< of the calibration, metres
    std::string calibratedAt{}; ///< ISO 8601, such as "2004-03-27T10:15:00Z"
};

/// A landmark as it was touched.
struct TouchedPoint {
    std::string landmark{};   ///< its name in the catalogue
    Vec3 p_TQ = Vec3::Zero(); ///< in the tracker frame T, metres
    double spread = 0.0;      ///< of the tip's positions, metres
};

/// How far a touched landmark stays from its place in the anatomy.
struct LandmarkResidual {
    std::string landmark{};
    double residual = 0.0; ///< metres
};

/// Where the anatomy lies on the manikin.
struct SiteRegistration {
    RigidTransform X_AM;
    RigidTransform X_AT; ///< when the landmarks were touched; ever since, if the manikin is static
    /// The manikin in the frame of its chin probe while the mouth is closed: with a chin probe the
    /// manikin may be moved, X_AT = X_AM * X_JM^-1 * X_JT.
    std::optional<RigidTransform> X_JM{};
    double rms = 0.0; ///< FRE, metres
    std::vector<LandmarkResidual> residuals{};
};

/// All that is known of a site: its tracker, stylus, manikin and display.
struct Site {
    SiteStep step = SiteStep::Tracker; ///< the one that is next
    std::string tracker{};             ///< which tracker, in words; empty before it is chosen
    std::optional<StylusTip> stylus{};
    std::optional<LandmarkCatalogue> catalogue{};
    std::vector<TouchedPoint> touched{}; ///< of the catalogue, none twice
    std::optional<SiteRegistration> registration{};
    std::optional<DisplayGeometry> display{};
};

/// Reads a site file: a JSON object with lengths in millimetres and poses as four rows of four
/// numbers. What is not known yet is left out.
///
///     schema        "carina.site/1"
///     step          "tracker", "stylus", "landmarks", "touch", "fit" or "verify"
///     tracker       text
///     stylus        p_SQ_mm, rms_mm, calibrated_at
///     catalogue     name, anatomy, landmarks: a list of name and p_AQ_mm
///     touched       a list of landmark, p_TQ_mm and spread_mm
///     registration  X_AM_mm, X_AT_mm, X_JM_mm, rms_mm, residuals_mm: a list of name and mm
///     display       p_HDl_mm, p_HDr_mm, p_HQ_screen_centre_mm, screen_width_mm, screen_height_mm
///
/// @returns FileNotFound, FileUnreadable, FileEmpty; UnknownFormat for another schema;
///          FileMalformed where a field is missing, of the wrong kind, unknown, or contradicts
///          another. The detail names file, field and fault.
[[nodiscard]] Result<Site> readSiteFile(const std::filesystem::path& file);

/// Writes a site file. Whenever the program is killed, the file is whole: the old or the new one.
/// @returns FileUnwritable; FileMalformed for a site that readSiteFile would refuse, which leaves
///          the file as it was.
[[nodiscard]] Result<void> writeSiteFile(const std::filesystem::path& file, const Site& site);

} // namespace carina
