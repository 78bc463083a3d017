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

/// The network path to one participant: the delays as a curve, and all figures with their units.
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

    QComboBox* m_participant;
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
