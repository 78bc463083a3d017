#pragma once

#include "models/respiration/breath_trace.h"

#include <QWidget>

class QLabel;

namespace carina
{

class WaveformPlot;

/// Flow, pressure and volume of the patient's breathing as a ventilator shows them, and the figures
/// of the last breath.
class WaveformPanel : public QWidget
{
    Q_OBJECT

public:
    explicit WaveformPanel(QWidget* parent = nullptr);

    /// @pre the trace outlives the panel.
    void setTrace(BreathTrace& trace);

private:
    void show(const BreathTrace::Sample& sample);
    void refreshFigures();

    BreathTrace* m_trace = nullptr;
    WaveformPlot* m_flow;
    WaveformPlot* m_pressure;
    WaveformPlot* m_volume;
    QLabel* m_figures;
};

} // namespace carina
