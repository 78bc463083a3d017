#include "widgets/scene/surfaces/surface_entity.h"

#include "widgets/scene/look/chest_uniforms.h"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QGeometry>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QGeometryRenderer>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>

#include <algorithm>
#include <array>
#include <cstddef>

namespace carina
{

namespace
{

static_assert(sizeof(SurfaceVertex) == 12 * sizeof(float));
static_assert(sizeof(Triangle) == 3 * sizeof(std::uint32_t));

/// A turn by less than a third of a degree leaves the order of what is blended as it is.
constexpr float kSmallTurn = 0.006F; // radians

template <class T> QByteArray bytesOf(const std::vector<T>& values)
{
    return {reinterpret_cast<const char*>(values.data()),
            static_cast<qsizetype>(values.size() * sizeof(T))};
}

struct Column {
    const char* name;
    std::size_t offset;
};
constexpr std::array kColumns{Column{"vertexPosition", offsetof(SurfaceVertex, position)},
                              Column{"vertexNormal", offsetof(SurfaceVertex, normal)},
                              Column{"vertexColor", offsetof(SurfaceVertex, color)},
                              Column{"vertexPart", offsetof(SurfaceVertex, part)}};

void addVertices(Qt3DCore::QGeometry* geometry, const std::vector<SurfaceVertex>& vertices)
{
    auto* buffer = new Qt3DCore::QBuffer;
    buffer->setData(bytesOf(vertices));
    for (const Column& column : kColumns) {
        auto* attribute = new Qt3DCore::QAttribute;
        attribute->setName(QString::fromLatin1(column.name));
        attribute->setAttributeType(Qt3DCore::QAttribute::VertexAttribute);
        attribute->setVertexBaseType(Qt3DCore::QAttribute::Float);
        attribute->setVertexSize(3);
        attribute->setBuffer(buffer);
        attribute->setByteOffset(static_cast<uint>(column.offset));
        attribute->setByteStride(sizeof(SurfaceVertex));
        attribute->setCount(static_cast<uint>(vertices.size()));
        geometry->addAttribute(attribute);
    }
}

Qt3DCore::QAttribute* cornerList(Qt3DCore::QBuffer* corners)
{
    auto* attribute = new Qt3DCore::QAttribute;
    attribute->setAttributeType(Qt3DCore::QAttribute::IndexAttribute);
    attribute->setVertexBaseType(Qt3DCore::QAttribute::UnsignedInt);
    attribute->setBuffer(corners);
    return attribute;
}

std::vector<Qt3DRender::QParameter*> motionParameters(bool hasManyRegions)
{
    if (!hasManyRegions)
        return {new Qt3DRender::QParameter(QStringLiteral("motion"), QMatrix4x4{})};
    std::vector<Qt3DRender::QParameter*> parameters;
    for (std::size_t region = 0; region < kChestRegions; ++region)
        parameters.push_back(new Qt3DRender::QParameter(
            QStringLiteral("regions[%1].motion").arg(region), QMatrix4x4{}));
    return parameters;
}

/// Explicit bounds spare Qt 3D a scan of all positions. Nothing is culled by them.
void setBounds(Qt3DRender::QGeometryRenderer* renderer, const std::vector<SurfaceVertex>& vertices)
{
    Box bounds;
    for (const SurfaceVertex& vertex : vertices)
        bounds.include(Vec3(vertex.position.cast<double>()));
    const Vec3f low = bounds.min.cast<float>();
    const Vec3f high = bounds.max.cast<float>();
    renderer->setMinPoint({low.x(), low.y(), low.z()});
    renderer->setMaxPoint({high.x(), high.y(), high.z()});
}

} // namespace

SurfaceEntity::SurfaceEntity(MergedSurface surface, Qt3DRender::QEffect* effect,
                             Qt3DCore::QEntity* parent)
    : m_key(std::move(surface.key)),
      m_pieces(std::move(surface.pieces)),
      m_triangles(std::move(surface.triangles)),
      m_entity(std::make_unique<Qt3DCore::QEntity>(parent)),
      m_renderer(new Qt3DRender::QGeometryRenderer),
      m_corners(new Qt3DCore::QBuffer),
      m_cornerList(cornerList(m_corners)),
      m_X_AF(new Qt3DCore::QTransform),
      m_chest(new Qt3DRender::QParameter(QStringLiteral("chest"), QMatrix4x4{})),
      m_motions(motionParameters(!m_key.region)),
      m_throat(new Qt3DRender::QParameter(QStringLiteral("throat"), throatUniform({}))),
      m_jaw(new Qt3DRender::QParameter(QStringLiteral("jaw"), jawUniform({})))
{
    if (m_key.layer == DrawLayer::Blended)
        for (const SurfaceVertex& vertex : surface.vertices)
            m_positions.push_back(vertex.position);
    auto* geometry = new Qt3DCore::QGeometry;
    addVertices(geometry, surface.vertices);
    geometry->addAttribute(m_cornerList);
    m_renderer->setGeometry(geometry);
    m_renderer->setPrimitiveType(Qt3DRender::QGeometryRenderer::Triangles);
    setBounds(m_renderer, surface.vertices);
    setMotion({});
    auto* material = new Qt3DRender::QMaterial;
    material->setEffect(effect);
    material->addParameter(m_chest);
    for (Qt3DRender::QParameter* motion : m_motions)
        material->addParameter(motion);
    material->addParameter(m_throat);
    material->addParameter(m_jaw);
    m_entity->addComponent(m_renderer);
    m_entity->addComponent(m_X_AF);
    m_entity->addComponent(material);
}

SurfaceEntity::~SurfaceEntity() = default;

void SurfaceEntity::setMotion(const BreathingChest& chest)
{
    if (m_key.region) {
        m_motions.front()->setValue(motionUniform(chest.of(*m_key.region)));
        return;
    }
    for (std::size_t region = 0; region < kChestRegions; ++region)
        m_motions[region]->setValue(motionUniform(chest.motion[region]));
}

void SurfaceEntity::apply(const SceneFrame& frame)
{
    m_isPlaced = true;
    if (!m_key.body.empty()) {
        const auto body = frame.bodies.find(m_key.body);
        m_isPlaced = body != frame.bodies.end();
        if (m_isPlaced) {
            m_R_AF = body->second.X_AF.rotation();
            const Vec3f p = body->second.X_AF.translation().cast<float>();
            m_X_AF->setRotation({static_cast<float>(m_R_AF.w()), static_cast<float>(m_R_AF.x()),
                                 static_cast<float>(m_R_AF.y()), static_cast<float>(m_R_AF.z())});
            m_X_AF->setTranslation({p.x(), p.y(), p.z()});
            m_X_AF->setScale(static_cast<float>(body->second.scale));
        }
    }
    m_chest->setValue(chestUniform(frame.chest.field));
    setMotion(frame.chest);
    m_throat->setValue(throatUniform(frame.throat.field));
    m_jaw->setValue(jawUniform(frame.throat.X_AJ));
}

void SurfaceEntity::show(std::span<const int> levels, const Vec3& forward_A)
{
    const bool isBlended = m_key.layer == DrawLayer::Blended;
    const bool isNew = !std::ranges::equal(levels, m_levels);
    const Vec3f forward_F = (m_R_AF.conjugate() * forward_A).cast<float>();
    const bool turned = (forward_F - m_forward_F).norm() > kSmallTurn;
    if (isNew) {
        m_levels.assign(levels.begin(), levels.end());
        std::vector<Triangle> chosen = trianglesAt(levels, m_pieces, m_triangles, m_isCut);
        if (isBlended)
            m_order = DrawOrder{std::move(chosen), m_positions};
        else
            drawTriangles(chosen);
    }
    if (isBlended && (isNew || turned)) {
        m_forward_F = forward_F;
        drawTriangles(m_order.backToFront(forward_F));
    }
    m_entity->setEnabled(m_isPlaced && m_renderer->vertexCount() > 0);
}

void SurfaceEntity::setCut(bool cut)
{
    if (cut != m_isCut)
        m_levels.clear(); // all of it is chosen anew
    m_isCut = cut;
}

void SurfaceEntity::drawTriangles(const std::vector<Triangle>& triangles)
{
    const auto count = static_cast<int>(3 * triangles.size());
    m_corners->setData(bytesOf(triangles));
    m_cornerList->setCount(static_cast<uint>(count));
    m_renderer->setVertexCount(count);
}

} // namespace carina
