#include "widgets/scene/labels/side_labels.h"

#include "widgets/scene/labels/picture_label.h"
#include "widgets/scene/view/orbit_camera.h"

#include <QLabel>

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr double kFromEdge = 6.0;    ///< pixels
constexpr double kLeastAcross = 0.5; ///< of a direction, seen from the side: 30 degrees off it

} // namespace

std::optional<QPointF> pointedAt(const Vec3& dir_A, const CameraPose& pose, const QRectF& rim)
{
    const Vec3 forward = (pose.p_A_target - pose.p_A_eye).normalized();
    const Vec3 right = forward.cross(pose.up_A).normalized();
    const Vec3 up = right.cross(forward);
    const QPointF across{right.dot(dir_A), -up.dot(dir_A)};
    if (std::hypot(across.x(), across.y()) < kLeastAcross)
        return std::nullopt;
    const double toRim = std::max(std::abs(across.x()) / (0.5 * rim.width()),
                                  std::abs(across.y()) / (0.5 * rim.height()));
    return rim.center() + across / toRim;
}

SideLabels::SideLabels(QWidget& over, std::string body)
    : m_over{over},
      m_body{std::move(body)},
      m_sides{Side{pictureLabel(over, tr("Right", "the patient's")), -Vec3::UnitX()},
              Side{pictureLabel(over, tr("Left", "the patient's")), Vec3::UnitX()}}
{
}

void SideLabels::place(const SceneFrame& frame, const CameraPose& pose, int covered)
{
    const auto body = frame.bodies.find(m_body);
    if (!m_body.empty() && body == frame.bodies.end())
        return hide();
    const Quat q_AF = m_body.empty() ? Quat::Identity() : body->second.X_AF.rotation();
    for (const auto& [word, dir_F] : m_sides) {
        const QPointF half{0.5 * word->width(), 0.5 * word->height()};
        const QPointF inside = half + QPointF{kFromEdge, kFromEdge};
        const auto middle =
            pointedAt(q_AF * dir_F, pose,
                      QRectF{m_over.rect()}.adjusted(inside.x(), inside.y() + covered, -inside.x(),
                                                     -inside.y()));
        word->setVisible(middle.has_value());
        if (!middle)
            continue;
        if (const QPoint corner = (*middle - half).toPoint(); word->pos() != corner)
            word->move(corner);
        raiseLabel(*word);
    }
}

std::vector<QRect> SideLabels::boxes() const
{
    std::vector<QRect> boxes;
    for (const Side& side : m_sides)
        if (side.word->isVisible())
            boxes.push_back(side.word->geometry());
    return boxes;
}

void SideLabels::hide()
{
    for (const Side& side : m_sides)
        side.word->hide();
}

} // namespace carina
