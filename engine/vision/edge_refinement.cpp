#include "engine/vision/edge_refinement.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace carina
{
namespace
{

constexpr double kStep = 0.5;         ///< between samples across an edge, pixels
constexpr double kLongestReach = 4.0; ///< from an edge, pixels
constexpr double kShortestReach = 1.5;
constexpr double kEnd = 0.1;      ///< share of an edge at each end that is left out
constexpr double kRise = 12.0;    ///< least rise of grey over a pixel
constexpr double kOutlier = 0.75; ///< pixels
constexpr std::size_t kFewest = 5;
constexpr double kFarthest = 3.0; ///< that a corner may move, pixels

/// Grey between pixels; nothing outside the picture.
std::optional<double> greyAt(const GreyPicture& picture, const Vec2& at)
{
    const int x = int(std::floor(at.x()));
    const int y = int(std::floor(at.y()));
    if (x < 0 || y < 0 || x + 1 >= picture.width || y + 1 >= picture.height)
        return std::nullopt;
    const double u = at.x() - x;
    const double v = at.y() - y;
    return (1.0 - v) * ((1.0 - u) * picture.at(x, y) + u * picture.at(x + 1, y))
           + v * ((1.0 - u) * picture.at(x, y + 1) + u * picture.at(x + 1, y + 1));
}

/// How far outwards from a point the grey rises most: the centroid of the rise around its peak.
std::optional<double> riseAlong(const GreyPicture& picture, const Vec2& from, const Vec2& outwards,
                                double reach)
{
    const int half = int(std::lround(reach / kStep));
    std::vector<double> rises;
    for (int i = -half; i <= half; ++i) {
        const Vec2 at = from + i * kStep * outwards;
        const auto outer = greyAt(picture, at + 0.5 * outwards);
        const auto inner = greyAt(picture, at - 0.5 * outwards);
        if (!outer || !inner)
            return std::nullopt;
        rises.push_back(*outer - *inner);
    }
    const auto peak = std::ranges::max_element(rises);
    if (*peak < kRise)
        return std::nullopt;
    const auto middle = peak - rises.begin();
    const auto first = std::max<std::ptrdiff_t>(middle - 3, 0);
    const auto last = std::min<std::ptrdiff_t>(middle + 3, std::ssize(rises) - 1);
    const auto near = std::min(middle - first, last - middle); // as far to both sides
    if (near == 0)
        return std::nullopt;
    double sum = 0.0;
    double moment = 0.0;
    for (auto i = middle - near; i <= middle + near; ++i) {
        const double rise = std::max(rises[std::size_t(i)], 0.0);
        sum += rise;
        moment += rise * double(i - half);
    }
    return kStep * moment / sum;
}

/// A straight line: points p with normal . p = distance.
struct Line {
    Vec2 normal;
    double distance = 0.0;
};

Line lineThrough(const std::vector<Vec2>& points)
{
    Vec2 mean = Vec2::Zero();
    for (const Vec2& point : points)
        mean += point / double(points.size());
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    for (const Vec2& point : points)
        spread += (point - mean) * (point - mean).transpose();
    const Vec2 normal =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>{spread}.eigenvectors().col(0);
    return {normal, normal.dot(mean)};
}

std::optional<Line> edgeBetween(const GreyPicture& picture, const Vec2& a, const Vec2& b,
                                const Vec2& middle, int cells)
{
    const double length = (b - a).norm();
    if (length < 4.0)
        return std::nullopt;
    const Vec2 along = (b - a) / length;
    Vec2 outwards{along.y(), -along.x()};
    if (outwards.dot(0.5 * (a + b) - middle) < 0.0)
        outwards = -outwards;
    const double reach = std::clamp(0.7 * length / cells, kShortestReach, kLongestReach);
    std::vector<Vec2> places;
    const int samples = std::clamp(int(length), 8, 64);
    for (int i = 0; i < samples; ++i) {
        const double share = kEnd + (1.0 - 2.0 * kEnd) * (i + 0.5) / samples;
        const Vec2 from = a + share * (b - a);
        if (const auto rise = riseAlong(picture, from, outwards, reach))
            places.push_back(from + *rise * outwards);
    }
    if (places.size() < kFewest)
        return std::nullopt;
    for (const double limit : {3.0 * kOutlier, kOutlier}) {
        const Line line = lineThrough(places);
        std::erase_if(places, [&](const Vec2& place) {
            return std::abs(line.normal.dot(place) - line.distance) > limit;
        });
        if (places.size() < kFewest)
            return std::nullopt;
    }
    return lineThrough(places);
}

std::optional<Vec2> crossing(const Line& a, const Line& b)
{
    Eigen::Matrix2d normals;
    normals << a.normal.transpose(), b.normal.transpose();
    if (std::abs(normals.determinant()) < 0.05)
        return std::nullopt;
    return normals.inverse() * Vec2{a.distance, b.distance};
}

} // namespace

std::array<Vec2, 4> refinedCorners(const GreyPicture& picture, const std::array<Vec2, 4>& corners,
                                   int cells)
{
    const Vec2 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
    std::array<Vec2, 4> refined = corners;
    // Twice, because the first lines lie across the edges better than the found corners do.
    for (int round = 0; round < 2; ++round) {
        std::array<std::optional<Line>, 4> edges; // from a corner to the next
        for (std::size_t i = 0; i < 4; ++i)
            edges[i] = edgeBetween(picture, refined[i], refined[(i + 1) % 4], middle, cells);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& before = edges[(i + 3) % 4];
            if (!before || !edges[i])
                continue;
            const auto meets = crossing(*before, *edges[i]);
            if (meets && (*meets - corners[i]).norm() <= kFarthest)
                refined[i] = *meets;
        }
    }
    return refined;
}

} // namespace carina
