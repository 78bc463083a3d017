#include "ui/scene/throat_contents.h"

#include "ui/scene/scene_parts.h"
#include "widgets/scene/figures/figure_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace carina
{
namespace
{

/// Between those of people and of what is lifted out.
constexpr std::uint16_t kFirstContentId = 0xe000;

/// By kThroatContents, of ours: saliva, blood, vomit, a morsel of meat.
constexpr std::array<QColor, kThroatContents.size()> kContentColors{
    {{214, 206, 160}, {128, 10, 12}, {158, 130, 58}, {140, 92, 58}}};

TriangleMesh meshOfContent(const DrawnContent& content)
{
    if (content.kind == AirwayEventKind::ForeignBody)
        return foreignBodyMesh();
    if (content.place == ContentPlace::Vallecula)
        return valleculaPoolMesh();
    return poolMesh(std::max(1, content.depthSteps) * kDepthStep);
}

} // namespace

std::string bodyOfContent(AirwayEventKind kind, ContentPlace place)
{
    const std::string name = eventName(kind);
    return place == ContentPlace::Vallecula ? name + " in the vallecula" : name;
}

QColor colorOfContent(AirwayEventKind kind)
{
    const auto* found = std::ranges::find(kThroatContents, kind);
    return kContentColors.at(std::size_t(found - kThroatContents.begin()));
}

MaterialGroup materialOfContent(AirwayEventKind kind)
{
    return kind == AirwayEventKind::ForeignBody ? MaterialGroup::Tool : MaterialGroup::Fluid;
}

TriangleMesh foreignBodyMesh()
{
    constexpr double kMorsel = 2.5;
    const double half = 0.5 * kForeignBody.si;
    return superellipsoid(Vec3::Zero(), {half, 0.85 * half, half}, kMorsel);
}

void addContents(SceneFrame& frame, const std::vector<ThroatContent>& contents)
{
    const auto patient = frame.bodies.find(kPatientBody);
    if (patient == frame.bodies.end())
        return;
    const PlacedBody motion = patient->second;
    for (const ThroatContent& content : contents)
        frame.bodies[bodyOfContent(content.kind, content.place)] =
            motion * PlacedBody{RigidTransform::translation(content.p_AF), content.size};
}

std::vector<DrawnContent> drawnContents(const std::vector<ThroatContent>& contents)
{
    std::vector<DrawnContent> drawn;
    for (const ThroatContent& content : contents)
        drawn.push_back({content.kind, content.place,
                         static_cast<int>(std::lround(content.depth / kDepthStep))});
    return drawn;
}

std::vector<SceneFigure> contentFigures(const std::vector<DrawnContent>& contents)
{
    std::vector<SceneFigure> figures;
    std::uint16_t nextId = kFirstContentId;
    for (const DrawnContent& content : contents) {
        const std::string body = bodyOfContent(content.kind, content.place);
        SceneFigure figure{.body = body, .name = {}};
        figure.parts.push_back(
            {.name = body,
             .id = nextId++,
             .group = materialOfContent(content.kind),
             .color = colorOfContent(content.kind),
             .listedUnder = BodyRegion::Airway,
             .body = body,
             .framed = false,
             .levels = {std::make_shared<const TriangleMesh>(meshOfContent(content))}});
        figures.push_back(std::move(figure));
    }
    return figures;
}

} // namespace carina
