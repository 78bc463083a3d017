#pragma once

#include "engine/geometry/rigid_transform.h"
#include "engine/registration/calibration/blade_calibration.h"
#include "engine/registration/calibration/tip_check.h"
#include "engine/registration/calibration/tube_rest.h"
#include "engine/tracking/tracker.h"

#include <optional>
#include <string>
#include <vector>

namespace carina
{

enum class StaleCause : std::uint8_t;

/// A touch of a tool's tip, by which its calibration was checked.
struct SiteToolCheck {
    TipCheck tip;
    std::string at{}; ///< ISO 8601
};

/// A tube or a laryngoscope as it was touched with the stylus.
struct SiteTool {
    ToolRole role = ToolRole::Tube;    ///< or Laryngoscope
    std::string tool{};                ///< as the tracker names it; empty where that is not known
    RigidTransform X_NO{};             ///< the connector E or the blade L in the markers' frame N
    std::optional<TubeRest> tube{};    ///< of a tube
    std::optional<BladeShape> blade{}; ///< of a laryngoscope
    double rms = 0.0;                  ///< of the residuals, metres
    double fle = 0.0;                  ///< RMS error of a touch, metres
    double degrees = 0.0;              ///< degrees of freedom of that estimate
    Mat3 covariance_N = Mat3::Zero();  ///< of the tip, m^2
    int touches = 0;
    std::string calibratedAt{}; ///< ISO 8601
    std::string operatorName{};
    std::optional<SiteToolCheck> check{};
    std::optional<StaleCause> stale{};

    /// The tip in N, metres.
    [[nodiscard]] Vec3 p_NQ_tip() const
    {
        return X_NO * (tube ? tipOfTube(*tube) : blade ? blade->p_L_tip : Vec3{Vec3::Zero()});
    }
    /// Whether its last check found the tip elsewhere.
    [[nodiscard]] bool isBent() const { return check && check->tip.isBent(); }
};

/// The calibration of the tool with this role; nullptr where there is none.
[[nodiscard]] const SiteTool* toolOfRole(const std::vector<SiteTool>& tools, ToolRole role);

} // namespace carina
