#include "engine/io/anatomy_set/set_check.h"

#include <algorithm>

namespace carina
{
namespace
{

constexpr double kFarthest = 10.0; ///< metres from the carina
constexpr std::size_t kMostPoints = 4096;
constexpr double kShortestStep = 1e-6; ///< of the tube's way, metres
constexpr double kLongestStep = 0.1;

bool isNear(const Vec3& p_A) { return p_A.allFinite() && p_A.cwiseAbs().maxCoeff() <= kFarthest; }

bool isDrawable(const TriangleMesh& mesh)
{
    const auto isFinite = [](const Vec3f& v) { return v.allFinite(); };
    return !mesh.positions.empty() && mesh.normals.size() == mesh.positions.size()
           && std::ranges::all_of(mesh.positions,
                                  [](const Vec3f& p) { return isNear(p.cast<double>()); })
           && std::ranges::all_of(mesh.normals, isFinite);
}

bool goesOn(const std::vector<Vec3>& path_A)
{
    if (path_A.size() > kMostPoints || !std::ranges::all_of(path_A, isNear))
        return false;
    for (std::size_t i = 1; i < path_A.size(); ++i) {
        const Vec3 step = path_A[i] - path_A[i - 1];
        if (!(step.norm() >= kShortestStep && step.norm() <= kLongestStep))
            return false;
        if (i > 1 && !(step.dot(path_A[i - 1] - path_A[i - 2]) > 0.0))
            return false;
    }
    return true;
}

} // namespace

Result<void> checkSet(const ImportedSet& set)
{
    const AirwayLandmarks& landmarks = set.anatomy.landmarks;
    for (const Vec3& p_A : {landmarks.p_A_incisors, landmarks.p_A_glottis, landmarks.p_A_carina})
        if (!isNear(p_A))
            return fail(Errc::FileMalformed, "a landmark lies near the patient");
    if (!goesOn(landmarks.path_A))
        return fail(Errc::FileMalformed, "the airway goes on from point to point");
    for (const AnatomyPart& part : set.anatomy.parts)
        if (!std::ranges::all_of(part.levels, isDrawable))
            return fail(Errc::FileMalformed, "a surface can be drawn");
    return {};
}

} // namespace carina
