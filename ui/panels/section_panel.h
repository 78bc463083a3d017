#pragma once

#include "widgets/scene/look/section.h"
#include "widgets/scene/surfaces/scene_part.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QSlider;
class QSpinBox;

namespace carina
{

class SceneView;

/// Cuts the patient of a view open: what is cut, from which side, and how deep; and whether the
/// view may leave out detail.
class SectionPanel : public QWidget
{
    Q_OBJECT

public:
    explicit SectionPanel(QWidget* parent = nullptr);

    /// Works on what the view shows now. @pre the view outlives the panel.
    void setScene(SceneView& scene);

    /// The plane chosen; nothing while nothing is to be cut.
    [[nodiscard]] std::optional<Section> section() const;

private:
    void layOut();
    void fillChoices();
    void cut();
    void choose();

    SceneView* m_scene = nullptr;
    Box m_bounds_A; ///< of all that is in the patient
    QComboBox* m_what;
    QComboBox* m_side;
    QSlider* m_slider;
    QSpinBox* m_depth;
    QComboBox* m_detail;
};

} // namespace carina
