#include "apps/lab/breathing/drawn_lungs.h"

namespace carina::lab
{
namespace
{

Volume enclosedVolume(const std::vector<Vec3f>& positions, const std::vector<Triangle>& triangles)
{
    const Vec3 apex = positions.front().cast<double>();
    double sum = 0.0;
    for (const auto& [i, j, k] : triangles) {
        const Vec3 u = positions[i].cast<double>() - apex;
        const Vec3 v = positions[j].cast<double>() - apex;
        const Vec3 w = positions[k].cast<double>() - apex;
        sum += u.x() * (v.y() * w.z() - v.z() * w.y()) + u.y() * (v.z() * w.x() - v.x() * w.z())
               + u.z() * (v.x() * w.y() - v.y() * w.x());
    }
    return cubicMetres(sum / 6.0);
}

} // namespace

Result<DrawnLungs> DrawnLungs::of(const LungPair& lungs, std::size_t level)
{
    DrawnLungs drawn{lungs.field()};
    for (const BreathingPart& part : lungs.parts()) {
        const TriangleMesh& mesh = levelOf(part, level);
        Result<DrawnVertices> vertices = DrawnVertices::of(mesh);
        if (!vertices)
            return tl::unexpected(vertices.error());
        drawn.m_parts.push_back({part.side, part.region, &mesh.triangles, std::move(*vertices)});
    }
    return drawn;
}

Result<std::array<Volume, 2>> DrawnLungs::volumes(const ChestPose& pose)
{
    std::array<Volume, 2> sums;
    for (Part& part : m_parts) {
        const auto drawn = part.vertices.at(m_field, motionOf(part.region, pose, m_field));
        if (!drawn)
            return tl::unexpected(drawn.error());
        Volume& sum = sums[indexOf(part.side)];
        sum = sum + enclosedVolume(drawn->positions, *part.triangles);
    }
    return sums;
}

} // namespace carina::lab
