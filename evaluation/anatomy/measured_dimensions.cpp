#include "evaluation/anatomy/measured_dimensions.h"

#include "engine/anatomy/laryngoscopy/upper_airway.h"
#include "evaluation/anatomy/airway_measures.h"
#include "evaluation/anatomy/mesh_outline.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace carina
{
namespace
{

using Dimensions = std::map<std::string, double>;

constexpr double kMidplane_m = 2e-3; ///< of what counts as in the midplane, to either side
constexpr int kSections = 48;

const TriangleMesh* meshNamed(const Anatomy& anatomy, const char* name)
{
    const auto part = std::ranges::find(anatomy.parts, std::string{name}, &AnatomyPart::name);
    return part == anatomy.parts.end() ? nullptr : &part->levels.front();
}

const TriangleMesh* meshOfRole(const Anatomy& anatomy, PartRole role)
{
    const auto part = std::ranges::find(anatomy.parts, role, &AnatomyPart::role);
    return part == anatomy.parts.end() ? nullptr : &part->levels.front();
}

std::vector<Vec3> verticesOf(const TriangleMesh& mesh)
{
    std::vector<Vec3> vertices;
    for (const Vec3f& p : mesh.positions)
        vertices.emplace_back(p.cast<double>());
    return vertices;
}

/// From the least to the greatest projection of points on a direction.
struct Extent {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();

    void include(double along)
    {
        least = std::min(least, along);
        most = std::max(most, along);
    }
    [[nodiscard]] double size() const { return most > least ? most - least : 0.0; }
};

template <class Counts>
Extent extentAlong(const std::vector<Vec3>& points, const Vec3& direction, const Counts& counts)
{
    Extent extent;
    for (const Vec3& p : points)
        if (counts(p))
            extent.include(p.dot(direction));
    return extent;
}

Extent extentAlong(const std::vector<Vec3>& points, const Vec3& direction)
{
    return extentAlong(points, direction, [](const Vec3&) { return true; });
}

/// The direction in which points are spread most.
Vec3 longAxisOf(const std::vector<Vec3>& points)
{
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : points)
        mean += p / double(points.size());
    Mat3 scatter = Mat3::Zero();
    for (const Vec3& p : points)
        scatter += (p - mean) * (p - mean).transpose();
    return Eigen::SelfAdjointEigenSolver<Mat3>{scatter}.eigenvectors().col(2);
}

/// What a ring encloses in a section: the smaller of its two outlines; nothing where it has not
/// two.
std::optional<Outline> openingAt(const TriangleMesh& ring, const Vec3& p, const Vec3& normal)
{
    const std::vector<Outline> outlines = outlinesOf(ring, p, normal);
    if (outlines.size() != 2)
        return std::nullopt;
    return std::ranges::min(outlines, {}, &Outline::area);
}

double medianOf(std::vector<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Axes of the larynx and trachea.
struct Axes {
    Vec3 up = Vec3::UnitZ();
    Vec3 back = Vec3::UnitY();
    Vec3 left = Vec3::UnitX();
};

Axes axesAlong(const Vec3& up)
{
    const Vec3 back = up.cross(Vec3::UnitX()).normalized();
    return {up, back, back.cross(up)};
}

void measureTrachea(const Anatomy& anatomy, const Axes& axes, Dimensions& found)
{
    const auto airway = measureAirway(anatomy);
    if (!airway)
        return;
    found["trachea_length_mm"] = inMillimetres(airway->trachea);
    found["right_bronchus_deg"] = inDegrees(airway->rightBronchus);
    found["left_bronchus_deg"] = inDegrees(airway->leftBronchus);
    found["subcarinal_deg"] = inDegrees(airway->rightBronchus + airway->leftBronchus);
    found["teeth_to_carina_mm"] = inMillimetres(airway->teethToCarina);
    const TriangleMesh& trachea = *meshOfRole(anatomy, PartRole::Trachea);
    std::vector<double> coronal;
    std::vector<double> sagittal;
    std::vector<double> areas;
    for (int i = 0; i < kSections; ++i) {
        const double share = 0.25 + 0.5 * i / (kSections - 1.0);
        const Vec3 p_A = anatomy.landmarks.p_A_carina + share * airway->trachea.si * axes.up;
        const auto lumen = openingAt(trachea, p_A, axes.up);
        if (!lumen)
            continue;
        coronal.push_back(lumen->extentAlong(axes.left));
        sagittal.push_back(lumen->extentAlong(axes.back));
        areas.push_back(lumen->area);
    }
    if (areas.empty())
        return;
    found["trachea_lumen_coronal_mm"] = 1e3 * medianOf(coronal);
    found["trachea_lumen_sagittal_mm"] = 1e3 * medianOf(sagittal);
    const double area = medianOf(areas);
    found["trachea_lumen_mm2"] = 1e6 * area;
    found["trachea_lumen_ml"] = 1e6 * area * airway->trachea.si;
}

void measureGlottis(const Anatomy& anatomy, const UpperAirway& airway, Dimensions& found)
{
    const Vec3 along = (airway.p_A_notch - airway.p_A_commissure).normalized();
    const Vec3 middle = 0.5 * (airway.p_A_notch + airway.p_A_commissure);
    found["glottis_mm"] = inMillimetres(airway.glottis());
    found["cords_to_carina_mm"] = 1e3 * airway.up_A.dot(middle - anatomy.landmarks.p_A_carina);
    if (const TriangleMesh* fold = meshNamed(anatomy, "Left vocal fold"))
        found["vocal_fold_mm"] = 1e3 * extentAlong(verticesOf(*fold), along).size();
}

void measureEpiglottis(const Anatomy& anatomy, const UpperAirway& airway, Dimensions& found)
{
    const TriangleMesh* leaf = meshOfRole(anatomy, PartRole::Epiglottis);
    if (leaf == nullptr)
        return;
    const Vec3 whole = airway.p_A_epiglottisTip - airway.p_A_epiglottisBase;
    const Vec3 axis = whole.normalized();
    found["epiglottis_length_mm"] = 1e3 * whole.norm();
    found["epiglottis_width_mm"] = 1e3 * extentAlong(verticesOf(*leaf), Vec3::UnitX()).size();
    const Vec3 through = axis.cross(Vec3::UnitX()).normalized();
    Extent thick;
    for (const Outline& outline : outlinesOf(*leaf, airway.p_A_epiglottisBase + 0.5 * whole, axis))
        for (const Vec3& p : outline.points)
            if (std::abs(p.x() - airway.p_A_epiglottisBase.x()) < kMidplane_m)
                thick.include(p.dot(through));
    if (thick.size() > 0.0)
        found["epiglottis_thickness_mm"] = 1e3 * thick.size();
}

void measureCricoid(const Anatomy& anatomy, const Axes& axes, const UpperAirway& airway,
                    Dimensions& found)
{
    const TriangleMesh* ring = meshNamed(anatomy, "Cricoid cartilage");
    if (ring == nullptr)
        return;
    const std::vector<Vec3> points = verticesOf(*ring);
    const double x = airway.p_A_commissure.x();
    const Extent deep = extentAlong(points, axes.back);
    const double middle = 0.5 * (deep.least + deep.most);
    const auto inMidplane = [&](const Vec3& p) { return std::abs(p.x() - x) < kMidplane_m; };
    const auto isBehind = [&](const Vec3& p) { return p.dot(axes.back) > middle; };
    const Extent arch =
        extentAlong(points, axes.up, [&](const Vec3& p) { return inMidplane(p) && !isBehind(p); });
    const Extent lamina =
        extentAlong(points, axes.up, [&](const Vec3& p) { return inMidplane(p) && isBehind(p); });
    found["cricoid_arch_mm"] = 1e3 * arch.size();
    found["cricoid_lamina_mm"] = 1e3 * lamina.size();
    const double level = 0.5 * (arch.least + arch.most);
    if (const auto opening = openingAt(*ring, level * axes.up, axes.up)) {
        found["cricoid_inner_coronal_mm"] = 1e3 * opening->extentAlong(axes.left);
        found["cricoid_inner_sagittal_mm"] = 1e3 * opening->extentAlong(axes.back);
    }
    found["epiglottis_to_cricoid_mm"] = 1e3 * (airway.p_A_epiglottisTip.dot(axes.up) - arch.least);
    if (const TriangleMesh* thyroid = meshNamed(anatomy, "Thyroid cartilage")) {
        const Extent notch = extentAlong(verticesOf(*thyroid), axes.up, inMidplane);
        found["thyroid_notch_to_cricoid_mm"] = 1e3 * (notch.most - arch.least);
    }
}

/// Of the mandible below the middle of its height: its angles are the farthest apart there.
void measureMandible(const Anatomy& anatomy, Dimensions& found)
{
    const TriangleMesh* mandible = meshOfRole(anatomy, PartRole::Mandible);
    if (mandible == nullptr)
        return;
    const std::vector<Vec3> points = verticesOf(*mandible);
    const Extent high = extentAlong(points, Vec3::UnitZ());
    const double middle = 0.5 * (high.least + high.most);
    const auto isLow = [middle](const Vec3& p) { return p.z() < middle; };
    found["bigonial_mm"] = 1e3 * extentAlong(points, Vec3::UnitX(), isLow).size();
}

void measureLength(const Anatomy& anatomy, const char* part, const char* name, Dimensions& found)
{
    if (const TriangleMesh* mesh = meshNamed(anatomy, part)) {
        const std::vector<Vec3> points = verticesOf(*mesh);
        found[name] = 1e3 * extentAlong(points, longAxisOf(points)).size();
    }
}

void measureVolumes(const Anatomy& anatomy, Dimensions& found)
{
    double tongue = 0.0;
    double right = 0.0;
    double both = 0.0;
    for (const AnatomyPart& part : anatomy.parts) {
        if (part.role == PartRole::Tongue)
            tongue += signedVolume(part.levels.front());
        if (const auto side = lungSide(part.role)) {
            const double volume = signedVolume(part.levels.front());
            both += volume;
            right += *side == Side::Right ? volume : 0.0;
        }
    }
    if (tongue > 0.0)
        found["tongue_ml"] = 1e6 * tongue;
    if (both > 0.0)
        found["right_lung_percent"] = 100.0 * right / both;
}

} // namespace

std::map<std::string, double> measuredDimensions(const Anatomy& anatomy)
{
    Dimensions found;
    measureVolumes(anatomy, found);
    measureMandible(anatomy, found);
    measureLength(anatomy, "Manubrium", "manubrium_mm", found);
    measureLength(anatomy, "Body of sternum", "sternal_body_mm", found);
    const auto airway = upperAirwayOf(anatomy.parts, anatomy.landmarks);
    if (!airway)
        return found;
    const Axes axes = axesAlong(airway->up_A);
    measureTrachea(anatomy, axes, found);
    measureGlottis(anatomy, *airway, found);
    measureEpiglottis(anatomy, *airway, found);
    measureCricoid(anatomy, axes, *airway, found);
    return found;
}

} // namespace carina
