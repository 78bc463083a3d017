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

/// Where a camera sees a point.
///
/// @returns right and down of the picture's upper left corner, as shares of its width and height;
///          nothing for a point that is not in the picture.
[[nodiscard]] std::optional<QPointF> seenAt(const Vec3& p_A, const CameraPose& pose,
                                            const Frustum& frustum);

/// The names of labelled parts, over a picture: each beside a point of its surface near the middle
/// of the part, and no two one over the other.
class PartLabels
{
public:
    /// @pre `over` outlives this.
    explicit PartLabels(QWidget& over) : m_over{over} {}

    /// Labels these of the parts, and no others.
    void setParts(std::span<const ScenePart> parts, const PartLooks& looks);

    /// Puts the labels where a camera sees their parts in a frame.
    void place(const SceneFrame& frame, const CameraPose& pose, const Frustum& frustum);
    void hide();

private:
    struct Label {
        QLabel* shown; ///< owned by m_over
        std::string body;
        Vec3 p_F; ///< what it stands beside
    };

    void clear();

    QWidget& m_over;
    std::vector<Label> m_labels;
};

} // namespace carina
