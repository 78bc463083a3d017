#include "evaluation/anatomy/airway_measures.h"

#include "engine/anatomy/airway/centreline.h"
#include "evaluation/anatomy/mesh_outline.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cctype>
#include <cmath>

namespace carina
{
namespace
{

constexpr int kPlaces = 24;
constexpr int kRounds = 12;

double besides(const TubeLine& line, const Vec3& p)
{
    return (p - line.point).cross(line.direction).norm();
}

/// The straight line that fits points best, turned towards `sense`.
TubeLine fitted(const std::vector<Vec3>& points, const Vec3& sense)
{
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : points)
        mean += p / double(points.size());
    Mat3 scatter = Mat3::Zero();
    for (const Vec3& p : points)
        scatter += (p - mean) * (p - mean).transpose();
    const Vec3 main = Eigen::SelfAdjointEigenSolver<Mat3>{scatter}.eigenvectors().col(2);
    return {mean, main.dot(sense) < 0.0 ? Vec3{-main} : main};
}

const TriangleMesh* finest(const Anatomy& anatomy, PartRole role)
{
    const auto part = std::ranges::find(anatomy.parts, role, &AnatomyPart::role);
    return part == anatomy.parts.end() ? nullptr : &part->levels.front();
}

bool isCricoid(const AnatomyPart& part)
{
    std::string name = part.name;
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return name.find("cricoid cartilage") != std::string::npos;
}

/// How far along the trachea's line it reaches up.
double topOf(const Anatomy& anatomy, const TriangleMesh& trachea, const Vec3& up)
{
    const auto along = [&](const Vec3f& p) { return p.cast<double>().dot(up); };
    for (const AnatomyPart& part : anatomy.parts)
        if (isCricoid(part))
            return along(std::ranges::min(part.levels.front().positions, {}, along));
    return along(std::ranges::max(trachea.positions, {}, along));
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Side to side and front to back over the middle half of a trachea: of its outside, not of the
/// lumen within a wall.
void measureDiameters(const TriangleMesh& trachea, const TubeLine& line, const Vec3& carina,
                      AirwayMeasures& measures)
{
    const Vec3 back = line.direction.cross(Vec3::UnitX()).normalized();
    const Vec3 left = back.cross(line.direction);
    std::vector<double> coronal;
    std::vector<double> sagittal;
    for (int i = 0; i < 4 * kPlaces; ++i) {
        const double along = (0.25 + 0.5 * i / (4.0 * kPlaces)) * measures.trachea.si;
        const auto outlines = outlinesOf(trachea, carina + along * line.direction, line.direction);
        if (outlines.empty())
            continue;
        const Outline& outside = std::ranges::max(outlines, {}, &Outline::area);
        coronal.push_back(outside.extentAlong(left));
        sagittal.push_back(outside.extentAlong(back));
    }
    if (!coronal.empty()) {
        measures.coronal = metres(median(std::move(coronal)));
        measures.sagittal = metres(median(std::move(sagittal)));
    }
}

/// Of a main bronchus between two shares of the trachea's length below the carina.
std::optional<Angle> angleOf(const TriangleMesh& bronchus, const Vec3& carina, const Vec3& up,
                             Side side, Length trachea)
{
    const bool right = side == Side::Right;
    const double sign = right ? -1.0 : 1.0;
    const double guessed = degrees(right ? 30.0 : 45.0).si;
    const Vec3 direction = sign * std::sin(guessed) * Vec3::UnitX() - std::cos(guessed) * up;
    const TubeLine guess{carina, direction.normalized()};
    const auto line = lineThrough(bronchus, carina, guess, (right ? 0.05 : 0.08) * trachea,
                                  (right ? 0.15 : 0.34) * trachea);
    if (!line)
        return std::nullopt;
    return radians(std::acos(std::clamp(-line->direction.dot(up), -1.0, 1.0)));
}

/// Along a path from the place on it that is nearest to a landmark.
Length restOf(const std::vector<Vec3>& path, const Vec3& p)
{
    const auto nearest =
        std::ranges::min_element(path, {}, [&](const Vec3& q) { return (q - p).squaredNorm(); });
    return lengthOf({nearest, path.end()});
}

} // namespace

std::optional<TubeLine> lineThrough(const TriangleMesh& tube, const Vec3& start,
                                    const TubeLine& guess, Length from, Length to)
{
    TubeLine line = guess;
    for (int round = 0; round < kRounds; ++round) {
        std::vector<Vec3> middles;
        for (int i = 0; i < kPlaces; ++i) {
            const double along = from.si + (to.si - from.si) * i / (kPlaces - 1.0);
            const auto outlines = outlinesOf(tube, start + along * line.direction, line.direction);
            const auto nearest = std::ranges::min_element(
                outlines, {}, [&](const Outline& o) { return besides(line, o.centroid); });
            if (nearest != outlines.end())
                middles.push_back(nearest->centroid);
        }
        if (2 * middles.size() < kPlaces)
            return std::nullopt;
        line = fitted(middles, guess.direction);
    }
    return line;
}

std::optional<AirwayMeasures> measureAirway(const Anatomy& anatomy)
{
    const TriangleMesh* trachea = finest(anatomy, PartRole::Trachea);
    const TriangleMesh* right = finest(anatomy, PartRole::RightMainBronchus);
    const TriangleMesh* left = finest(anatomy, PartRole::LeftMainBronchus);
    const AirwayLandmarks& marks = anatomy.landmarks;
    if (trachea == nullptr || right == nullptr || left == nullptr || marks.path_A.size() < 2)
        return std::nullopt;
    const Vec3& carina = marks.p_A_carina;
    const Vec3 towardsGlottis = marks.p_A_glottis - carina;
    const auto line =
        lineThrough(*trachea, carina, {carina, towardsGlottis.normalized()},
                    metres(0.25 * towardsGlottis.norm()), metres(0.75 * towardsGlottis.norm()));
    if (!line)
        return std::nullopt;
    const Vec3& up = line->direction;
    AirwayMeasures measures;
    measures.trachea = metres(topOf(anatomy, *trachea, up) - carina.dot(up));
    measureDiameters(*trachea, *line, carina, measures);
    const auto rightAngle = angleOf(*right, carina, up, Side::Right, measures.trachea);
    const auto leftAngle = angleOf(*left, carina, up, Side::Left, measures.trachea);
    if (!rightAngle || !leftAngle)
        return std::nullopt;
    measures.rightBronchus = *rightAngle;
    measures.leftBronchus = *leftAngle;
    measures.teethToCarina = restOf(marks.path_A, marks.p_A_incisors);
    measures.cordsToCarina = restOf(marks.path_A, marks.p_A_glottis);
    return measures;
}

} // namespace carina
