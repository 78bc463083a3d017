#include "widgets/scene/surface_entity.h"

#include "widgets/scene/chest_uniforms.h"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QGeometry>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QGeometryRenderer>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>

#include <cstddef>

namespace carina
{

namespace
{

static_assert(sizeof(SurfaceVertex) == 10 * sizeof(float));
static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));

template <class T> Qt3DCore::QBuffer* bufferOf(const std::vector<T>& values)
{
    auto* buffer = new Qt3DCore::QBuffer;
    buffer->setData(QByteArray(reinterpret_cast<const char*>(values.data()),
                               static_cast<qsizetype>(values.size() * sizeof(T))));
    return buffer;
}

struct Column {
    const char* name;
    std::size_t offset;
    uint size;
};

void addColumn(Qt3DCore::QGeometry* geometry, Qt3DCore::QBuffer* buffer, const Column& column,
               std::size_t stride, std::size_t count)
{
    auto* attribute = new Qt3DCore::QAttribute;
    attribute->setName(QString::fromLatin1(column.name));
    attribute->setAttributeType(Qt3DCore::QAttribute::VertexAttribute);
    attribute->setVertexBaseType(Qt3DCore::QAttribute::Float);
    attribute->setVertexSize(column.size);
    attribute->setBuffer(buffer);
    attribute->setByteOffset(static_cast<uint>(column.offset));
    attribute->setByteStride(static_cast<uint>(stride));
    attribute->setCount(static_cast<uint>(count));
    geometry->addAttribute(attribute);
}

void addIndices(Qt3DCore::QGeometry* geometry, const std::vector<Triangle>& triangles)
{
    auto* attribute = new Qt3DCore::QAttribute;
    attribute->setAttributeType(Qt3DCore::QAttribute::IndexAttribute);
    attribute->setVertexBaseType(Qt3DCore::QAttribute::UnsignedInt);
    attribute->setBuffer(bufferOf(triangles));
    attribute->setCount(static_cast<uint>(3 * triangles.size()));
    geometry->addAttribute(attribute);
}

Qt3DRender::QGeometryRenderer* rendererOf(const MergedSurface& surface)
{
    auto* geometry = new Qt3DCore::QGeometry;
    const std::size_t count = surface.vertices.size();
    Qt3DCore::QBuffer* vertices = bufferOf(surface.vertices);
    for (const Column& column : {Column{"vertexPosition", offsetof(SurfaceVertex, position), 3},
                                 Column{"vertexNormal", offsetof(SurfaceVertex, normal), 3},
                                 Column{"vertexColor", offsetof(SurfaceVertex, color), 3},
                                 Column{"partId", offsetof(SurfaceVertex, partId), 1}})
        addColumn(geometry, vertices, column, sizeof(SurfaceVertex), count);
    addIndices(geometry, surface.triangles);

    // Explicit bounds spare Qt 3D a scan of all positions. Nothing is culled by them.
    Box bounds;
    for (const SurfaceVertex& vertex : surface.vertices)
        bounds.include(Vec3(vertex.position.cast<double>()));
    auto* renderer = new Qt3DRender::QGeometryRenderer;
    renderer->setGeometry(geometry);
    renderer->setPrimitiveType(Qt3DRender::QGeometryRenderer::Triangles);
    const Vec3f low = bounds.min.cast<float>();
    const Vec3f high = bounds.max.cast<float>();
    renderer->setMinPoint({low.x(), low.y(), low.z()});
    renderer->setMaxPoint({high.x(), high.y(), high.z()});
    return renderer;
}

} // namespace

SurfaceEntity::SurfaceEntity(const MergedSurface& surface, Qt3DRender::QEffect* effect,
                             Qt3DCore::QEntity* parent)
    : m_key(surface.key),
      m_entity(std::make_unique<Qt3DCore::QEntity>(parent)),
      m_X_AF(new Qt3DCore::QTransform),
      m_chest(new Qt3DRender::QParameter(QStringLiteral("chest"), QMatrix4x4{})),
      m_motion(new Qt3DRender::QParameter(QStringLiteral("motion"), motionUniform({})))
{
    auto* material = new Qt3DRender::QMaterial;
    material->setEffect(effect);
    material->addParameter(m_chest);
    material->addParameter(m_motion);
    m_entity->addComponent(rendererOf(surface));
    m_entity->addComponent(m_X_AF);
    m_entity->addComponent(material);
}

SurfaceEntity::~SurfaceEntity() = default;

void SurfaceEntity::apply(const SceneFrame& frame, int level)
{
    bool shown = level >= m_key.firstLevel && level <= m_key.lastLevel;
    if (!m_key.body.empty()) {
        const auto body = frame.bodies.find(m_key.body);
        if (body == frame.bodies.end()) {
            shown = false;
        } else {
            const Quat& q = body->second.X_AF.rotation();
            const Vec3f p = body->second.X_AF.translation().cast<float>();
            m_X_AF->setRotation({static_cast<float>(q.w()), static_cast<float>(q.x()),
                                 static_cast<float>(q.y()), static_cast<float>(q.z())});
            m_X_AF->setTranslation({p.x(), p.y(), p.z()});
            m_X_AF->setScale(static_cast<float>(body->second.scale));
        }
    }
    if (m_key.region != ChestRegion::Still) {
        m_chest->setValue(chestUniform(frame.chest.field));
        m_motion->setValue(motionUniform(frame.chest.of(m_key.region)));
    }
    m_entity->setEnabled(shown);
}

} // namespace carina
