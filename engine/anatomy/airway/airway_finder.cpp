#include "engine/anatomy/airway/airway_path.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string>
#include <string_view>

namespace carina
{

namespace
{

constexpr double kSliceSpacing = 2e-3;
constexpr double kShortestTrachea = 20e-3;

std::string inSmallLetters(std::string name)
{
    std::transform(name.begin(), name.end(), name.begin(),
                   [](unsigned char c) { return char(std::tolower(c)); });
    return name;
}

bool holds(const AnatomyPart& part, std::string_view words)
{
    return inSmallLetters(part.name).find(words) != std::string::npos;
}

const TriangleMesh* finestOf(std::span<const AnatomyPart> parts, PartRole role)
{
    for (const AnatomyPart& part : parts) {
        if (part.role == role && !part.levels.empty() && !part.levels.front().empty())
            return &part.levels.front();
    }
    return nullptr;
}

/// Outline of a surface where it crosses the plane at height z: the ends of its pieces, in pairs.
std::vector<Vec3> sliceAt(const TriangleMesh& mesh, double z)
{
    std::vector<Vec3> ends;
    for (const Triangle& t : mesh.triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 a = mesh.positions[t[k]].cast<double>();
            const Vec3 b = mesh.positions[t[(k + 1) % 3]].cast<double>();
            if ((a.z() < z) != (b.z() < z))
                ends.emplace_back(a + (z - a.z()) / (b.z() - a.z()) * (b - a));
        }
    }
    return ends;
}

/// Mean of the outline, each piece counted by its length.
std::optional<Vec3> middleOfSlice(const TriangleMesh& mesh, double z)
{
    const std::vector<Vec3> ends = sliceAt(mesh, z);
    Vec3 moment = Vec3::Zero();
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2) {
        const double piece = (ends[i + 1] - ends[i]).norm();
        moment += 0.5 * piece * (ends[i] + ends[i + 1]);
        length += piece;
    }
    if (!(length > 0.0))
        return std::nullopt;
    return moment / length;
}

/// The carina between the main bronchi, see findAirway.
std::optional<Vec3> betweenBronchi(const TriangleMesh& right, const TriangleMesh& left)
{
    constexpr double kStep = 0.5e-3;
    constexpr double kAsNear = 0.5e-3;
    const auto byX = [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); };
    const Box boxes[] = {boundsOf(right), boundsOf(left)};
    const double bottom = std::max(boxes[0].min.z(), boxes[1].min.z());
    const double top = std::min(boxes[0].max.z(), boxes[1].max.z());
    std::optional<Vec3> carina;
    double narrowest = 0.0;
    for (double z = top - kStep; z > bottom; z -= kStep) {
        const std::vector<Vec3> r = sliceAt(right, z);
        const std::vector<Vec3> l = sliceAt(left, z);
        if (r.empty() || l.empty())
            continue;
        const Vec3 inner[] = {*std::max_element(r.begin(), r.end(), byX),
                              *std::min_element(l.begin(), l.end(), byX)};
        const double gap = std::max(inner[1].x() - inner[0].x(), 0.0);
        if (!carina || gap < narrowest + kAsNear) {
            narrowest = carina ? std::min(narrowest, gap) : gap;
            carina = 0.5 * (inner[0] + inner[1]);
        }
    }
    return carina;
}

/// Centres of the trachea's sections from its top down to the carina, which ends the line.
Centreline alongTrachea(const TriangleMesh& trachea, const Vec3& carina)
{
    const Box box = boundsOf(trachea);
    Centreline raw;
    for (double z = box.max.z() - kSliceSpacing; z > carina.z() + 2.0 * kSliceSpacing;
         z -= kSliceSpacing) {
        if (const auto middle = middleOfSlice(trachea, z))
            raw.push_back(*middle);
    }
    raw.push_back(carina);
    // The plane cuts the open end of a leaning trachea askew: its first centres are off the axis.
    constexpr std::size_t kAskew = 4;
    if (raw.size() > 3 * kAskew)
        raw.erase(raw.begin(), raw.begin() + kAskew);
    constexpr std::size_t kReach = 5;
    Centreline smooth;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        const std::size_t reach = std::min({kReach, i, raw.size() - 1 - i});
        Vec3 sum = Vec3::Zero();
        for (std::size_t k = i - reach; k <= i + reach; ++k)
            sum += raw[k];
        smooth.emplace_back(sum / double(2 * reach + 1));
    }
    return smooth;
}

std::optional<Vec3> middleOfCords(std::span<const AnatomyPart> parts)
{
    Box box;
    for (const AnatomyPart& part : parts) {
        if (holds(part, "vocal ligament") && !part.levels.empty())
            box.include(boundsOf(part.levels.front()));
    }
    if (box.empty())
        return std::nullopt;
    return box.centre();
}

/// Mean of the vertices of a tooth within a millimetre of its lowest.
std::optional<Vec3> lowerEdge(const TriangleMesh& tooth)
{
    const double lowest = boundsOf(tooth).min.z();
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const Vec3f& p : tooth.positions) {
        if (p.z() < lowest + 1e-3) {
            sum += p.cast<double>();
            ++count;
        }
    }
    if (count == 0)
        return std::nullopt;
    return sum / count;
}

std::optional<Vec3> edgeOfUpperIncisors(std::span<const AnatomyPart> parts)
{
    Box edges;
    for (const AnatomyPart& part : parts) {
        if (part.role != PartRole::Tooth || part.levels.empty() || !holds(part, "upper central")
            || !holds(part, "incisor"))
            continue;
        if (const auto edge = lowerEdge(part.levels.front()))
            edges.include(*edge);
    }
    if (edges.empty())
        return std::nullopt;
    return edges.centre();
}

/// Above the front rim of the lower jaw.
Vec3 aboveMandible(const TriangleMesh& mandible)
{
    constexpr double kFrontDepth = 12e-3;
    constexpr double kAside = 10e-3;
    const Box whole = boundsOf(mandible);
    Box rim;
    for (const Vec3f& p : mandible.positions) {
        if (p.y() < whole.min.y() + kFrontDepth && std::abs(p.x() - whole.centre().x()) < kAside)
            rim.include(p.cast<double>());
    }
    if (rim.empty())
        rim = whole;
    return {whole.centre().x(), rim.min.y() - 10e-3, rim.max.z() + 10e-3};
}

Vec3 incisorsOf(std::span<const AnatomyPart> parts, const Centreline& down, Length trachea)
{
    if (const auto edge = edgeOfUpperIncisors(parts))
        return *edge;
    if (const TriangleMesh* mandible = finestOf(parts, PartRole::Mandible))
        return aboveMandible(*mandible);
    return incisorsAtLength(down, (13.5 / 10.1) * trachea);
}

Vec3 carinaOf(std::span<const AnatomyPart> parts, const TriangleMesh& trachea)
{
    const TriangleMesh* right = finestOf(parts, PartRole::RightMainBronchus);
    const TriangleMesh* left = finestOf(parts, PartRole::LeftMainBronchus);
    if (right != nullptr && left != nullptr) {
        if (const auto carina = betweenBronchi(*right, *left))
            return *carina;
    }
    const auto lowest =
        std::min_element(trachea.positions.begin(), trachea.positions.end(),
                         [](const Vec3f& a, const Vec3f& b) { return a.z() < b.z(); });
    return lowest->cast<double>();
}

} // namespace

Result<AirwayLandmarks> findAirway(std::span<const AnatomyPart> parts)
{
    const TriangleMesh* trachea = finestOf(parts, PartRole::Trachea);
    if (trachea == nullptr)
        return fail(Errc::NoAirway);
    AirwayLandmarks found;
    found.p_A_carina = carinaOf(parts, *trachea);
    const Box box = boundsOf(*trachea);
    if (box.max.z() - found.p_A_carina.z() < kShortestTrachea)
        return fail(Errc::NoAirway, "the trachea is too short");

    Centreline down = alongTrachea(*trachea, found.p_A_carina);
    const Vec3 up = (down.front() - pointAlong(down, 0.4 * lengthOf(down))).normalized();
    const double toTop = (box.max.z() - down.front().z()) / up.z();
    const double length = lengthOf(down).si + toTop;
    found.p_A_glottis =
        middleOfCords(parts).value_or(down.front() + (toTop + 26.0 / 101.0 * length) * up);
    down.insert(down.begin(), found.p_A_glottis);
    found.p_A_incisors = incisorsOf(parts, down, metres(length));
    found.path_A = airwayPath(found.p_A_incisors, down);
    return found;
}

} // namespace carina
