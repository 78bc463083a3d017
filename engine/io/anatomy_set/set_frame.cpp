#include "engine/io/anatomy_set/set_frame.h"

#include "engine/anatomy/role_recognition.h"
#include "engine/io/mesh/surface_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace carina
{
namespace
{

constexpr std::array kMetresPerUnit{1.0, 1e-2, 1e-3};
/// The depth that tells front from back, as a share of the size of the set.
constexpr double kClearDepth = 0.01;

struct SizeRange {
    double shortest; ///< metres, the longest side of a box
    double longest;
};

/// Each range spans less than a factor ten, so that no two units fit.
constexpr SizeRange kTracheaSize{0.03, 0.25};
constexpr SizeRange kLungSize{0.04, 0.4};
constexpr SizeRange kMandibleSize{0.04, 0.2};
constexpr SizeRange kWholeSize{0.2, 2.0};
constexpr double kLargestScene = 10.0; ///< of glTF without evidence, metres

std::optional<double> unitFor(double size, SizeRange range)
{
    for (const double unit : kMetresPerUnit)
        if (size * unit >= range.shortest && size * unit < range.longest)
            return unit;
    return std::nullopt;
}

/// The longest side of the largest part that `belongs`; 0 without one.
template <class Belongs>
double largestSize(std::span<const RecognisedSurface> surfaces, const Belongs& belongs)
{
    double size = 0.0;
    for (const RecognisedSurface& s : surfaces)
        if (belongs(s.role))
            size = std::max(size, boundsOf(s.mesh).size().maxCoeff());
    return size;
}

double sizeOfWhole(std::span<const RecognisedSurface> surfaces)
{
    Box box;
    for (const RecognisedSurface& s : surfaces)
        box.include(boundsOf(s.mesh));
    return box.empty() ? 0.0 : box.size().maxCoeff();
}

bool isGltf(std::span<const RecognisedSurface> surfaces)
{
    return std::ranges::all_of(surfaces, [](const RecognisedSurface& surface) {
        const auto format = surfaceFormat(surface.file);
        return format == SurfaceFormat::Gltf || format == SurfaceFormat::Glb;
    });
}

std::optional<double> findUnit(std::span<const RecognisedSurface> surfaces)
{
    const auto is = [](PartRole wanted) { return [wanted](PartRole r) { return r == wanted; }; };
    const auto inLung = [](PartRole r) { return lungSide(r).has_value(); };
    if (const auto unit = unitFor(largestSize(surfaces, is(PartRole::Trachea)), kTracheaSize))
        return unit;
    if (const auto unit = unitFor(largestSize(surfaces, inLung), kLungSize))
        return unit;
    if (const auto unit = unitFor(largestSize(surfaces, is(PartRole::Mandible)), kMandibleSize))
        return unit;
    const double whole = sizeOfWhole(surfaces);
    if (const auto unit = unitFor(whole, kWholeSize))
        return unit;
    if (isGltf(surfaces) && whole > 0.0 && whole < kLargestScene)
        return 1.0;
    return std::nullopt;
}

/// The mean of the middles of the boxes of some parts.
class MeanPlace
{
public:
    void include(const Vec3& place)
    {
        m_sum += place;
        ++m_count;
    }
    /// The way from `other` to here, where both have parts.
    [[nodiscard]] std::optional<Vec3> from(const MeanPlace& other) const
    {
        if (m_count == 0 || other.m_count == 0)
            return std::nullopt;
        return m_sum / m_count - other.m_sum / other.m_count;
    }

private:
    Vec3 m_sum = Vec3::Zero();
    int m_count = 0;
};

/// Places of the parts that tell directions, in F.
struct Evidence {
    MeanPlace head, neck, thorax, left, right, back, front;
};

void gather(Evidence& evidence, PartRole role, const Vec3& place)
{
    switch (role) {
    case PartRole::Mandible:
    case PartRole::Tooth:
    case PartRole::Tongue:
        evidence.front.include(place);
        [[fallthrough]];
    case PartRole::Skull:
        evidence.head.include(place);
        return;
    case PartRole::Trachea:
        evidence.neck.include(place);
        evidence.front.include(place);
        return;
    case PartRole::Heart:
        evidence.front.include(place);
        evidence.thorax.include(place);
        return;
    case PartRole::Spine:
    case PartRole::Oesophagus:
        evidence.back.include(place);
        return;
    default:
        if (lungSide(role) || role == PartRole::Diaphragm || role == PartRole::BronchialTree)
            evidence.thorax.include(place);
    }
}

Evidence evidenceIn(std::span<const RecognisedSurface> surfaces)
{
    Evidence evidence;
    for (const RecognisedSurface& s : surfaces) {
        const Vec3 place = boundsOf(s.mesh).centre();
        gather(evidence, s.role, place);
        const std::optional<Side> lung = lungSide(s.role);
        if (const auto side = lung ? lung : sideFromName(s.name))
            (*side == Side::Left ? evidence.left : evidence.right).include(place);
    }
    return evidence;
}

/// The axis nearest to v among those across `across`.
Vec3 nearestAxis(const Vec3& v, const Vec3& across)
{
    const Vec3 rest = v.cwiseProduct(Vec3::Ones() - across.cwiseAbs());
    int axis = 0;
    const double length = rest.cwiseAbs().maxCoeff(&axis);
    return length == 0.0 ? Vec3::Zero() : Vec3{Vec3::Unit(axis) * std::copysign(1.0, rest[axis])};
}

/// @param defaultUp used where no part tells
Mat3 findAxes(const Evidence& evidence, double size, const Vec3& defaultUp)
{
    auto up = evidence.head.from(evidence.thorax);
    up = up ? up : evidence.neck.from(evidence.thorax);
    up = up ? up : evidence.head.from(evidence.neck);
    const Vec3 s_F = nearestAxis(up.value_or(defaultUp), Vec3::Zero());
    const std::optional<Vec3> back = evidence.back.from(evidence.front);
    const std::optional<Vec3> left = evidence.left.from(evidence.right);
    Vec3 l_F = nearestAxis(left.value_or(Vec3::Zero()), s_F);
    if (l_F.isZero() && back)
        l_F = nearestAxis(*back, s_F).cross(s_F);
    if (l_F.isZero())
        l_F = nearestAxis({1.0, 0.5, 0.0}, s_F);
    Vec3 p_F = s_F.cross(l_F);
    if (back && back->dot(p_F) < -kClearDepth * size)
        p_F = -p_F;
    Mat3 R_AF;
    R_AF << l_F.transpose(), p_F.transpose(), s_F.transpose();
    return R_AF;
}

} // namespace

std::vector<std::string> axisWords(const SetFrame& frame)
{
    constexpr std::array<std::array<const char*, 2>, 3> kWords{
        {{"left", "right"}, {"posterior", "anterior"}, {"superior", "inferior"}}};
    std::vector<std::string> words;
    for (int axis = 0; axis < 3; ++axis) {
        int direction = 0;
        frame.R_AF.col(axis).cwiseAbs().maxCoeff(&direction);
        words.emplace_back(kWords[direction][frame.R_AF(direction, axis) > 0.0 ? 0 : 1]);
    }
    return words;
}

Result<SetFrame> findSetFrame(std::span<const RecognisedSurface> surfaces)
{
    const std::optional<double> unit = findUnit(surfaces);
    if (!unit)
        return fail(Errc::OutOfRange, "no person in metres, centimetres or millimetres: "
                                          + std::to_string(sizeOfWhole(surfaces)) + " units high");
    const Vec3 up = isGltf(surfaces) ? Vec3::UnitY() : Vec3::UnitZ();
    return SetFrame{*unit, findAxes(evidenceIn(surfaces), sizeOfWhole(surfaces), up)};
}

} // namespace carina
