#pragma once

#include "engine/geometry/fit/motion_covariance.h"
#include "engine/geometry/fit/rigid_fit.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// A landmark Q of an earlier registration, with its touch.
struct RegisteredLandmark {
    std::string name;
    Vec3 p_AQ = Vec3::Zero(); ///< in the anatomy frame A, metres
    Vec3 p_MQ = Vec3::Zero(); ///< the touch, in the manikin frame M, metres
};

/// A registration made before the manikin was moved.
struct EarlierRegistration {
    RigidTransform X_AM; ///< fitted (fitRigid) to all these landmarks
    std::vector<RegisteredLandmark> landmarks;
    /// Covariance of X_AM where it is not the fit of these landmarks alone, but refined on a
    /// surface.
    std::optional<Mat6> covariance_A{};
};

/// A touch of one of its landmarks after the manikin was moved.
struct Retouch {
    std::size_t landmark = 0; ///< its index in the earlier registration
    Vec3 p_TQ = Vec3::Zero(); ///< in the tracker frame T, metres
};

/// The RMS lengths of isotropic errors of touches.
struct TouchErrors {
    Length first;   ///< of a touch of the earlier registration, above 0
    Length again;   ///< of a touch now, above 0
    Length place{}; ///< of the place taken for the landmark, the same both times
};

/// The registration of a manikin that was moved.
struct ReRegistration {
    RigidTransform X_TM; ///< new pose of the manikin
    RigidTransform X_AT; ///< X_AM * X_TM^-1
    /// |p_TQ - X_TM p_MQ| of each touch, metres, in their order
    std::vector<double> residuals{};
    double rms = 0.0; ///< root mean square of the residuals, metres
    /// Covariance of X_AT, see Mat6; input of targetError.
    Mat6 covariance_A = Mat6::Zero();
    /// Number of orders of the touches that fit. If more than one, the landmarks are too symmetric
    /// to distinguish, for example, left from right.
    std::size_t explanations = 1;
};

/// Registers a manikin that was moved, by touching three or more of its landmarks again. The
/// touches are fitted to the earlier touches and not to the anatomy, so that the accuracy of X_AM,
/// from all landmarks of the earlier registration, is preserved.
///
///     X_TM  minimises  sum_j | p_TQ_j - X_TM p_MQ_j |^2        X_AT = X_AM * X_TM^-1
///
/// With errors e_i of the first touches, f_j of those now and J_i (w, v) = w x p_i + v, to first
/// order
///
///     (w, v) = -S^-1 sum_i J_i^T (e_i + h_i) + S'^-1 sum_j J_j^T (e_j - f_j)
///
/// with S = sum J_i^T J_i over all landmarks, S' over those touched again, and h_i the error of the
/// place taken for the landmark, which is the same both times. The e_j occur in both sums: where
/// all landmarks are touched again they cancel, and the error of a new registration remains.
/// Treating the two steps as independent would overestimate the error. All e, f and h are assumed
/// independent of each other. Where the earlier registration has a covariance_A, that of the second
/// sum is added to it instead.
///
/// @pre first and again are above 0, place is not negative; each landmark exists, none is touched
///      twice.
/// @returns TooFewLandmarks below three touches; NotFinite, OutOfRange and DegenerateLandmarks as
///          fitRigid. DegenerateLandmarks also where the touches do not fit the earlier ones
///          (recogniseOrder): the detail names the landmarks that were exchanged, or the one that
///          is an outlier.
[[nodiscard]] Result<ReRegistration> reRegister(const EarlierRegistration& earlier,
                                                std::span<const Retouch> touches,
                                                const TouchErrors& errors);

} // namespace carina
