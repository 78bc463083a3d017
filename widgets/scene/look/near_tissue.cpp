#include "widgets/scene/look/near_tissue.h"

#include <cmath>
#include <numbers>

namespace carina
{
namespace
{

constexpr float kReach_m = static_cast<float>(NearTissue::kReach.si);
constexpr float kCell_m = static_cast<float>(NearTissue::kCell.si);
constexpr float kMost_m = static_cast<float>(NearTissue::kMost.si);

/// What rises less above the plane of a place does not hide it: a surface that is a little hollow
/// would shade itself. Of ours.
constexpr float kLeastSine = 0.1F;

/// How much of the half space above a plane a disc hides, seen from the plane.
/// @param from to its centre, metres
float hiddenBy(const Vec3f& from, float area, const Vec3f& normal)
{
    const float far2 = from.squaredNorm();
    if (far2 >= kReach_m * kReach_m || far2 <= 0.0F)
        return 0.0F;
    const float sine = normal.dot(from) / std::sqrt(far2) - kLeastSine;
    if (sine <= 0.0F)
        return 0.0F;
    const float fading = 1.0F - far2 / (kReach_m * kReach_m);
    return fading * fading * sine * area / (std::numbers::pi_v<float> * far2 + area);
}

} // namespace

NearTissue::NearTissue(std::span<const TriangleMesh* const> meshes)
{
    Box bounds;
    for (const TriangleMesh* mesh : meshes)
        bounds.include(boundsOf(*mesh));
    if (bounds.empty())
        return;
    m_corner = bounds.min.cast<float>();
    const Vec3f extent = bounds.max.cast<float>() - m_corner;
    if (extent.maxCoeff() > kMost_m)
        return; // no tissue of a throat
    m_cells = cellOf(bounds.max.cast<float>()) + Cell::Ones();
    m_discs.resize(placeOf(m_cells - Cell::Ones()) + 1);
    for (const TriangleMesh* mesh : meshes)
        add(*mesh);
    for (Disc& disc : m_discs)
        if (disc.area > 0.0F)
            disc.centre /= disc.area;
}

NearTissue::Cell NearTissue::cellOf(const Vec3f& p) const
{
    return ((p - m_corner) / kCell_m).array().floor().cast<int>().matrix();
}

std::size_t NearTissue::placeOf(const Cell& cell) const
{
    const auto along = [&cell](int axis) { return static_cast<std::size_t>(cell[axis]); };
    const auto count = [this](int axis) { return static_cast<std::size_t>(m_cells[axis]); };
    return (along(2) * count(1) + along(1)) * count(0) + along(0);
}

void NearTissue::add(const TriangleMesh& mesh)
{
    for (const Triangle& t : mesh.triangles) {
        const Vec3f& a = mesh.positions[t[0]];
        const Vec3f& b = mesh.positions[t[1]];
        const Vec3f& c = mesh.positions[t[2]];
        const Vec3f centre = (a + b + c) / 3.0F;
        const float area = 0.5F * (b - a).cross(c - a).norm();
        // A mean can be rounded to beyond what it is of.
        Disc& disc = m_discs[placeOf(cellOf(centre).cwiseMax(0).cwiseMin(m_cells - Cell::Ones()))];
        disc.centre += area * centre;
        disc.area += area;
    }
}

float NearTissue::hiddenAt(const Vec3f& p, const Vec3f& normal) const
{
    if (m_discs.empty())
        return 0.0F;
    const Vec3f reach = Vec3f::Constant(kReach_m);
    const Cell low = cellOf(p - reach).cwiseMax(0);
    const Cell high = cellOf(p + reach).cwiseMin(m_cells - Cell::Ones());
    float sum = 0.0F;
    for (int z = low.z(); z <= high.z(); ++z)
        for (int y = low.y(); y <= high.y(); ++y)
            for (int x = low.x(); x <= high.x(); ++x) {
                const Disc& disc = m_discs[placeOf({x, y, z})];
                if (disc.area > 0.0F)
                    sum += hiddenBy(disc.centre - p, disc.area, normal);
            }
    return 1.0F - std::exp(-sum);
}

} // namespace carina
