#include "widgets/scene/labels/part_labels.h"

#include "widgets/scene/labels/picture_label.h"
#include "widgets/scene/view/orbit_camera.h"

#include <QLabel>

#include <algorithm>

namespace carina
{

namespace
{

constexpr int kRightOfPoint = 6; ///< pixels to the right of the point

/// A vertex near the middle: the middle itself of a rib lies in the air.
Vec3 placeOn(const TriangleMesh& mesh)
{
    const Vec3f middle = boundsOf(mesh).centre().cast<float>();
    const auto nearest = std::min_element(
        mesh.positions.begin(), mesh.positions.end(), [&](const Vec3f& a, const Vec3f& b) {
            return (a - middle).squaredNorm() < (b - middle).squaredNorm();
        });
    return nearest->cast<double>();
}

} // namespace

std::optional<QPointF> seenAt(const Vec3& p_A, const CameraPose& pose, const Frustum& frustum)
{
    const Vec3 forward = (pose.p_A_target - pose.p_A_eye).normalized();
    const Vec3 right = forward.cross(pose.up_A).normalized();
    const Vec3 up = right.cross(forward);
    const Vec3 way = p_A - pose.p_A_eye;
    const double depth = forward.dot(way);
    if (depth <= 0.0)
        return std::nullopt;
    const QPointF seen{(right.dot(way) / depth - frustum.left) / (frustum.right - frustum.left),
                       (frustum.top - up.dot(way) / depth) / (frustum.top - frustum.bottom)};
    if (seen.x() < 0.0 || seen.x() > 1.0 || seen.y() < 0.0 || seen.y() > 1.0)
        return std::nullopt;
    return seen;
}

void PartLabels::clear()
{
    for (const Label& label : m_labels)
        delete label.shown;
    m_labels.clear();
}

void PartLabels::setParts(std::span<const ScenePart> parts, const PartLooks& looks)
{
    clear();
    for (const ScenePart& part : parts) {
        const auto look = looks.find(part.id);
        if (look == looks.end() || !look->second.labelled || part.levels.back()->empty())
            continue;
        m_labels.push_back({pictureLabel(m_over, QString::fromStdString(part.name)), part.body,
                            placeOn(*part.levels.back())});
    }
}

void PartLabels::place(const SceneFrame& frame, const CameraPose& pose, const Frustum& frustum)
{
    std::vector<std::pair<QPoint, QLabel*>> places;
    for (const Label& label : m_labels) {
        const auto body = frame.bodies.find(label.body);
        const bool isThere = label.body.empty() || body != frame.bodies.end();
        Vec3 p_A = label.p_F;
        if (body != frame.bodies.end())
            p_A = body->second.X_AF * (body->second.scale * label.p_F);
        const auto seen = isThere ? seenAt(p_A, pose, frustum) : std::nullopt;
        label.shown->setVisible(seen.has_value());
        if (seen)
            places.emplace_back(QPoint{qRound(seen->x() * m_over.width()) + kRightOfPoint,
                                       qRound(seen->y() * m_over.height())},
                                label.shown);
    }
    std::sort(places.begin(), places.end(),
              [](const auto& a, const auto& b) { return a.first.y() < b.first.y(); });
    std::vector<QRect> taken;
    for (const auto& [place, label] : places) {
        QRect wanted{place, label->size()};
        wanted.moveRight(std::min(wanted.right(), m_over.width() - 1));
        for (const QRect& other : taken)
            if (wanted.intersects(other))
                wanted.moveTop(other.bottom() + 1);
        taken.push_back(wanted);
        if (label->pos() != wanted.topLeft())
            label->move(wanted.topLeft());
        raiseLabel(*label);
    }
}

void PartLabels::hide()
{
    for (const Label& label : m_labels)
        label.shown->hide();
}

} // namespace carina
