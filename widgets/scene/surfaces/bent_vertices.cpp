#include "widgets/scene/surfaces/bent_vertices.h"

#include <Qt3DCore/QBuffer>

#include <algorithm>
#include <cstring>

namespace carina
{

void BentVertices::follow(const LineBend* bend)
{
    if (bend == nullptr) {
        if (!m_line.empty())
            upload(m_rest);
        m_line.clear();
        return;
    }
    const bool isFixed = std::ranges::equal(bend->rest(), m_restLine);
    if (isFixed && std::ranges::equal(bend->bent(), m_line))
        return;
    if (!isFixed)
        fixTo(*bend);
    m_line.assign(bend->bent().begin(), bend->bent().end());
    std::vector<SurfaceVertex> vertices = m_rest;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Fixed& fixed = m_fixed[i];
        const LineBend::Place there = bend->whereBent(fixed.along);
        vertices[i].position = (there.point + there.axes * fixed.offset).cast<float>();
        vertices[i].normal = (there.axes * fixed.normal).cast<float>();
    }
    upload(vertices);
}

void BentVertices::fixTo(const LineBend& bend)
{
    if (m_rest.empty()) {
        const QByteArray bytes = m_buffer->data();
        m_rest.resize(std::size_t(bytes.size()) / sizeof(SurfaceVertex));
        std::memcpy(m_rest.data(), bytes.constData(), m_rest.size() * sizeof(SurfaceVertex));
    }
    m_restLine.assign(bend.rest().begin(), bend.rest().end());
    m_fixed.clear();
    for (const SurfaceVertex& vertex : m_rest) {
        const Vec3 p = vertex.position.cast<double>();
        const double along = bend.alongTo(p);
        const LineBend::Place place = bend.atRest(along);
        m_fixed.push_back({along, place.axes.transpose() * (p - place.point),
                           place.axes.transpose() * vertex.normal.cast<double>()});
    }
}

void BentVertices::upload(const std::vector<SurfaceVertex>& vertices)
{
    m_buffer->setData({reinterpret_cast<const char*>(vertices.data()),
                       qsizetype(vertices.size() * sizeof(SurfaceVertex))});
}

} // namespace carina
