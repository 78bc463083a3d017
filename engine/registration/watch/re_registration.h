#pragma once

#include "engine/registration/fit/rigid_fit.h"
#include "engine/registration/fit/uncertain_transform.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace carina
{

/// A landmark Q of a registration, as it was touched then.
struct RegisteredLandmark {
    std::string name;
    Vec3 p_AQ = Vec3::Zero(); ///< in the anatomy frame A, metres
    Vec3 p_MQ = Vec3::Zero(); ///< touched, in the manikin frame M
};

/// A registration made before the manikin was moved.
struct EarlierRegistration {
    RigidTransform X_AM; ///< fitted (fitRigid) to all these landmarks
    std::vector<RegisteredLandmark> landmarks;
    /// Of X_AM where more than these landmarks made it, as a refinement on a surface.
    std::optional<Mat6> covariance_A{};
};

/// One of its landmarks touched again, where the manikin lies now.
struct Retouch {
    std::size_t landmark = 0; ///< its place among those of the registration
    Vec3 p_TQ = Vec3::Zero(); ///< in the tracker frame T, metres
};

/// How far touches stray, alike in all directions: roots of expected squared lengths.
struct TouchErrors {
    Length first;   ///< of a touch when the manikin was registered, above 0
    Length again;   ///< of a touch now, above 0
    Length place{}; ///< of the place that was taken for the landmark, both times the same
};

/// The anatomy laid on a manikin that was moved.
struct ReRegistration {
    RigidTransform X_TM; ///< where the manikin lies now
    RigidTransform X_AT; ///< X_AM * X_TM^-1
    /// |p_TQ - X_TM p_MQ| of each touch, metres, in their order: two touches of the same place
    std::vector<double> residuals{};
    double rms = 0.0; ///< of these
    /// Of X_AT as UncertainTransform has it; targetError tells what it makes at a place.
    Mat6 covariance_A = Mat6::Zero();
    /// How many orders of the touches would fit as well; more than one: those landmarks are alike
    /// on both sides, and left may be right.
    std::size_t explanations = 1;
};

/// Registers a manikin anew by touching three or more of its landmarks again. The manikin is the
/// same, so the touches are fitted to the earlier touches and not to the anatomy: what X_AM owes to
/// all the landmarks of the first time is kept.
///
///     X_TM  minimises  sum_j | p_TQ_j - X_TM p_MQ_j |^2        X_AT = X_AM * X_TM^-1
///
/// With first touches off by e_i, those now by f_j and J_i (w, v) = w x p + v, to first order
///
///     (w, v) = -S^-1 sum_i J_i^T (e_i + h_i) + S'^-1 sum_j J_j^T (e_j - f_j)
///
/// with S = sum J_i^T J_i over all landmarks, S' over those touched again, and h_i the error of the
/// place, which the hand finds again. The e_j are in both sums: where all landmarks are touched
/// again they cancel, and what is left is the error of a new registration. Taken for independent,
/// the two steps would look worse than they are. All e, f and h are taken for independent.
///
/// @pre errors are above 0; each landmark exists, and none is touched twice.
/// @returns TooFewLandmarks below three touches; NotFinite, OutOfRange and DegenerateLandmarks as
///          fitRigid. DegenerateLandmarks also where the touches are not as far from each other as
///          they were, by more than all but one of a thousand (chi-squared): the detail says which
///          were exchanged, or which landmark stands out.
[[nodiscard]] Result<ReRegistration> reRegister(const EarlierRegistration& earlier,
                                                std::span<const Retouch> touches,
                                                const TouchErrors& errors);

} // namespace carina
