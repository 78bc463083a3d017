#pragma once

#include "widgets/scene/look/section.h"
#include "widgets/scene/surfaces/scene_part.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QSlider;

namespace carina
{

class CheckedSpinBox;
class SceneView;

/// Controls the section plane of a view: what is cut, from which side, and how deep; and whether
/// the view chooses the level of detail.
class SectionPanel : public QWidget
{
    Q_OBJECT

public:
    explicit SectionPanel(QWidget* parent = nullptr);

    /// Controls this view, with the bounds of its present parts. @pre the view outlives the panel.
    void setScene(SceneView& scene);

    /// The chosen plane; std::nullopt while nothing is cut.
    [[nodiscard]] std::optional<Section> section() const;

private:
    void layOut();
    void fillChoices();
    void cut();
    void choose();

    SceneView* m_scene = nullptr;
    Box m_bounds_A; ///< of all parts of the patient
    QComboBox* m_what;
    QComboBox* m_side;
    QSlider* m_slider;
    CheckedSpinBox* m_depth;
    QComboBox* m_detail;
};

} // namespace carina
