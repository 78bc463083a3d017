#include "ui/panels/breathing/waveform_panel.h"

#include "models/text/shown_as_is.h"
#include "widgets/plain_label.h"
#include "widgets/waveform_plot.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <array>
#include <cmath>

namespace carina
{
namespace
{

constexpr std::array kSweeps_s{6.0, 12.0, 30.0};
constexpr int kUsualSweep = 1; ///< of these
constexpr double kSweep_s = kSweeps_s[kUsualSweep];
constexpr double kLeastFlow_lPerMin = 20.0;
constexpr double kLeastPressure_cmH2O = 10.0;
constexpr double kLeastVolume_ml = 200.0;
constexpr int kFiguresInterval_ms = 500;
constexpr int kFigureLines = 3;    ///< at the console's least width
constexpr int kFiguresWidth = 300; // pixels

/// What rounds to nothing has no sign.
QString rounded(double value, int decimals)
{
    const double power = std::pow(10.0, decimals);
    return QString::number(std::round(power * value) / power + 0.0, 'f', decimals);
}

/// A value at the last mark and, where there is another one, how it differs from that.
QString noteOf(double value, std::optional<double> before, int decimals)
{
    const QString now = rounded(value, decimals);
    if (!before)
        return now;
    const QString between = rounded(value - *before, decimals);
    const bool isMore = value > *before && between != rounded(0.0, decimals);
    return WaveformPanel::tr("%1 (%2)", "value at a mark; its difference from the mark before")
        .arg(now, isMore ? QLatin1Char{'+'} + between : between);
}

QString allOf(double flow_lPerMin, double pressure_cmH2O, double volume_ml)
{
    return WaveformPanel::tr("%1\u00a0L/min, %2\u00a0cmH2O, %3\u00a0ml")
        .arg(rounded(flow_lPerMin, 1), rounded(pressure_cmH2O, 1), rounded(volume_ml, 0));
}

} // namespace

WaveformPanel::WaveformPanel(QWidget* parent)
    : QWidget{parent},
      m_flow{new WaveformPlot},
      m_pressure{new WaveformPlot},
      m_volume{new WaveformPlot},
      m_figures{new PlainLabel},
      m_sweep{new QComboBox},
      m_freeze{new QToolButton},
      m_measured{new PlainLabel}
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
        "Of the last breath: tidal volume (gas of one breath, and what of it went to each side: "
        "into the lung, and through a tear into the space around it), breathing rate, peak "
        "pressure "
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
    addControls();
    auto* row = new QHBoxLayout;
    row->addWidget(m_sweep);
    row->addWidget(m_freeze);
    row->addWidget(m_measured, 1);
    column->addLayout(row);
    for (WaveformPlot* plot : {m_flow, m_pressure, m_volume})
        column->addWidget(plot, 1);
    column->addWidget(m_figures);
}

void WaveformPanel::addControls()
{
    m_sweep->setObjectName(QStringLiteral("sweep"));
    m_sweep->setAccessibleName(tr("Time across the curves"));
    m_sweep->setToolTip(tr("Time across the curves, seconds"));
    for (const double sweep_s : kSweeps_s)
        m_sweep->addItem(tr("%1\u00a0s").arg(sweep_s));
    m_sweep->setCurrentIndex(kUsualSweep);
    m_freeze->setObjectName(QStringLiteral("freeze"));
    m_freeze->setText(tr("■ Fro&zen"));
    m_freeze->ensurePolished();
    m_freeze->setMinimumWidth(m_freeze->sizeHint().width()); // nothing beside it moves
    m_freeze->setText(tr("Free&ze"));
    m_freeze->setCheckable(true);
    m_freeze->setAccessibleName(tr("Freeze the curves to measure them"));
    m_freeze->setToolTip(tr("Holds the curves. Click two places in them, or use the left and right "
                            "arrow keys in a curve, to read values and what lies between them."));
    m_measured->setObjectName(QStringLiteral("measured"));
    m_measured->setAccessibleName(tr("Values at the places pointed at"));
    m_measured->setWordWrap(true);
    connect(m_sweep, &QComboBox::currentIndexChanged, this, [this](int chosen) {
        for (WaveformPlot* plot : {m_flow, m_pressure, m_volume})
            plot->setSpan(kSweeps_s[std::size_t(chosen)]);
    });
    connect(m_freeze, &QToolButton::toggled, this, &WaveformPanel::freeze);
    for (WaveformPlot* plot : {m_flow, m_pressure, m_volume})
        connect(plot, &WaveformPlot::pointedAt, this, &WaveformPanel::measure);
}

void WaveformPanel::freeze(bool frozen)
{
    m_from.reset();
    m_to.reset();
    m_freeze->setText(frozen ? tr("■ Fro&zen") : tr("Free&ze"));
    for (WaveformPlot* plot : {m_flow, m_pressure, m_volume})
        plot->setFrozen(frozen);
    showMeasured();
}

/// A step to the next value goes on with the last place; any other begins a new one.
void WaveformPanel::measure(double time_s)
{
    constexpr double kStep_s = 0.25;
    for (WaveformPlot* plot : {m_flow, m_pressure, m_volume})
        plot->setCursor(time_s);
    const auto valueOf = [](const WaveformPlot& plot) {
        const auto value = plot.atCursor();
        return value ? value->value : 0.0;
    };
    if (m_to && std::abs(m_to->time_s - time_s) > kStep_s)
        m_from = m_to;
    m_to = {time_s, valueOf(*m_flow), valueOf(*m_pressure), valueOf(*m_volume)};
    for (WaveformPlot* plot : {m_flow, m_pressure, m_volume})
        plot->setMark(m_from ? std::optional{m_from->time_s} : std::nullopt);
    showMeasured();
}

/// In the lines that are there anyway: those of the titles have room for the numbers.
void WaveformPanel::showMeasured()
{
    showNotes();
    QString text;
    QString all;
    if (m_freeze->isChecked())
        text = m_to ? tr("Point at another place to compare") : tr("Point at a place in a curve");
    if (m_to)
        all = allOf(m_to->flow_lPerMin, m_to->pressure_cmH2O, m_to->volume_ml);
    if (m_to && m_from) {
        const QString seconds = rounded(m_to->time_s - m_from->time_s, 2);
        text = tr("In brackets: between the marks, %1\u00a0s").arg(seconds);
        all = tr("%1; between the marks: %2\u00a0s, %3", "values; seconds; differences")
                  .arg(all, seconds,
                       allOf(m_to->flow_lPerMin - m_from->flow_lPerMin,
                             m_to->pressure_cmH2O - m_from->pressure_cmH2O,
                             m_to->volume_ml - m_from->volume_ml));
    }
    m_measured->setText(text);
    m_measured->setAccessibleDescription(all);
    m_measured->setToolTip(shownAsIs(all));
}

void WaveformPanel::showNotes()
{
    const auto write = [this](WaveformPlot& plot, double BreathTrace::Sample::*value,
                              int decimals) {
        const auto before = m_from ? std::optional{(*m_from).*value} : std::nullopt;
        plot.setNote(m_to ? noteOf((*m_to).*value, before, decimals) : QString{});
    };
    write(*m_flow, &BreathTrace::Sample::flow_lPerMin, 1);
    write(*m_pressure, &BreathTrace::Sample::pressure_cmH2O, 1);
    write(*m_volume, &BreathTrace::Sample::volume_ml, 0);
}

void WaveformPanel::setTrace(BreathTrace& trace)
{
    m_trace = &trace;
    connect(&trace, &BreathTrace::sampled, this, &WaveformPanel::show);
    connect(&trace, &BreathTrace::startedAfresh, this, [this] {
        m_freeze->setChecked(false); // what was measured is of another patient
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
        m_figures->setText(m_trace->hasStopped() ? tr("No breathing") : tr("No whole breath yet"));
        return;
    }
    const auto whole = [](double value) { return QString::number(qRound(value)); };
    // Rounded first: what rounds to nothing has no sign.
    const auto tenths = [](double value) {
        return QString::number(qRound(10.0 * value) / 10.0, 'f', 1);
    };
    const BreathTrace::WholeBreath inWhole = BreathTrace::inWhole(*breath);
    // Numbers stay with their names and units where a line ends.
    QStringList told{tr("Breath\u00a0%1\u00a0ml (right\u00a0%2, left\u00a0%3)")
                         .arg(inWhole.tidalVolume_ml)
                         .arg(inWhole.right_ml)
                         .arg(inWhole.left_ml),
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
