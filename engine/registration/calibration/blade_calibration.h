#pragma once

#include "engine/core/result.h"
#include "engine/core/units.h"
#include "engine/geometry/rigid_transform.h"

#include <array>
#include <cstdint>
#include <span>

namespace carina
{

/// A laryngoscope, in the frame L of its blade: origin at the middle of the heel, where the blade
/// leaves the handle; x along the heel to the right of who holds it, y along the handle, -z ahead.
/// It is symmetric to the plane of y and z.
struct BladeShape {
    Length heelWidth;             ///< between the corners of the heel
    Length handle;                ///< from the heel to the middle of the handle's end
    Vec3 p_L_tip = Vec3::Zero();  ///< middle of the far edge, metres; x is 0
    Vec3 p_L_half = Vec3::Zero(); ///< on the underside, half way to the tip; x is 0

    /// How far the underside sags below the straight line from heel to tip, half way along it.
    [[nodiscard]] Length sag() const;
    /// A curved blade sags, as that of Macintosh; a straight one does not, as that of Miller.
    [[nodiscard]] bool isCurved() const;

    friend bool operator==(const BladeShape&, const BladeShape&) = default;
};

/// Sag above which a blade counts as curved, as a share of the way from heel to tip: of ours. No
/// published profiles of blades were found; the curved one that we draw sags by 0.15.
inline constexpr double kCurvedBladeSag = 0.04;

/// The places by which a blade is calibrated.
enum class BladePlace : std::uint8_t { LeftHeel, RightHeel, Handle, Half, Tip };
inline constexpr std::array kBladePlaces{BladePlace::LeftHeel, BladePlace::RightHeel,
                                         BladePlace::Handle, BladePlace::Half, BladePlace::Tip};

/// A place of a laryngoscope in L.
[[nodiscard]] Vec3 placeOnBlade(const BladeShape& blade, BladePlace place);

/// A touch of a laryngoscope with the tip of a stylus, in the frame N of its markers.
struct BladeTouch {
    BladePlace place = BladePlace::Tip;
    Vec3 p_NQ = Vec3::Zero(); ///< metres
};

/// A laryngoscope as it was touched.
struct BladeCalibration {
    RigidTransform X_NL;
    BladeShape shape;
    Length fle;                       ///< RMS error of a touch, estimated from the residuals
    double degrees = 0.0;             ///< degrees of freedom of that estimate
    double rms = 0.0;                 ///< of the touches' distances from its shape, metres
    Mat3 covariance_N = Mat3::Zero(); ///< of the tip in N, m^2, by that estimate

    [[nodiscard]] Vec3 p_NQ_tip() const { return X_NL * shape.p_L_tip; }
};

/// Finds frame and shape of a laryngoscope: the shape's lengths are those between the touches, the
/// frame is the rigid fit of the places of that shape to the touches (fitRigid), and both are then
/// refined together by least squares over all coordinates. What disagrees with the symmetry leaves
/// residuals.
///
/// @returns TooFewPoints where a place was not touched; DegenerateLandmarks where places are at
///          one line; NoSurfaceFit where the residuals are above 1 mm, as when left and right were
///          exchanged or a place is another; NotFinite; OutOfRange for a coordinate of a kilometre.
///          The detail says what is missing.
[[nodiscard]] Result<BladeCalibration> calibrateBlade(std::span<const BladeTouch> touches);

} // namespace carina
