#include "engine/tracking/igtl/igtl_pose.h"

#include <cmath>

namespace carina
{
namespace
{

constexpr double kMillimetre = 1e-3;
constexpr double kFarthestTool = 100.0; // m
constexpr double kShortestQuaternion = 0.5;
constexpr double kLongestQuaternion = 2.0;
constexpr unsigned kFractionBits = 32;
constexpr std::uint64_t kNanoseconds = 1'000'000'000;

Result<RigidTransform> within(const RigidTransform& X)
{
    if (X.translation().norm() > kFarthestTool)
        return fail(Errc::OutOfRange, "a position beyond 100 m");
    return X;
}

Result<RigidTransform> poseOf(const std::array<float, 3>& p, const Quat& q)
{
    const Vec3 position = kMillimetre * Vec3{p[0], p[1], p[2]};
    if (!position.allFinite() || !q.coeffs().allFinite())
        return fail(Errc::NotFinite, "a pose");
    if (q.norm() < kShortestQuaternion || q.norm() > kLongestQuaternion)
        return fail(Errc::NotARotation, "a quaternion");
    return within({q, position});
}

Quat quaternionOf(const std::array<float, 4>& q) { return {q[3], q[0], q[1], q[2]}; }

} // namespace

Result<RigidTransform> poseOf(const IgtlMatrix& matrix)
{
    Mat4 m = Mat4::Identity();
    for (Eigen::Index column = 0; column < 4; ++column)
        for (Eigen::Index row = 0; row < 3; ++row)
            m(row, column) = matrix[static_cast<std::size_t>(3 * column + row)];
    m.topRightCorner<3, 1>() *= kMillimetre;
    return RigidTransform::fromMatrix(m).and_then(within);
}

Result<RigidTransform> poseOf(const IgtlPosition& position)
{
    Quat q = quaternionOf(position.q);
    if (position.terms == 0)
        q = Quat::Identity();
    if (position.terms == 3)
        q.w() = std::sqrt(std::max(0.0, 1.0 - q.vec().squaredNorm()));
    return poseOf(position.p, q);
}

Result<RigidTransform> poseOf(const IgtlQuaternionTracked& tool)
{
    return poseOf(tool.p, quaternionOf(tool.q));
}

bool isPlaceholder(const RigidTransform& X)
{
    return X.translation() == Vec3::Zero() && X.rotation().vec() == Vec3::Zero();
}

IgtlMatrix igtlMatrix(const RigidTransform& X)
{
    const Mat4 m = X.matrix();
    IgtlMatrix matrix{};
    for (Eigen::Index column = 0; column < 4; ++column)
        for (Eigen::Index row = 0; row < 3; ++row)
            matrix[static_cast<std::size_t>(3 * column + row)] =
                static_cast<float>(column < 3 ? m(row, column) : m(row, column) / kMillimetre);
    return matrix;
}

std::array<float, 3> igtlPoint(const Vec3& p)
{
    const Eigen::Vector3f inMm = (p / kMillimetre).cast<float>();
    return {inMm.x(), inMm.y(), inMm.z()};
}

std::array<float, 4> igtlQuaternion(const RigidTransform& X)
{
    const auto q = X.rotation().cast<float>();
    return {q.x(), q.y(), q.z(), q.w()};
}

void appendSurface(IgtlPolyData& data, const RigidTransform& X_GF, const TriangleMesh& mesh_F)
{
    const auto first = static_cast<std::uint32_t>(data.points.size());
    for (const Vec3f& p : mesh_F.positions)
        data.points.push_back(igtlPoint(X_GF * p.cast<double>()));
    IgtlCells& polygons = data.cells[kIgtlPolygons];
    polygons.count += static_cast<std::uint32_t>(mesh_F.triangles.size());
    for (const Triangle& triangle : mesh_F.triangles) {
        polygons.numbers.push_back(3);
        for (const std::uint32_t corner : triangle)
            polygons.numbers.push_back(first + corner);
    }
}

std::uint64_t igtlStamp(Duration since1970)
{
    const auto ns = static_cast<std::uint64_t>(since1970.count());
    return ((ns / kNanoseconds) << kFractionBits)
           | (((ns % kNanoseconds) << kFractionBits) / kNanoseconds);
}

Duration sinceEpoch(std::uint64_t stamp)
{
    const std::uint64_t fraction = stamp & 0xFFFF'FFFFU;
    const std::uint64_t seconds = stamp >> kFractionBits;
    return Duration{static_cast<std::int64_t>(
        seconds * kNanoseconds
        + ((fraction * kNanoseconds + (std::uint64_t{1} << (kFractionBits - 1)))
           >> kFractionBits))};
}

} // namespace carina
