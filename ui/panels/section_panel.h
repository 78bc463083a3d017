#pragma once

#include "models/session/change_history.h"
#include "widgets/scene/look/section.h"
#include "widgets/scene/surfaces/scene_part.h"

#include <QPointer>
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

    /// Adds its changes to a history from now on.
    void setHistory(ChangeHistory& history) { m_history = &history; }

    /// The chosen plane; std::nullopt while nothing is cut.
    [[nodiscard]] std::optional<Section> section() const;
    /// Sets its controls to cut so, to the millimetre, as one change. Nothing where it does not cut
    /// from that side.
    void put(const std::optional<Section>& section);

private:
    /// Of its controls.
    struct Choice {
        int what = 0;
        int side = 0;
        int depth_mm = 0;

        friend bool operator==(const Choice&, const Choice&) = default;
    };

    void layOut();
    void fillChoices();
    void cut();
    void choose();
    void remember();
    void goBackTo(const Choice& choice);
    void setControls(const Choice& choice);
    [[nodiscard]] Choice choice() const;
    [[nodiscard]] std::optional<Choice> choiceFor(const std::optional<Section>& section) const;
    [[nodiscard]] QString text() const;

    SceneView* m_scene = nullptr;
    QPointer<ChangeHistory> m_history;
    Choice m_choice; ///< by which it is cut
    Box m_bounds_A;  ///< of all parts of the patient
    QComboBox* m_what;
    QComboBox* m_side;
    QSlider* m_slider;
    CheckedSpinBox* m_depth;
    QComboBox* m_detail;
};

} // namespace carina
