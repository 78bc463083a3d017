#pragma once

#include "engine/geometry/rigid_transform.h"

#include <QCoreApplication>
#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <array>
#include <optional>

class QLabel;

namespace carina
{

struct CameraPose;

/// The point on the rim of a rectangle in the picture to which a direction of A points from its
/// centre.
/// @returns std::nullopt if the camera looks nearly along the direction
[[nodiscard]] std::optional<QPointF> pointedAt(const Vec3& dir_A, const CameraPose& pose,
                                               const QRectF& rim);

/// Labels the patient's right and left at the matching edges of a picture.
class SideLabels
{
    Q_DECLARE_TR_FUNCTIONS(SideLabels)

public:
    /// @pre `over` outlives this.
    explicit SideLabels(QWidget& over);

    /// Moves the labels to the edges for a camera pose.
    void place(const CameraPose& pose);
    void hide();

private:
    struct Side {
        QLabel* word; ///< owned by m_over
        Vec3 dir_A;
    };

    QWidget& m_over;
    std::array<Side, 2> m_sides;
};

} // namespace carina
