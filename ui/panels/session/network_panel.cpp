#include "ui/panels/session/network_panel.h"

#include "ui/panels/session/strategy_dialog.h"
#include "widgets/history_plot.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr std::size_t kDelays = 100; ///< p of the delay history
constexpr int kRowGap = 4;           ///< pixels between rows, so that most figures are in sight

} // namespace

NetworkPanel::NetworkPanel(QWidget* parent)
    : QWidget{parent},
      m_participant{new QComboBox},
      m_curve{new QPushButton{tr("Curve")}},
      m_legend{new PlainLabel{tr("One-way delay, newest right; band: mean ± σ")}},
      m_plot{new HistoryPlot},
      m_table{new QTableView},
      m_strategy{new PlainLabel},
      m_research{new QPushButton{tr("For r&esearch…")}}
{
    layOut();
    setFocusProxy(m_participant);
    m_strategy->setObjectName(QStringLiteral("strategyShown"));
    m_strategy->setToolTip(tr("The strategy by which objects that people act on are kept alike"));
    m_curve->setObjectName(QStringLiteral("delayCurve"));
    m_curve->setAccessibleName(tr("One-way delays as a curve"));
    m_curve->setToolTip(tr("Shows the one-way delays as a curve, below their figures"));
    m_curve->setCheckable(true);
    connect(m_curve, &QPushButton::toggled, this, &NetworkPanel::unfold);
    m_research->setObjectName(QStringLiteral("research"));
    m_research->setToolTip(tr("Choose the strategy by which shared objects are kept alike"));
    connect(m_research, &QPushButton::clicked, this, &NetworkPanel::askStrategy);
    m_participant->setPlaceholderText(tr("Nobody else is here yet"));
    m_participant->setAccessibleName(tr("Participant whose network is shown"));
    m_plot->setUp(kDelays, tr("ms"), tr("Delays are not known yet"));
    m_plot->setAccessibleName(tr("One-way delays"));
    m_table->setAccessibleName(tr("Figures of the network"));
    m_table->setModel(&m_figures);
    m_table->setShowGrid(false);
    m_table->setTabKeyNavigation(false);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + kRowGap);
    m_table->horizontalHeader()->hide();
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setStretchLastSection(true);
}

void NetworkPanel::layOut()
{
    auto* label = new PlainLabel{tr("Networ&k to")};
    label->setBuddy(m_participant);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_participant, 1);
    row->addWidget(m_curve);
    m_legend->setWordWrap(true);
    m_legend->setToolTip(tr("One-way delay (latency): half the round-trip time. σ: its standard "
                            "deviation (jitter)"));
    auto* column = new QVBoxLayout{this};
    column->addLayout(row);
    column->addWidget(m_table, 1);
    column->addWidget(m_legend);
    column->addWidget(m_plot);
    auto* research = new QHBoxLayout;
    research->addWidget(m_strategy, 1);
    research->addWidget(m_research);
    column->addLayout(research);
    unfold();
}

void NetworkPanel::setModel(NetworkModel& model)
{
    m_model = &model;
    m_participant->setModel(&model);
    connect(&model, &NetworkModel::modelReset, this, &NetworkPanel::findShown);
    connect(&model, &NetworkModel::measured, this, &NetworkPanel::refresh);
    connect(m_participant, &QComboBox::activated, this, [this] {
        m_shown = m_participant->currentData(NetworkModel::kIdRole);
        refresh();
    });
    connect(&model.strategy(), &StrategyModel::changed, this, &NetworkPanel::showStrategy);
    findShown();
    refresh();
    showStrategy();
}

void NetworkPanel::showStrategy()
{
    m_strategy->setText(tr("Objects: %1").arg(m_model->strategy().chosenName()));
}

void NetworkPanel::askStrategy()
{
    auto* dialog = new StrategyDialog{m_model->strategy().chosen(), this};
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog] { m_model->strategy().choose(dialog->choice()); });
    dialog->open();
}

void NetworkPanel::findShown()
{
    const int row = m_participant->findData(m_shown, NetworkModel::kIdRole);
    m_participant->setCurrentIndex(row >= 0 ? row : m_model->newest());
    m_shown = m_participant->currentData(NetworkModel::kIdRole);
}

void NetworkPanel::choose(ParticipantId participant)
{
    m_shown = uint{participant.value};
    findShown();
    refresh();
}

void NetworkPanel::refresh()
{
    const auto figures = m_model->figures(m_participant->currentIndex());
    m_participant->setEnabled(figures.has_value());
    m_figures.show(figures);
    plot(figures.value_or(NetworkFigures{}));
}

void NetworkPanel::unfold()
{
    for (QWidget* ofCurve : {static_cast<QWidget*>(m_legend), static_cast<QWidget*>(m_plot)})
        ofCurve->setVisible(m_curve->isChecked() && m_curve->isEnabledTo(this));
}

void NetworkPanel::plot(const NetworkFigures& figures)
{
    m_curve->setEnabled(!figures.isOwn); // no path leads there
    unfold();
    std::optional<HistoryPlot::Band> band;
    if (figures.meanDelay_ms && figures.sigma_ms) {
        band = {*figures.meanDelay_ms, *figures.sigma_ms};
        m_plot->setAccessibleDescription(tr("%n delays, mean %1 ms, sigma %2 ms", nullptr,
                                            static_cast<int>(figures.delays_ms.size()))
                                             .arg(band->mean, 0, 'f', 2)
                                             .arg(band->sigma, 0, 'f', 2));
    } else {
        m_plot->setAccessibleDescription(tr("Delays are not known yet"));
    }
    m_plot->setHistory(figures.delays_ms, band);
}

} // namespace carina
