#include "widgets/scene/surfaces/surface_share.h"

#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QGeometry>
#include <Qt3DCore/QTransform>
#include <Qt3DRender/QGeometryRenderer>
#include <Qt3DRender/QMaterial>

#include <array>
#include <cstddef>
#include <utility>

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
constexpr std::array kVertexColumns{Column{"vertexPosition", offsetof(SurfaceVertex, position)},
                                    Column{"vertexNormal", offsetof(SurfaceVertex, normal)},
                                    Column{"vertexColor", offsetof(SurfaceVertex, color)},
                                    Column{"vertexPart", offsetof(SurfaceVertex, part)}};

Qt3DCore::QAttribute* cornerList(Qt3DCore::QBuffer* corners)
{
    auto* attribute = new Qt3DCore::QAttribute;
    attribute->setAttributeType(Qt3DCore::QAttribute::IndexAttribute);
    attribute->setVertexBaseType(Qt3DCore::QAttribute::UnsignedInt);
    attribute->setBuffer(corners);
    return attribute;
}

} // namespace

SurfaceColumns surfaceColumns(const std::vector<SurfaceVertex>& vertices, Qt3DCore::QEntity* owner)
{
    SurfaceColumns columns;
    auto* buffer = new Qt3DCore::QBuffer{owner};
    buffer->setData(bytesOf(vertices));
    columns.vertices = buffer;
    for (const Column& column : kVertexColumns) {
        auto* attribute = new Qt3DCore::QAttribute{owner};
        attribute->setName(QString::fromLatin1(column.name));
        attribute->setAttributeType(Qt3DCore::QAttribute::VertexAttribute);
        attribute->setVertexBaseType(Qt3DCore::QAttribute::Float);
        attribute->setVertexSize(3);
        attribute->setBuffer(buffer);
        attribute->setByteOffset(static_cast<uint>(column.offset));
        attribute->setByteStride(sizeof(SurfaceVertex));
        attribute->setCount(static_cast<uint>(vertices.size()));
        columns.attributes.push_back(attribute);
    }
    Box bounds;
    for (const SurfaceVertex& vertex : vertices)
        bounds.include(Vec3(vertex.position.cast<double>()));
    columns.low = bounds.min.cast<float>();
    columns.high = bounds.max.cast<float>();
    return columns;
}

SurfaceShare::SurfaceShare(std::string liftedWith, const SurfaceColumns& columns,
                           Qt3DRender::QMaterial* material, Qt3DCore::QEntity* parent)
    : m_liftedWith{std::move(liftedWith)},
      m_entity{new Qt3DCore::QEntity{parent}},
      m_renderer{new Qt3DRender::QGeometryRenderer},
      m_corners{new Qt3DCore::QBuffer},
      m_cornerList{cornerList(m_corners)},
      m_X_AF{new Qt3DCore::QTransform}
{
    auto* geometry = new Qt3DCore::QGeometry;
    for (Qt3DCore::QAttribute* attribute : columns.attributes)
        geometry->addAttribute(attribute);
    geometry->addAttribute(m_cornerList);
    m_renderer->setGeometry(geometry);
    m_renderer->setPrimitiveType(Qt3DRender::QGeometryRenderer::Triangles);
    // Explicit bounds spare Qt 3D a scan of all positions. Nothing is culled by them.
    m_renderer->setMinPoint({columns.low.x(), columns.low.y(), columns.low.z()});
    m_renderer->setMaxPoint({columns.high.x(), columns.high.y(), columns.high.z()});
    m_entity->addComponent(m_renderer);
    m_entity->addComponent(m_X_AF);
    m_entity->addComponent(material);
}

void SurfaceShare::place(const std::optional<PlacedBody>& place)
{
    m_isPlaced = place.has_value();
    if (!place)
        return;
    m_R_AF = place->X_AF.rotation();
    const Vec3f p = place->X_AF.translation().cast<float>();
    m_X_AF->setRotation({static_cast<float>(m_R_AF.w()), static_cast<float>(m_R_AF.x()),
                         static_cast<float>(m_R_AF.y()), static_cast<float>(m_R_AF.z())});
    m_X_AF->setTranslation({p.x(), p.y(), p.z()});
    m_X_AF->setScale(static_cast<float>(place->scale));
}

Vec3f SurfaceShare::inBody(const Vec3& forward_A) const
{
    return (m_R_AF.conjugate() * forward_A).cast<float>();
}

void SurfaceShare::draw(const std::vector<Triangle>& triangles)
{
    const auto count = static_cast<int>(3 * triangles.size());
    m_corners->setData(bytesOf(triangles));
    m_cornerList->setCount(static_cast<uint>(count));
    m_renderer->setVertexCount(count);
}

void SurfaceShare::drawSorted(std::vector<Triangle> triangles, const std::vector<Vec3f>& positions,
                              const Vec3& forward_A)
{
    m_order = DrawOrder{std::move(triangles), positions};
    m_forward_F = inBody(forward_A);
    draw(m_order.backToFront(m_forward_F));
}

void SurfaceShare::sort(const Vec3& forward_A)
{
    const Vec3f forward_F = inBody(forward_A);
    if ((forward_F - m_forward_F).norm() <= kSmallTurn)
        return;
    m_forward_F = forward_F;
    draw(m_order.backToFront(forward_F));
}

void SurfaceShare::show() { m_entity->setEnabled(m_isPlaced && m_renderer->vertexCount() > 0); }

} // namespace carina
