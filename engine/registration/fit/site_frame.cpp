#include "engine/registration/fit/site_frame.h"

#include "engine/geometry/fit/point_check.h"
#include "engine/geometry/fit/rigid_fit.h"

namespace carina
{

Result<RigidTransform> siteFrame(std::span<const Vec3> p_TQ)
{
    if (p_TQ.size() < 3)
        return fail(Errc::TooFewLandmarks,
                    std::to_string(p_TQ.size()) + " landmarks, and 3 are the fewest");
    Vec3 p_TM = Vec3::Zero();
    for (const Vec3& p : p_TQ) {
        if (const auto sound = checkPoint(p, "a touched landmark"); !sound)
            return tl::unexpected(sound.error());
        p_TM += p / double(p_TQ.size());
    }
    const Vec3 along = p_TQ[0] - p_TQ[1];
    if (along.norm() < kSmallestExtent.si)
        return fail(Errc::DegenerateLandmarks, "the first two lie at one place");
    const Vec3 z_T = along.normalized();
    const Vec3 toThird = p_TQ[2] - p_TQ[1];
    const Vec3 aside = toThird - toThird.dot(z_T) * z_T;
    if (aside.norm() < kCollinearShare * along.norm())
        return fail(Errc::DegenerateLandmarks, "the first three lie on one line");
    Mat3 R_TM;
    R_TM.col(0) = aside.normalized();
    R_TM.col(1) = z_T.cross(R_TM.col(0));
    R_TM.col(2) = z_T;
    return RigidTransform{Quat{R_TM}, p_TM};
}

} // namespace carina
