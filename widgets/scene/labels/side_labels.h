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

/// Where a direction of A points to in a picture, from its middle to the rim of a rectangle.
/// @returns nothing where the camera looks nearly along it
[[nodiscard]] std::optional<QPointF> pointedAt(const Vec3& dir_A, const CameraPose& pose,
                                               const QRectF& rim);

/// The patient's right and left in words, at the edges of a picture that these are nearest to.
class SideLabels
{
    Q_DECLARE_TR_FUNCTIONS(SideLabels)

public:
    /// @pre `over` outlives this.
    explicit SideLabels(QWidget& over);

    /// Puts the words where a camera has these sides.
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
