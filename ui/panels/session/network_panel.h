#pragma once

#include "models/network/network_figures_model.h"
#include "models/network/network_model.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QTableView;

namespace carina
{

class HistoryPlot;

/// The network path to one participant: all figures with their units, and on demand the delays as
/// a curve. Without it a window of 800 pixels has the drift of shared objects in sight, too.
class NetworkPanel : public QWidget
{
    Q_OBJECT

public:
    explicit NetworkPanel(QWidget* parent = nullptr);

    /// @pre the model outlives the panel.
    void setModel(NetworkModel& model);
    /// Shows the path to this participant, where there is one.
    void choose(ParticipantId participant);

private:
    void layOut();
    /// Selects the participant shown before the list changed.
    void findShown();
    void refresh();
    void showStrategy();
    void askStrategy();
    void plot(const NetworkFigures& figures);
    void unfold();

    QComboBox* m_participant;
    QPushButton* m_curve;
    QLabel* m_legend;
    HistoryPlot* m_plot;
    QTableView* m_table;
    QLabel* m_strategy;
    QPushButton* m_research;
    NetworkFiguresModel m_figures;
    NetworkModel* m_model = nullptr;
    QVariant m_shown; ///< id of the participant
};

} // namespace carina
