#include "engine/geometry/mesh/surface_feature.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace carina
{
namespace
{

constexpr int kUnknowns = 6;
constexpr double kLeastBend = 0.1;   // radians over the scale
constexpr double kFaintShare = 0.5;  // of the strongest feature
constexpr double kSideways = 0.7071; // cosine of 45 degrees

/// The part of a mesh near a place.
class Patch
{
public:
    Patch(const TriangleMesh& mesh, const Vec3& p, double radius)
    {
        std::map<std::uint32_t, std::size_t> known;
        const auto isNear = [&](std::uint32_t v) {
            return (mesh.positions[v].cast<double>() - p).norm() <= radius;
        };
        const auto add = [&](std::uint32_t v) {
            const auto [place, isNew] = known.try_emplace(v, m_positions.size());
            if (isNew) {
                m_vertices.push_back(v);
                m_positions.push_back(mesh.positions[v].cast<double>());
                m_normals.push_back(Vec3::Zero());
                m_neighbours.emplace_back();
            }
            return place->second;
        };
        for (const Triangle& t : mesh.triangles) {
            if (!isNear(t[0]) && !isNear(t[1]) && !isNear(t[2]))
                continue;
            const std::array<std::size_t, 3> corners{add(t[0]), add(t[1]), add(t[2])};
            addTriangle(corners);
        }
    }

    [[nodiscard]] std::size_t size() const { return m_positions.size(); }
    [[nodiscard]] std::uint32_t vertex(std::size_t i) const { return m_vertices[i]; }
    [[nodiscard]] const Vec3& position(std::size_t i) const { return m_positions[i]; }

    /// What edges reach from a vertex without leaving a ball about it, the vertex first.
    [[nodiscard]] std::vector<std::size_t> within(std::size_t i, double radius) const
    {
        std::vector<std::size_t> reached{i};
        for (std::size_t next = 0; next < reached.size(); ++next)
            for (const std::size_t neighbour : m_neighbours[reached[next]])
                if ((m_positions[neighbour] - m_positions[i]).norm() <= radius
                    && std::ranges::find(reached, neighbour) == reached.end())
                    reached.push_back(neighbour);
        return reached;
    }

    [[nodiscard]] std::optional<Curvature> curvature(std::size_t i, double scale) const;

private:
    void addTriangle(const std::array<std::size_t, 3>& corners)
    {
        const Vec3 normal = (m_positions[corners[1]] - m_positions[corners[0]])
                                .cross(m_positions[corners[2]] - m_positions[corners[0]]);
        for (std::size_t k = 0; k < 3; ++k) {
            m_normals[corners[k]] += normal;
            for (const std::size_t other : {corners[(k + 1) % 3], corners[(k + 2) % 3]})
                if (std::ranges::find(m_neighbours[corners[k]], other)
                    == m_neighbours[corners[k]].end())
                    m_neighbours[corners[k]].push_back(other);
        }
    }

    std::vector<std::uint32_t> m_vertices; ///< of the mesh
    std::vector<Vec3> m_positions;
    std::vector<Vec3> m_normals; ///< of any length
    std::vector<std::vector<std::size_t>> m_neighbours;
};

std::optional<Curvature> Patch::curvature(std::size_t i, double scale) const
{
    std::vector<Vec3> offsets;
    for (const std::size_t other : within(i, scale))
        offsets.push_back(m_positions[other] - m_positions[i]);
    return fittedCurvature(offsets, m_normals[i], metres(scale));
}

/// The curvatures of a patch, computed on first use.
class CurvedPatch
{
public:
    CurvedPatch(const Patch& patch, SurfaceFeature feature, double scale)
        : m_patch{patch}, m_feature{feature}, m_scale{scale}, m_known(patch.size())
    {
    }

    const std::optional<Curvature>& at(std::size_t i)
    {
        if (!m_known[i])
            m_known[i] = m_patch.curvature(i, m_scale);
        return *m_known[i];
    }

    /// What a feature has most of; nothing where the curvature is unknown.
    std::optional<double> strength(std::size_t i)
    {
        const auto& curvature = at(i);
        if (!curvature)
            return std::nullopt;
        return m_feature == SurfaceFeature::Tip ? curvature->least : curvature->most;
    }

    bool isExtreme(std::size_t i)
    {
        const double own = *strength(i);
        const auto isMore = [&](std::size_t other) {
            const std::optional<double> strength = this->strength(other);
            return strength && *strength > own;
        };
        const auto isAside = [&](std::size_t other) {
            const Vec3 off = m_patch.position(other) - m_patch.position(i);
            return m_feature == SurfaceFeature::Tip
                   || std::abs(off.dot(at(i)->dir_most)) >= kSideways * off.norm();
        };
        const std::vector<std::size_t> near = m_patch.within(i, m_scale);
        return std::none_of(near.begin() + 1, near.end(),
                            [&](std::size_t other) { return isAside(other) && isMore(other); });
    }

private:
    const Patch& m_patch;
    SurfaceFeature m_feature;
    double m_scale;
    std::vector<std::optional<std::optional<Curvature>>> m_known;
};

} // namespace

std::optional<Curvature> fittedCurvature(std::span<const Vec3> offsets, const Vec3& normal,
                                         Length scale)
{
    if (normal.isZero())
        return std::nullopt;
    const Vec3 w = normal.normalized();
    const Vec3 u = w.unitOrthogonal();
    const Vec3 v = w.cross(u);
    Eigen::Matrix<double, Eigen::Dynamic, kUnknowns> terms(Eigen::Index(offsets.size()), kUnknowns);
    Eigen::VectorXd heights(Eigen::Index(offsets.size()));
    Eigen::Index row = 0;
    for (const Vec3& offset : offsets) {
        // In units of the scale, so that all columns are of one size.
        const double x = offset.dot(u) / scale.si;
        const double y = offset.dot(v) / scale.si;
        terms.row(row) << 1.0, x, y, 0.5 * x * x, x * y, 0.5 * y * y;
        heights[row++] = offset.dot(w) / scale.si;
    }
    const Eigen::ColPivHouseholderQR<decltype(terms)> solver{terms};
    if (solver.rank() < kUnknowns)
        return std::nullopt;
    const Eigen::Matrix<double, kUnknowns, 1> fit = solver.solve(heights);
    Eigen::Matrix2d bends; // away from the normal where it is convex
    bends << -fit[3], -fit[4], -fit[4], -fit[5];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> bent{bends / scale.si};
    const Eigen::Vector2d most = bent.eigenvectors().col(1);
    return Curvature{bent.eigenvalues()[0], bent.eigenvalues()[1], most[0] * u + most[1] * v};
}

std::optional<FeaturePoint> nearestFeature(const TriangleMesh& mesh, const Vec3& p,
                                           SurfaceFeature feature, const FeatureSettings& settings)
{
    const double scale = settings.scale.si;
    // What is extreme is compared within the scale, with curvatures fitted within the scale.
    const Patch patch{mesh, p, settings.radius.si + 2.0 * scale};
    CurvedPatch curved{patch, feature, scale};
    struct Found {
        double distance;
        std::uint32_t vertex;
        std::size_t place;
        double strength;
    };
    std::vector<Found> found;
    double strongest = kLeastBend / scale / kFaintShare;
    for (std::size_t i = 0; i < patch.size(); ++i) {
        const double distance = (patch.position(i) - p).norm();
        const std::optional<double> strength =
            distance <= settings.radius.si ? curved.strength(i) : std::nullopt;
        if (!strength || *strength < kFaintShare * strongest || !curved.isExtreme(i))
            continue;
        strongest = std::max(strongest, *strength);
        found.push_back({distance, patch.vertex(i), i, *strength});
    }
    std::erase_if(found, [&](const Found& f) { return f.strength < kFaintShare * strongest; });
    if (found.empty())
        return std::nullopt;
    const Found nearest = *std::ranges::min_element(found, [](const Found& a, const Found& b) {
        return std::pair{a.distance, a.vertex} < std::pair{b.distance, b.vertex};
    });
    return FeaturePoint{nearest.vertex, patch.position(nearest.place), *curved.at(nearest.place)};
}

} // namespace carina
