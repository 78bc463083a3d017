#pragma once

#include "widgets/scene/figures/scene_figure.h"
#include "widgets/scene/labels/name_layout.h"
#include "widgets/scene/labels/visible_places.h"
#include "widgets/scene/view/scene_frame.h"

#include <QWidget>

#include <span>
#include <vector>

class QLabel;

namespace carina
{

class LeaderLines;

/// How one eye sees a scene, and where in the widget its picture is.
struct EyeSight {
    SceneSight sight;
    QRect picture;
};

/// Writes the names of figures over a picture, each beside the point of the figure that has its
/// name, with a leader line; once for each eye. Names never cover each other (layOutNames). A
/// figure behind the patient is named, too.
class FigureNames
{
public:
    /// @pre `over` outlives this.
    explicit FigureNames(QWidget& over) : m_over{over} {}

    void setFigures(std::span<const SceneFigure> figures);

    /// Lays out the names for a frame and the eyes that see it, at most kMostEyes, beside the
    /// rectangles `taken`.
    void place(const SceneFrame& frame, std::span<const EyeSight> eyes,
               std::span<const QRect> taken = {});

    /// The names as they were laid out last, in pixels of the widget; `wish` counts the figures.
    [[nodiscard]] const std::vector<PlacedName>& placed() const { return m_placed; }
    /// The rectangles of the names that are written.
    [[nodiscard]] std::vector<QRect> boxes() const;

private:
    struct Name {
        QLabel* shown;      ///< owned by m_over; one for each eye
        std::size_t figure; ///< in m_figures
        std::size_t eye;
        QRect before{}; ///< in the picture of the eye, where it was written last
    };

    void layOut(const SceneFrame& frame, const EyeSight& eye, std::size_t number,
                std::span<const QRect> taken);
    void write(const std::vector<std::size_t>& eyes);

    QWidget& m_over;
    LeaderLines* m_leaders = nullptr; ///< owned by m_over; there is one once a figure has a name
    std::vector<SceneFigure> m_figures;
    std::vector<Name> m_names;
    std::vector<PlacedName> m_placed;
};

} // namespace carina
