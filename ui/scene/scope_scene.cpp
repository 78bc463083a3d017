#include "ui/scene/scope_scene.h"

#include "ui/scene/scene_parts.h"
#include "widgets/scene/figures/figure_shapes.h"

#include <cmath>
#include <memory>

namespace carina
{
namespace
{

constexpr QColor kSteel{160, 166, 172};
constexpr QColor kHandleSteel{120, 126, 134};

constexpr QColor kDarkness{6, 3, 3};
/// As far from the eye as the larynx is when the blade lies in the vallecula.
constexpr Length kTrueColorAt = millimetres(40.0);
constexpr Length kTrueColorAtDirect = millimetres(400.0);

ScenePart scopePart(const char* name, FigureShapes::Mesh mesh, const QColor& color,
                    const char* body = kScopeBody)
{
    return {.name = name,
            .group = MaterialGroup::Tool,
            .color = color,
            .listedUnder = BodyRegion::Tools,
            .body = body,
            .framed = false,
            .levels = {std::move(mesh)}};
}

ScenePart contentPart(AirwayEventKind kind, ContentPlace place)
{
    const bool isSolid = kind == AirwayEventKind::ForeignBody;
    TriangleMesh mesh = isSolid                            ? foreignBodyMesh()
                        : place == ContentPlace::Vallecula ? valleculaPoolMesh()
                                                           : fluidMesh();
    const std::string body = bodyOfContent(kind, place);
    ScenePart part = scopePart(body.c_str(), std::make_shared<const TriangleMesh>(std::move(mesh)),
                               colorOfContent(kind), body.c_str());
    part.group = materialOfContent(kind);
    return part;
}

} // namespace

ScopeScene scopeScene(const PatientModel& patient, const Blade& blade, TissueColors& colors)
{
    ScopeScene scene{.parts = sceneParts(patient), .looks = {}, .structures = {}};
    scene.structures.resize(scene.parts.size() + 1, SeenStructure::Nothing);
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        ScenePart& part = scene.parts[i];
        if (part.body == kTubeBody || part.body == kCuffBody) {
            scene.structures[part.id] = SeenStructure::Tube;
            continue;
        }
        const SeenStructure structure = structureOf(patient.surfaces()[i].description);
        scene.structures[part.id] = structure;
        scene.looks[part.id].style =
            structure == SeenStructure::Nothing ? PartStyle::Hidden : PartStyle::Solid;
    }
    colors.color(scene.parts, scene.structures, patient.landmarks(), patient.contentHash());
    for (ScenePart part :
         {scopePart("Blade", std::make_shared<const TriangleMesh>(bladeMesh(blade.form)), kSteel),
          scopePart("Handle", figureShapes().handle, kHandleSteel)}) {
        part.id = static_cast<std::uint16_t>(scene.structures.size());
        scene.parts.push_back(std::move(part));
        scene.structures.push_back(SeenStructure::Blade);
    }
    const auto addContent = [&scene](AirwayEventKind kind, ContentPlace place) {
        ScenePart part = contentPart(kind, place);
        part.id = static_cast<std::uint16_t>(scene.structures.size());
        scene.parts.push_back(std::move(part));
        scene.structures.push_back(kind == AirwayEventKind::ForeignBody ? SeenStructure::ForeignBody
                                                                        : SeenStructure::Fluid);
    };
    for (const AirwayEventKind kind : kThroatContents)
        addContent(kind, ContentPlace::Throat);
    for (const AirwayEventKind kind : kThroatFluids)
        addContent(kind, ContentPlace::Vallecula);
    return scene;
}

void showScope(SceneView& view, const ScopeScene& scene, ScopeEye eye)
{
    view.setParts(scene.parts);
    view.setLooks(scene.looks);
    view.setBackground(kDarkness);
    view.setSpotlight(eye == ScopeEye::Direct ? kTrueColorAtDirect : kTrueColorAt);
}

EyePicture scopePicture(const RigidTransform& X_AD, Angle fieldOfView, double widthOverHeight)
{
    const double up = std::tan(0.5 * fieldOfView.si);
    const double right = widthOverHeight * up;
    return {X_AD, {.left = -right, .right = right, .bottom = -up, .top = up}, {}};
}

GlotticView measuredView(const IdPicture& picture, const ScopeScene& scene, const EyePicture& eye,
                         const GlotticLine& line)
{
    StructurePicture seen{.width = picture.width, .height = picture.height};
    seen.pixels.reserve(picture.ids.size());
    for (const auto& id : picture.ids)
        seen.pixels.push_back(id && *id < scene.structures.size() ? scene.structures[*id]
                                                                  : SeenStructure::Nothing);
    return glotticView(seen, {eye.X_AD, eye.frustum.right, eye.frustum.top}, line);
}

} // namespace carina
