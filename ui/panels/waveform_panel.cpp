#include "ui/panels/waveform_panel.h"

#include "widgets/plain_label.h"
#include "widgets/waveform_plot.h"

#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr double kSweep_s = 12.0;
constexpr double kLeastFlow_lPerMin = 20.0;
constexpr double kLeastPressure_cmH2O = 10.0;
constexpr double kLeastVolume_ml = 200.0;
constexpr int kFiguresInterval_ms = 500;
constexpr int kFigureLines = 3;    ///< at the console's least width
constexpr int kFiguresWidth = 300; // pixels

} // namespace

WaveformPanel::WaveformPanel(QWidget* parent)
    : QWidget{parent},
      m_flow{new WaveformPlot},
      m_pressure{new WaveformPlot},
      m_volume{new WaveformPlot},
      m_figures{new PlainLabel}
{
    m_flow->setUp(tr("Flow"), tr("L/min"), kSweep_s, kLeastFlow_lPerMin, {});
    m_flow->setAccessibleName(tr("Flow into the patient, litres per minute"));
    m_pressure->setUp(tr("Airway pressure"), tr("cmH2O"), kSweep_s, kLeastPressure_cmH2O, {});
    m_pressure->setAccessibleName(tr("Pressure at the airway's opening, cmH2O"));
    m_volume->setUp(tr("Volume"), tr("ml"), kSweep_s, kLeastVolume_ml, tr("s"));
    m_volume->setAccessibleName(tr("Volume inspired since the breath began, millilitres"));
    m_figures->setObjectName(QStringLiteral("figures"));
    m_figures->setAccessibleName(tr("Figures of the last breath"));
    m_figures->setToolTip(tr(
        "Of the last breath: tidal volume (gas of one breath), breathing rate, peak pressure "
        "(highest at the airway opening), plateau pressure (at the end of inspiration without "
        "flow), auto‑PEEP (pressure of trapped gas at the end of expiration, above PEEP), "
        "alveolar ventilation (gas that reaches the alveoli in a minute), FRC (functional residual "
        "capacity: gas that stays in both lungs at the end of a quiet expiration)"));
    m_figures->setWordWrap(true);
    m_figures->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_figures->setMinimumWidth(kFiguresWidth); // in which they have so many lines
    m_figures->setMinimumHeight(kFigureLines * m_figures->fontMetrics().lineSpacing());
    auto* column = new QVBoxLayout{this};
    column->setSpacing(0);
    for (WaveformPlot* plot : {m_flow, m_pressure, m_volume})
        column->addWidget(plot, 1);
    column->addWidget(m_figures);
}

void WaveformPanel::setTrace(BreathTrace& trace)
{
    m_trace = &trace;
    connect(&trace, &BreathTrace::sampled, this, &WaveformPanel::show);
    connect(&trace, &BreathTrace::startedAfresh, this, [this] {
        for (WaveformPlot* plot : {m_flow, m_pressure, m_volume})
            plot->clear();
        refreshFigures();
    });
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &WaveformPanel::refreshFigures);
    timer->start(kFiguresInterval_ms);
    refreshFigures();
}

void WaveformPanel::show(const BreathTrace::Sample& sample)
{
    m_flow->add(sample.time_s, sample.flow_lPerMin);
    m_pressure->add(sample.time_s, sample.pressure_cmH2O);
    m_volume->add(sample.time_s, sample.volume_ml);
}

void WaveformPanel::refreshFigures()
{
    const auto breath = m_trace->lastBreath();
    if (!breath) {
        m_figures->setText(tr("No whole breath yet"));
        return;
    }
    const auto whole = [](double value) { return QString::number(qRound(value)); };
    // Rounded first: what rounds to nothing has no sign.
    const auto tenths = [](double value) {
        return QString::number(qRound(10.0 * value) / 10.0, 'f', 1);
    };
    // Numbers stay with their names and units where a line ends.
    QStringList told{
        tr("Breath\u00a0%1\u00a0ml (right\u00a0%2, left\u00a0%3)")
            .arg(whole(breath->tidalVolume_ml), whole(breath->right_ml), whole(breath->left_ml)),
        tr("%1\u00a0/min").arg(tenths(breath->rate_perMin))};
    if (breath->airway)
        told += tr("peak\u00a0%1, plateau\u00a0%2\u00a0cmH2O")
                    .arg(tenths(breath->airway->peak_cmH2O), tenths(breath->airway->plateau_cmH2O));
    told += tr("auto\u2011PEEP\u00a0%1\u00a0cmH2O").arg(tenths(breath->autoPeep_cmH2O));
    told += tr("alveolar\u00a0%1\u00a0L/min").arg(tenths(breath->alveolarVentilation_lPerMin));
    told += tr("FRC\u00a0%1\u00a0ml").arg(whole(breath->functionalResidual_ml));
    m_figures->setText(told.join(QStringLiteral("   ")));
}

} // namespace carina
