#pragma once

#include "engine/core/ids.h"
#include "models/session/change_history.h"
#include "widgets/scene/look/section.h"
#include "widgets/scene/surfaces/scene_part.h"

#include <QPointer>
#include <QWidget>

#include <map>
#include <optional>
#include <string>

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

    /// Controls this view, with the bounds of its present parts. Each station has its own cut:
    /// where it is of the same patient it comes back, and another station begins without one.
    /// @param station that is drawn; kNoStation in a program that has only one
    /// @param patient by its content hash; empty: another one than before
    /// @pre the view outlives the panel.
    void setScene(SceneView& scene, StationId station = kNoStation,
                  const std::string& patient = {});

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

    /// How it was at a station last.
    struct Kept {
        std::string patient;
        Choice choice;
    };

    void layOut();
    void fillChoices();
    void cut();
    void choose();
    void remember();
    void begin(StationId station, const std::string& patient);
    void goBackTo(StationId station, const Choice& choice);
    void setControls(const Choice& choice);
    [[nodiscard]] Choice choice() const;
    [[nodiscard]] std::optional<Choice> choiceFor(const std::optional<Section>& section) const;
    [[nodiscard]] QString text() const;

    SceneView* m_scene = nullptr;
    QPointer<ChangeHistory> m_history;
    StationId m_station = kNoStation;
    std::map<StationId, Kept> m_kept;
    Choice m_choice; ///< by which it is cut
    Box m_bounds_A;  ///< of all parts of the patient
    QComboBox* m_what;
    QComboBox* m_side;
    QSlider* m_slider;
    CheckedSpinBox* m_depth;
    QComboBox* m_detail;
};

} // namespace carina
