#include "widgets/scene/organ_effects.h"

#include "resources/resources.h"

#include <Qt3DRender/QCullFace>
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

/// The uniforms of organ.frag for one material group.
struct Look {
    float gloss;
    float opacity;
    float rimOpacity;
    float rimLight;
};

constexpr Look lookOf(MaterialGroup group)
{
    switch (group) {
    case MaterialGroup::Bone:
        return {0.20F, 1.0F, 1.0F, 0.10F};
    case MaterialGroup::SoftTissue:
        return {0.35F, 1.0F, 1.0F, 0.12F};
    case MaterialGroup::Tool:
        return {0.80F, 1.0F, 1.0F, 0.35F};
    case MaterialGroup::Airway:
        return {0.50F, 0.40F, 0.95F, 0.40F};
    case MaterialGroup::Lung:
        return {0.40F, 0.60F, 0.95F, 0.30F};
    case MaterialGroup::Veil:
        return {0.10F, 0.20F, 0.75F, 0.20F};
    case MaterialGroup::Skin:
        return {0.10F, 0.06F, 0.40F, 0.10F};
    }
    return {};
}

Qt3DRender::QShaderProgram* program(const char* fragmentShader, Qt3DCore::QNode* parent)
{
    auto* made = new Qt3DRender::QShaderProgram(parent);
    made->setVertexShaderCode(resource("shaders/organ.vert"));
    made->setFragmentShaderCode(resource(fragmentShader));
    return made;
}

/// Bodies are closed, so half of their triangles need no drawing; tools may be open, as tubes are.
Qt3DRender::QRenderPass* pass(const char* key, MaterialGroup group,
                              Qt3DRender::QShaderProgram* shaders)
{
    auto* filter = new Qt3DRender::QFilterKey;
    filter->setName(QString::fromLatin1(key));
    filter->setValue(layerOf(group));
    auto* made = new Qt3DRender::QRenderPass;
    made->addFilterKey(filter);
    made->setShaderProgram(shaders);
    if (layerOf(group) == 0 && group != MaterialGroup::Tool) {
        auto* cull = new Qt3DRender::QCullFace;
        cull->setMode(Qt3DRender::QCullFace::Back);
        made->addRenderState(cull);
    }
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

void addParameter(Qt3DRender::QEffect* effect, const char* name, float value)
{
    effect->addParameter(new Qt3DRender::QParameter(QString::fromLatin1(name), value));
}

} // namespace

OrganEffects makeOrganEffects(Qt3DCore::QNode* parent)
{
    Qt3DRender::QShaderProgram* surface = program("shaders/organ.frag", parent);
    Qt3DRender::QShaderProgram* id = program("shaders/id.frag", parent);
    OrganEffects effects{};
    for (int index = 0; index < kMaterialGroups; ++index) {
        const auto group = static_cast<MaterialGroup>(index);
        auto* effect = new Qt3DRender::QEffect(parent);
        Qt3DRender::QTechnique* technique = openGlTechnique();
        technique->addRenderPass(pass(kSurfacePass, group, surface));
        technique->addRenderPass(pass(kIdPass, group, id));
        effect->addTechnique(technique);
        const Look look = lookOf(group);
        addParameter(effect, "gloss", look.gloss);
        addParameter(effect, "opacity", look.opacity);
        addParameter(effect, "rimOpacity", look.rimOpacity);
        addParameter(effect, "rimLight", look.rimLight);
        effects[static_cast<std::size_t>(index)] = effect;
    }
    return effects;
}

} // namespace carina
