#pragma once

#include "models/respiration/breath_trace.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QToolButton;

namespace carina
{

class WaveformPlot;

/// Flow, pressure and volume of the patient's breathing as a ventilator shows them, and the figures
/// of the last breath. A sweep takes 6, 12 or 30 s. Frozen, the curves can be measured: the last
/// two places pointed at, in any curve, are marked, and above each curve stands its value at the
/// last one and, in brackets, how it differs from that at the other.
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
    void addControls();
    void freeze(bool frozen);
    void measure(double time_s);
    void showMeasured();
    void showNotes();

    BreathTrace* m_trace = nullptr;
    WaveformPlot* m_flow;
    WaveformPlot* m_pressure;
    WaveformPlot* m_volume;
    QLabel* m_figures;
    QComboBox* m_sweep;
    QToolButton* m_freeze;
    QLabel* m_measured;
    std::optional<BreathTrace::Sample> m_from; ///< the place pointed at before the last
    std::optional<BreathTrace::Sample> m_to;
};

} // namespace carina
