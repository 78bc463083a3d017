#include "widgets/scene/look/scope_colors.h"

#include "widgets/scene/look/near_tissue.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace carina
{
namespace
{

/// By SeenStructure, in the light of a laryngoscope: mucosa in pinks, paler where it lies over
/// cartilage; an epiglottis a little yellow, as its cartilage shows through; cords like pearl. The
/// jaw is drawn like gums. Of ours, after photographs in textbooks.
constexpr std::array<QColor, kSeenStructures> kColors{{{0, 0, 0},
                                                       {238, 231, 212},
                                                       {200, 118, 118},
                                                       {204, 118, 120},
                                                       {218, 150, 142},
                                                       {212, 124, 118},
                                                       {194, 92, 88},
                                                       {224, 150, 138},
                                                       {214, 126, 116},
                                                       {206, 108, 102},
                                                       {222, 138, 126},
                                                       {246, 240, 230},
                                                       {186, 88, 84},
                                                       {164, 76, 72},
                                                       {164, 74, 72}}};
constexpr QColor kRing{218, 170, 158}; ///< of cartilage, through its mucosa

using Color = Eigen::Array3f; ///< sRGB, 0 to 255

/// Of a place that is wholly hidden: its share of each channel.
const Color kHidden{0.42F, 0.26F, 0.26F};

/// Cartilages of a trachea, from the cords to the carina if they went on: 16 to 20 of the trachea
/// itself in textbooks of anatomy.
constexpr double kRings = 21.0;

Color asColor(const Rgb& color) { return {float(color[0]), float(color[1]), float(color[2])}; }

Color asColor(const QColor& color)
{
    return asColor(Rgb{static_cast<std::uint8_t>(color.red()),
                       static_cast<std::uint8_t>(color.green()),
                       static_cast<std::uint8_t>(color.blue())});
}

Rgb asRgb(const Color& color)
{
    const auto channel = [&color](int i) {
        return static_cast<std::uint8_t>(std::lround(std::clamp(color[i], 0.0F, 255.0F)));
    };
    return {channel(0), channel(1), channel(2)};
}

/// From 0 at `from` to 1 at `to`, without edges.
double eased(double from, double to, double x)
{
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

bool isTissue(SeenStructure structure)
{
    return structure >= SeenStructure::Jaw && structure <= SeenStructure::Oesophagus;
}

/// Lies between tongue and trachea, where parts of one region move together.
bool hasHollows(ChestRegion region)
{
    return region == ChestRegion::Throat || region == ChestRegion::Pharynx
           || region == ChestRegion::Larynx;
}

/// How much of the wall of a trachea is a ring at a place, by the normal into its lumen: none at
/// the back.
class TrachealRings
{
public:
    explicit TrachealRings(const AirwayLandmarks& landmarks)
        : m_p_A_glottis{landmarks.p_A_glottis},
          m_along_A{(landmarks.p_A_carina - landmarks.p_A_glottis).normalized()},
          m_spacing{(landmarks.p_A_carina - landmarks.p_A_glottis).norm() / kRings}
    {
    }

    [[nodiscard]] float shareAt(const Vec3f& p_A, const Vec3f& normal_A) const
    {
        const double along = m_along_A.dot(p_A.cast<double>() - m_p_A_glottis);
        const double wave = std::cos(2.0 * std::numbers::pi * along / m_spacing);
        const double before = eased(-0.9, -0.4, static_cast<double>(normal_A.y()));
        return static_cast<float>(before * eased(-0.5, 0.6, wave));
    }

private:
    Vec3 m_p_A_glottis;
    Vec3 m_along_A;
    double m_spacing; ///< metres
};

using Together = std::pair<std::string, ChestRegion>; ///< body and region

bool isShaded(const ScenePart& part, std::span<const SeenStructure> structures)
{
    return isTissue(structures[part.id]) && hasHollows(part.region);
}

std::map<Together, NearTissue> hollowsOf(std::span<const ScenePart> parts,
                                         std::span<const SeenStructure> structures)
{
    std::map<Together, std::vector<const TriangleMesh*>> meshes;
    for (const ScenePart& part : parts)
        if (isShaded(part, structures))
            meshes[{part.body, part.region}].push_back(part.levels.front().get());
    std::map<Together, NearTissue> tissue;
    for (const auto& [together, all] : meshes)
        tissue.emplace(together, NearTissue{all});
    return tissue;
}

/// Colours the vertices of one part.
class TissuePaint
{
public:
    /// @param near what can hide its tissue; none: nothing does
    /// @param rings of a trachea; none: it is none
    TissuePaint(const QColor& own, const NearTissue* near, const TrachealRings* rings)
        : m_own{asColor(own)}, m_near{near}, m_rings{rings}
    {
    }

    /// @param textured the colours that a set gives the vertices; may be empty
    [[nodiscard]] std::vector<Rgb> colorsOf(const TriangleMesh& mesh,
                                            std::span<const Rgb> textured) const
    {
        std::vector<Rgb> colors;
        colors.reserve(mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            colors.push_back(asRgb(shaded(textured.empty() ? m_own : asColor(textured[i]),
                                          mesh.positions[i], mesh.normals[i])));
        return colors;
    }

private:
    [[nodiscard]] Color shaded(Color color, const Vec3f& p, const Vec3f& normal) const
    {
        if (m_rings != nullptr)
            color += m_rings->shareAt(p, normal) * (asColor(kRing) - color);
        if (m_near != nullptr)
            color *= 1.0F - m_near->hiddenAt(p, normal) * (1.0F - kHidden);
        return color;
    }

    Color m_own;
    const NearTissue* m_near;
    const TrachealRings* m_rings;
};

} // namespace

bool isColored(SeenStructure structure)
{
    return isTissue(structure) || structure == SeenStructure::Teeth;
}

void colorTissue(std::span<ScenePart> parts, std::span<const SeenStructure> structures,
                 const AirwayLandmarks& landmarks)
{
    const std::map<Together, NearTissue> hollows = hollowsOf(parts, structures);
    const TrachealRings rings{landmarks};
    for (ScenePart& part : parts) {
        const SeenStructure structure = structures[part.id];
        if (!isColored(structure))
            continue;
        part.color = kColors.at(std::size_t(structure));
        const TissuePaint paint{part.color,
                                isShaded(part, structures) ? &hollows.at({part.body, part.region})
                                                           : nullptr,
                                structure == SeenStructure::Trachea ? &rings : nullptr};
        const std::vector<std::vector<Rgb>> textured = std::exchange(part.colors, {});
        for (std::size_t level = 0; level < part.levels.size(); ++level)
            part.colors.push_back(
                paint.colorsOf(*part.levels[level], textured.empty() ? std::span<const Rgb>{}
                                                                     : std::span{textured[level]}));
    }
}

} // namespace carina
