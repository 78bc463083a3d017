#pragma once

#include "widgets/scene/look/part_look.h"
#include "widgets/scene/view/scene_frame.h"

#include <QPointF>
#include <QWidget>

#include <optional>
#include <string>
#include <vector>

class QLabel;

namespace carina
{

struct CameraPose;

/// The position of a point in the picture of a camera.
///
/// @returns right and down from the upper left corner of the picture, as fractions of its width and
///          height; std::nullopt for a point outside the picture.
[[nodiscard]] std::optional<QPointF> seenAt(const Vec3& p_A, const CameraPose& pose,
                                            const Frustum& frustum);

/// Draws the names of labelled parts over a picture: each beside a point of the part's surface near
/// its centre, without overlap.
class PartLabels
{
public:
    /// @pre `over` outlives this.
    explicit PartLabels(QWidget& over) : m_over{over} {}

    /// Labels those of these parts whose look is `labelled`, and no others.
    void setParts(std::span<const ScenePart> parts, const PartLooks& looks);

    /// Moves the labels to where a camera sees their parts in a frame.
    void place(const SceneFrame& frame, const CameraPose& pose, const Frustum& frustum);
    void hide();

private:
    struct Label {
        QLabel* shown; ///< owned by m_over
        std::string body;
        Vec3 p_F; ///< the labelled point
    };

    void clear();

    QWidget& m_over;
    std::vector<Label> m_labels;
};

} // namespace carina
