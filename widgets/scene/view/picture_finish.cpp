#include "widgets/scene/view/picture_finish.h"

#include "resources/resources.h"
#include "widgets/scene/look/picture_quality.h"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QGeometry>
#include <Qt3DRender/QAbstractTexture>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QGeometryRenderer>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QTechnique>

#include <array>

namespace carina
{
namespace
{

/// In the picture's own coordinates, which are -1 to 1: the half outside is not drawn.
constexpr std::array<float, 9> kCovering{-1.0F, -1.0F, 0.0F, 3.0F, -1.0F, 0.0F, -1.0F, 3.0F, 0.0F};

Qt3DRender::QGeometryRenderer* coveringTriangle()
{
    auto* geometry = new Qt3DCore::QGeometry;
    auto* buffer = new Qt3DCore::QBuffer{geometry};
    buffer->setData(
        QByteArray{reinterpret_cast<const char*>(kCovering.data()), qsizetype(sizeof(kCovering))});
    auto* corners = new Qt3DCore::QAttribute{geometry};
    corners->setName(QStringLiteral("vertexPosition"));
    corners->setAttributeType(Qt3DCore::QAttribute::VertexAttribute);
    corners->setVertexBaseType(Qt3DCore::QAttribute::Float);
    corners->setVertexSize(3);
    corners->setBuffer(buffer);
    corners->setByteStride(3 * sizeof(float));
    corners->setCount(3);
    geometry->addAttribute(corners);
    auto* renderer = new Qt3DRender::QGeometryRenderer;
    renderer->setPrimitiveType(Qt3DRender::QGeometryRenderer::Triangles);
    renderer->setVertexCount(3);
    renderer->setGeometry(geometry);
    return renderer;
}

Qt3DRender::QRenderPass* finishPass(PictureQuality quality, const char* fragmentShader,
                                    Qt3DRender::QAbstractTexture* unfinished)
{
    auto* pass = new Qt3DRender::QRenderPass;
    auto* key = new Qt3DRender::QFilterKey;
    key->setName(QString::fromLatin1(kFinishPass));
    key->setValue(static_cast<int>(quality));
    pass->addFilterKey(key);
    auto* program = new Qt3DRender::QShaderProgram{pass};
    program->setVertexShaderCode(resource("shaders/finish.vert"));
    program->setFragmentShaderCode(resource(fragmentShader));
    pass->setShaderProgram(program);
    pass->addParameter(new Qt3DRender::QParameter{QStringLiteral("picture"), unfinished});
    return pass;
}

} // namespace

PictureFinish::PictureFinish(Qt3DRender::QAbstractTexture* smoothed,
                             Qt3DRender::QAbstractTexture* fine, Qt3DCore::QEntity* parent)
{
    auto* technique = new Qt3DRender::QTechnique;
    Qt3DRender::QGraphicsApiFilter* api = technique->graphicsApiFilter();
    api->setApi(Qt3DRender::QGraphicsApiFilter::OpenGL);
    api->setProfile(Qt3DRender::QGraphicsApiFilter::CoreProfile);
    api->setMajorVersion(3);
    api->setMinorVersion(2); // textures with several samples
    technique->addRenderPass(
        finishPass(PictureQuality::Smoothed, "shaders/smoothed.frag", smoothed));
    technique->addRenderPass(finishPass(PictureQuality::Fine, "shaders/fine.frag", fine));
    auto* effect = new Qt3DRender::QEffect;
    effect->addTechnique(technique);
    auto* material = new Qt3DRender::QMaterial;
    material->setEffect(effect);
    auto* entity = new Qt3DCore::QEntity{parent};
    entity->addComponent(coveringTriangle());
    entity->addComponent(material);
}

} // namespace carina
