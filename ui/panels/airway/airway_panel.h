#pragma once

#include "models/airway/airway_event_model.h"
#include "models/airway/head_position_model.h"

#include <QWidget>

#include <array>

class QBoxLayout;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QSlider;

namespace carina
{

class AirwayGroupBar;
class CheckedSpinBox;
class ElidedLabel;
class HeadPositionRow;
class RefusalLine;

/// Shows and sets the events that make the patient's airway difficult, and how the head lies: of
/// each kind of event its severity in per cent, for all of them and the head the time over which a
/// change comes, a choice of presets, which says "Custom" where the severities are those of none,
/// and a button that ends the events. In sight are the events of one group, or all
/// (AirwayGroupBar), below the headings of the groups, which stay where they are. A control shows
/// the value that is set or, while a change is pending, the requested one; beside it stands the
/// severity of now, as long as that is another, or the one that is drawn, where that is less, as
/// several fill the throat. An event that the patient does not show
/// says why, and cannot be set unless it is to be ended, or is for other patients too; one that it
/// shows in part says that. For a person without permission the panel states the reason.
class AirwayPanel : public QWidget
{
    Q_OBJECT

public:
    explicit AirwayPanel(QWidget* parent = nullptr);

    /// @pre both models outlive the panel.
    void setModels(AirwayEventModel& events, HeadPositionModel& head);

    /// Has the events of this group in sight, or of all (AirwayGroupBar::kAll). Nothing where no
    /// group is called so.
    void showGroup(const QByteArray& name);

Q_SIGNALS:
    /// A person chose it.
    void groupChosen(const QByteArray& name);

private:
    struct Row {
        QLabel* label;
        QLabel* present; ///< "now 35 %", "drawn 67 %"
        CheckedSpinBox* severity;
        QSlider* slider;
        QLabel* notShown; ///< why the patient does not show it, or not all of it
    };

    void layOut();
    void addPresets(QBoxLayout& column);
    void addTimeAndClear(QBoxLayout& column);
    [[nodiscard]] static Row addRow(QGridLayout& rows, AirwayEventKind kind);
    void connectRow(AirwayEventKind kind);
    void choosePreset(int place);
    void addRows();
    void addSuction();
    void showRows();
    void refresh();
    void refreshPreset();
    void refreshRow(AirwayEventKind kind);
    void refreshPresent(AirwayEventKind kind);
    void offerWhatCanBeSet();

    AirwayEventModel* m_model = nullptr;
    HeadPositionModel* m_headModel = nullptr;
    QLabel* m_obstacle;
    QLabel* m_notShown;   ///< why the patient shows no event at all
    QWidget* m_controls;  ///< above the groups
    QComboBox* m_presets; ///< each with its name as data
    QLabel* m_condition;  ///< how the head has to lie for the preset's grade, where it does not
    CheckedSpinBox* m_over;
    HeadPositionRow* m_head;
    AirwayGroupBar* m_groups;
    QWidget* m_events;                           ///< the rows
    std::array<Row, kAirwayEventKinds> m_rows{}; ///< by kind
    QPushButton* m_suction;                      ///< below the rows, with the fluids
    QPushButton* m_clear;
    RefusalLine* m_refused;
    ElidedLabel* m_travelling; ///< beside the headings
};

} // namespace carina
