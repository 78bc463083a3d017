#include "widgets/scene/look/organ_effects.h"

#include "resources/resources.h"
#include "widgets/scene/look/organ_shader.h"

#include <QMatrix4x4>
#include <QVector3D>
#include <QVector4D>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>

#include <algorithm>
#include <string>

namespace carina
{

namespace
{

/// Within these a program that no pass draws with is compiled. Qt 3D tells its status too late.
constexpr int kFramesToCompile = 2;

Qt3DRender::QShaderProgram* program(const OrganShader& needs, const char* fragmentShader,
                                    Qt3DCore::QNode* parent)
{
    auto* made = new Qt3DRender::QShaderProgram(parent);
    made->setVertexShaderCode(organVertexShader(needs));
    made->setFragmentShaderCode(resource(fragmentShader));
    return made;
}

Qt3DRender::QRenderPass* pass(const char* key, std::size_t layer)
{
    auto* filter = new Qt3DRender::QFilterKey;
    filter->setName(QString::fromLatin1(key));
    filter->setValue(static_cast<int>(layer));
    auto* made = new Qt3DRender::QRenderPass;
    made->addFilterKey(filter);
    return made;
}

Qt3DRender::QTechnique* openGlTechnique()
{
    auto* technique = new Qt3DRender::QTechnique;
    Qt3DRender::QGraphicsApiFilter* api = technique->graphicsApiFilter();
    api->setApi(Qt3DRender::QGraphicsApiFilter::OpenGL);
    api->setProfile(Qt3DRender::QGraphicsApiFilter::CoreProfile);
    api->setMajorVersion(3);
    api->setMinorVersion(1);
    return technique;
}

Qt3DRender::QParameter* uniform(const char* name, const QVariant& value, Qt3DCore::QNode* parent)
{
    auto* made = new Qt3DRender::QParameter(QString::fromLatin1(name), value);
    made->setParent(parent);
    return made;
}

/// The squared error in squared widths of a band.
QMatrix4x4 quadricUniform(const ErrorMap& map)
{
    QMatrix4x4 quadric;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            quadric(row, column) = static_cast<float>(map.quadric_A(row, column)
                                                      / (map.bands.width.si * map.bands.width.si));
    return quadric;
}

QVector3D light(const QColor& color) { return {color.redF(), color.greenF(), color.blueF()}; }

/// Bands beyond the last one get its colours.
void setColors(const ErrorUniforms& uniforms, int count)
{
    for (int band = 0; band < kMostErrorBands; ++band) {
        const int drawn = std::min(band, count - 1);
        const ErrorUniforms::Band& set = uniforms.bands[static_cast<std::size_t>(band)];
        set.color->setValue(light(bandColor(drawn, count)));
        set.line->setValue(light(isolineColor(drawn, count)));
    }
}

ErrorUniforms errorUniforms(Qt3DCore::QNode* parent)
{
    ErrorUniforms made{uniform("errorQuadric", QMatrix4x4{}, parent),
                       uniform("firstBand", 0.0F, parent),
                       uniform("bandCount", 1.0F, parent),
                       {}};
    for (std::size_t band = 0; band < made.bands.size(); ++band) {
        const std::string name = "bands[" + std::to_string(band) + "].";
        made.bands[band] = {uniform((name + "color").c_str(), QVector3D{}, parent),
                            uniform((name + "line").c_str(), QVector3D{}, parent)};
    }
    setColors(made, 1);
    return made;
}

} // namespace

OrganEffects::OrganEffects(Qt3DCore::QNode* parent)
    : m_cut{uniform("section", QVector4D{}, parent), uniform("cutAway", 0.0F, parent)},
      m_error{errorUniforms(parent)},
      m_spot{uniform("spot", QVector4D{}, parent)}
{
    for (std::size_t index = 0; index < m_layers.size(); ++index) {
        const std::size_t place = index % kDrawLayers;
        const bool many = static_cast<DrawLayer>(place) == DrawLayer::Blended; // SurfaceKey
        Layer& layer = m_layers[index];
        layer = {new Qt3DRender::QEffect(parent),
                 {pass(kSurfacePass, place), pass(kComingPass, place)},
                 {pass(kIdPass, place), pass(kComingPass, place)},
                 many,
                 index >= kDrawLayers};
        Qt3DRender::QTechnique* technique = openGlTechnique();
        for (Qt3DRender::QRenderPass* each :
             {layer.surface.drawn, layer.surface.coming, layer.id.drawn, layer.id.coming})
            technique->addRenderPass(each);
        layer.effect->addTechnique(technique);
        for (Qt3DRender::QParameter* parameter : parameters())
            layer.effect->addParameter(parameter);
    }
    askForPrograms();
    usePrograms(); // nothing is drawn yet that could be left out
}

std::vector<Qt3DRender::QParameter*> OrganEffects::parameters() const
{
    std::vector all{m_cut.section,     m_cut.cutAway,     m_error.quadric,
                    m_error.firstBand, m_error.bandCount, m_spot};
    for (const ErrorUniforms::Band& band : m_error.bands)
        all.insert(all.end(), {band.color, band.line});
    return all;
}

Qt3DRender::QEffect* OrganEffects::of(DrawLayer layer, std::optional<ChestRegion> region) const
{
    const bool isInThroat = !region || airwayTissueOf(*region);
    const auto place = static_cast<std::size_t>(layer);
    return m_layers[isInThroat ? kDrawLayers + place : place].effect;
}

/// Programs are made when they are first asked for, since Qt 3D passes over those that no pass has
/// and does not look again, and kept.
Qt3DRender::QShaderProgram* OrganEffects::programOf(Layer& layer, const OrganShader& needs,
                                                    const char* fragmentShader)
{
    Qt3DRender::QShaderProgram*& made = layer.programs[{needs, fragmentShader}];
    if (made == nullptr)
        made = program(needs, fragmentShader, layer.effect);
    return made;
}

const char* OrganEffects::surfaceShader() const
{
    if (m_isMapped)
        return "shaders/error_map.frag";
    return m_needs.isSpotlit && m_needs.isMoist ? "shaders/moist.frag" : "shaders/organ.frag";
}

void OrganEffects::askForPrograms()
{
    for (Layer& layer : m_layers) {
        OrganShader needs = m_needs;
        needs.hasManyRegions = layer.hasManyRegions;
        needs.isMoist = needs.isMoist && needs.isSpotlit;
        if (!layer.isInThroat && !needs.isSpotlit) // a blade shades whatever is near
            needs.movesJaw = needs.pushesTissue = needs.changesAirway = false;
        layer.surface.coming->setShaderProgram(programOf(layer, needs, surfaceShader()));
        needs.isSpotlit = false; // ids have no light
        needs.isMoist = false;
        layer.id.coming->setShaderProgram(programOf(layer, needs, "shaders/id.frag"));
    }
    m_framesToCome = kFramesToCompile;
}

void OrganEffects::usePrograms()
{
    for (const Layer& layer : m_layers)
        for (const Pass& pass : {layer.surface, layer.id})
            pass.drawn->setShaderProgram(pass.coming->shaderProgram());
    m_framesToCome = 0;
}

void OrganEffects::countFrame()
{
    if (m_framesToCome > 0 && --m_framesToCome == 0)
        usePrograms();
}

void OrganEffects::letJawMove()
{
    if (m_needs.movesJaw)
        return;
    m_needs.movesJaw = true;
    askForPrograms();
}

void OrganEffects::letBladePush()
{
    if (m_needs.pushesTissue)
        return;
    m_needs.movesJaw = true;
    m_needs.pushesTissue = true;
    askForPrograms();
}

void OrganEffects::letAirwayChange()
{
    if (m_needs.changesAirway)
        return;
    m_needs.changesAirway = true;
    askForPrograms();
}

void OrganEffects::letNeckBend()
{
    if (m_needs.bendsNeck)
        return;
    m_needs.bendsNeck = true;
    askForPrograms();
}

void OrganEffects::setSpotlight(const std::optional<Spotlight>& lamp)
{
    if (lamp.has_value() != m_needs.isSpotlit) {
        m_needs.isSpotlit = lamp.has_value();
        askForPrograms();
    }
    if (!lamp)
        return;
    const Vec3f dir = lamp->dir_A.cast<float>();
    m_spot->setValue(
        QVector4D{dir.x(), dir.y(), dir.z(), static_cast<float>(lamp->trueColorAt.si)});
}

void OrganEffects::setLook(SurfaceLook look)
{
    const bool isMoist = look == SurfaceLook::Moist;
    if (isMoist == m_needs.isMoist)
        return;
    m_needs.isMoist = isMoist;
    if (m_needs.isSpotlit)
        askForPrograms();
}

void OrganEffects::setErrorMap(const std::optional<ErrorMap>& map)
{
    if (map.has_value() != m_isMapped) {
        m_isMapped = map.has_value();
        askForPrograms();
    }
    if (!map)
        return;
    const ErrorBands& bands = map->bands;
    m_error.quadric->setValue(quadricUniform(*map));
    m_error.firstBand->setValue(static_cast<float>(bands.first));
    m_error.bandCount->setValue(static_cast<float>(bands.count));
    setColors(m_error, bands.count);
}

} // namespace carina
