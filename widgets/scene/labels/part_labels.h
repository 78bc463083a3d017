#pragma once

#include "widgets/scene/labels/name_layout.h"
#include "widgets/scene/labels/visible_places.h"
#include "widgets/scene/look/part_look.h"
#include "widgets/scene/view/scene_frame.h"

#include <QWidget>

#include <optional>
#include <span>
#include <vector>

class QLabel;

namespace carina
{

class LeaderLines;

/// Writes the names of labelled parts over a picture, each with a leader line to a place of the
/// part that is visible now: neither cut away nor behind an opaque part (visiblePlaces). A part
/// without such a place has no name in the picture; names never cover each other, and of more than
/// fit the nearest are written (layOutNames).
class PartLabels
{
public:
    /// @pre `over` outlives this.
    explicit PartLabels(QWidget& over) : m_over{over} {}

    /// Labels those of these parts whose look is `labelled`, and no others.
    void setParts(std::span<const ScenePart> parts, const PartLooks& looks);

    /// Lays out the names for a frame and the camera that sees it, beside the rectangles `taken`.
    /// Their places are looked for anew in every kFramesAPlace-th frame, and whenever section,
    /// camera or parts have changed; in between they move with their parts.
    void place(const SceneFrame& frame, const SceneSight& sight, std::span<const QRect> taken = {});
    void hide();

    /// The names as they were laid out last; `wish` counts the labelled parts as they were given.
    [[nodiscard]] const std::vector<PlacedName>& placed() const { return m_placed; }

    static constexpr int kFramesAPlace = 6;

private:
    struct Label {
        QLabel* shown;    ///< owned by m_over
        std::size_t part; ///< in m_parts
        std::optional<SurfacePlace> place;
    };

    void clear();
    [[nodiscard]] bool isStale(const SceneSight& sight) const;
    void findPlaces(const SceneFrame& frame, const SceneSight& sight);
    void writeNames();

    QWidget& m_over;
    LeaderLines* m_leaders = nullptr; ///< owned by m_over; there is one once a part is labelled
    std::vector<ScenePart> m_parts;
    std::vector<Label> m_labels;
    std::vector<PlacedName> m_placed;
    std::optional<SceneSight> m_sight; ///< for which the places were found
    int m_age = 0;                     ///< frames since then
};

} // namespace carina
