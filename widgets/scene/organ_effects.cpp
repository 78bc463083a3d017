#include "widgets/scene/organ_effects.h"

#include "resources/resources.h"

#include <QVector4D>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>

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

} // namespace

OrganEffects makeOrganEffects(Qt3DCore::QNode* parent)
{
    Qt3DRender::QShaderProgram* surface = program("shaders/organ.frag", parent);
    Qt3DRender::QShaderProgram* id = program("shaders/id.frag", parent);
    OrganEffects effects;
    effects.cut = {uniform("section", QVector4D{}, parent), uniform("cutAway", 0.0F, parent)};
    for (std::size_t layer = 0; layer < kDrawLayers; ++layer) {
        auto* effect = new Qt3DRender::QEffect(parent);
        Qt3DRender::QTechnique* technique = openGlTechnique();
        technique->addRenderPass(pass(kSurfacePass, layer, surface));
        technique->addRenderPass(pass(kIdPass, layer, id));
        effect->addTechnique(technique);
        effect->addParameter(effects.cut.section);
        effect->addParameter(effects.cut.cutAway);
        effects.of[layer] = effect;
    }
    return effects;
}

} // namespace carina
