#include "widgets/scene/organ_effects.h"

#include "resources/resources.h"

#include <QMatrix4x4>
#include <QVector4D>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>

#include <algorithm>

namespace carina
{

namespace
{

Qt3DRender::QShaderProgram* program(const char* fragmentShader, Qt3DCore::QNode* parent)
{
    auto* made = new Qt3DRender::QShaderProgram(parent);
    made->setVertexShaderCode(resource("shaders/organ.vert"));
    made->setFragmentShaderCode(resource(fragmentShader));
    return made;
}

Qt3DRender::QRenderPass* pass(const char* key, std::size_t layer,
                              Qt3DRender::QShaderProgram* shaders)
{
    auto* filter = new Qt3DRender::QFilterKey;
    filter->setName(QString::fromLatin1(key));
    filter->setValue(static_cast<int>(layer));
    auto* made = new Qt3DRender::QRenderPass;
    made->addFilterKey(filter);
    made->setShaderProgram(shaders);
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

QVector4D light(const QColor& color) { return {color.redF(), color.greenF(), color.blueF(), 1.0F}; }

/// A matrix for each band that there may be, as error_map.frag reads it.
QVariantList colorUniform(int count)
{
    QVariantList colors;
    for (int band = 0; band < kMostErrorBands; ++band) {
        const int drawn = std::min(band, count - 1);
        QMatrix4x4 columns;
        columns.setColumn(0, light(bandColor(drawn, count)));
        columns.setColumn(1, light(isolineColor(drawn, count)));
        colors.push_back(columns);
    }
    return colors;
}

ErrorUniforms errorUniforms(Qt3DCore::QNode* parent)
{
    return {uniform("errorQuadric", QMatrix4x4{}, parent), uniform("firstBand", 0.0F, parent),
            uniform("bandCount", 1.0F, parent),
            uniform("bandColors[0]", colorUniform(1), parent)}; // as OpenGL names an array
}

} // namespace

OrganEffects makeOrganEffects(Qt3DCore::QNode* parent)
{
    Qt3DRender::QShaderProgram* id = program("shaders/id.frag", parent);
    OrganEffects effects;
    effects.lit = program("shaders/organ.frag", parent);
    effects.mapped = program("shaders/error_map.frag", parent);
    effects.cut = {uniform("section", QVector4D{}, parent), uniform("cutAway", 0.0F, parent)};
    effects.error = errorUniforms(parent);
    for (std::size_t layer = 0; layer < kDrawLayers; ++layer) {
        auto* effect = new Qt3DRender::QEffect(parent);
        Qt3DRender::QTechnique* technique = openGlTechnique();
        effects.surface[layer] = pass(kSurfacePass, layer, effects.lit);
        technique->addRenderPass(effects.surface[layer]);
        technique->addRenderPass(pass(kIdPass, layer, id));
        effect->addTechnique(technique);
        for (Qt3DRender::QParameter* parameter :
             {effects.cut.section, effects.cut.cutAway, effects.error.quadric,
              effects.error.firstBand, effects.error.bandCount, effects.error.bandColors})
            effect->addParameter(parameter);
        effects.of[layer] = effect;
    }
    return effects;
}

void setErrorMap(const OrganEffects& effects, const std::optional<ErrorMap>& map)
{
    for (Qt3DRender::QRenderPass* surface : effects.surface)
        surface->setShaderProgram(map ? effects.mapped : effects.lit);
    if (!map)
        return;
    const ErrorBands& bands = map->bands;
    effects.error.quadric->setValue(quadricUniform(*map));
    effects.error.firstBand->setValue(static_cast<float>(bands.first));
    effects.error.bandCount->setValue(static_cast<float>(bands.count));
    effects.error.bandColors->setValue(colorUniform(bands.count));
}

} // namespace carina
