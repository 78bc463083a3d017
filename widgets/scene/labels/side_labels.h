#pragma once

#include "widgets/scene/view/scene_frame.h"

#include <QCoreApplication>
#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <array>
#include <optional>
#include <string>
#include <vector>

class QLabel;

namespace carina
{

struct CameraPose;

/// The point on the rim of a rectangle in the picture to which a direction of A points from its
/// centre.
/// @returns std::nullopt if the camera looks nearly along the direction
[[nodiscard]] std::optional<QPointF> pointedAt(const Vec3& dir_A, const CameraPose& pose,
                                               const QRectF& rim);

/// Labels the patient's right and left at the matching edges of a picture, as the patient is drawn:
/// in the pose of its body and seen by the camera.
class SideLabels
{
    Q_DECLARE_TR_FUNCTIONS(SideLabels)

public:
    /// @param body of the patient, whose axes are those of A where it is at rest; "" for a patient
    ///        that is fixed in A
    /// @pre `over` outlives this.
    SideLabels(QWidget& over, std::string body);

    /// Moves the labels to the edges to which the patient's right and left point in a frame. They
    /// are hidden while the body is not drawn or the camera looks nearly along its left-right axis.
    /// @param covered pixels at the upper edge in which they do not stand
    void place(const SceneFrame& frame, const CameraPose& pose, int covered = 0);
    void hide();
    /// The rectangles of the labels that are shown.
    [[nodiscard]] std::vector<QRect> boxes() const;

private:
    struct Side {
        QLabel* word; ///< owned by m_over
        Vec3 dir_F;   ///< in the frame of the body
    };

    QWidget& m_over;
    std::string m_body;
    std::array<Side, 2> m_sides;
};

} // namespace carina
