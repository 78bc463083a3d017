#include "ui/panels/session/strategy_dialog.h"

#include "ui/refusal_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/dialog_buttons.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

namespace carina
{
namespace
{

constexpr int kStrategyDialogWidth = 460;
constexpr int kSentenceLines = 4;
constexpr int kMostDelaysAsked = 1000;
constexpr double kSlowestProbesAsked = 0.1;
constexpr double kFastestProbesAsked = 20.0;

void setUp(QDoubleSpinBox& rate)
{
    rate.setRange(kSlowestProbesAsked, kFastestProbesAsked);
    rate.setDecimals(1);
    rate.setSuffix(StrategyDialog::tr(" /s"));
}

} // namespace

StrategyDialog::StrategyDialog(const StrategyChoice& choice, QWidget* parent)
    : QDialog{parent},
      m_strategy{new QComboBox},
      m_sentence{new PlainLabel},
      m_delays{new CheckedSpinBox},
      m_start{new CheckedDoubleSpinBox},
      m_lowest{new CheckedDoubleSpinBox},
      m_highest{new CheckedDoubleSpinBox},
      m_lag{new CheckedSpinBox}
{
    setWindowTitle(tr("For research: how shared objects are kept alike"));
    setMinimumWidth(kStrategyDialogWidth);
    for (const StrategyModel::Entry& entry : StrategyModel::entries())
        m_strategy->addItem(entry.name, static_cast<int>(entry.kind));
    m_strategy->setObjectName(QStringLiteral("strategy"));
    m_delays->setRange(1, kMostDelaysAsked);
    m_delays->setObjectName(QStringLiteral("delays"));
    for (CheckedDoubleSpinBox* rate : {m_start, m_lowest, m_highest})
        setUp(*rate);
    m_lag->setRange(0, static_cast<int>(kLongestLocalLag / std::chrono::milliseconds{1}));
    m_lag->setSuffix(tr(" ms"));
    m_lag->setObjectName(QStringLiteral("lag"));
    m_lag->setToolTip(tr("16 ms, one frame, are enough on a local network and within a city."));
    layOut();
    fill(choice);
    connect(m_strategy, &QComboBox::currentIndexChanged, this, &StrategyDialog::refresh);
    connect(m_lowest, &QDoubleSpinBox::valueChanged, this, &StrategyDialog::refresh);
    connect(m_highest, &QDoubleSpinBox::valueChanged, this, &StrategyDialog::refresh);
    refresh();
}

void StrategyDialog::layOut()
{
    m_sentence->setWordWrap(true);
    m_sentence->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_sentence->setMinimumHeight(kSentenceLines * fontMetrics().lineSpacing());
    auto* rows = new QFormLayout{this};
    rows->addRow(tr("&Strategy"), m_strategy);
    rows->addRow(m_sentence);
    rows->addRow(tr("ASA: &delays in its history (p)"), m_delays);
    rows->addRow(tr("ASA: &probes at first (γ₀)"), m_start);
    rows->addRow(tr("ASA: &lowest rate of probes"), m_lowest);
    rows->addRow(tr("ASA: &highest rate of probes"), m_highest);
    rows->addRow(tr("Lon&gest local lag"), m_lag);
    auto* refused = new RefusalLine;
    for (const CheckedSpinBox* box : {m_delays, m_lag})
        refused->watch(*box);
    for (const CheckedDoubleSpinBox* box : {m_start, m_lowest, m_highest})
        refused->watch(*box);
    rows->addRow(refused);
    auto* buttons = new QDialogButtonBox{QDialogButtonBox::Cancel};
    QPushButton* use = buttons->addButton(tr("&Use in this session"), QDialogButtonBox::AcceptRole);
    use->setObjectName(QStringLiteral("use"));
    use->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    rows->addRow(buttons);
    leadTabToCancel(*buttons, *use);
}

void StrategyDialog::fill(const StrategyChoice& choice)
{
    m_strategy->setCurrentIndex(m_strategy->findData(static_cast<int>(choice.kind)));
    m_delays->setValue(choice.asa.delays);
    m_lowest->setValue(choice.asa.lowest);
    m_highest->setValue(choice.asa.highest);
    m_start->setValue(choice.asa.start);
    m_lag->setValue(static_cast<int>(choice.longestLag / std::chrono::milliseconds{1}));
}

StrategyChoice StrategyDialog::choice() const
{
    return {.kind = static_cast<StrategyKind>(m_strategy->currentData().toInt()),
            .asa = {.delays = static_cast<std::uint16_t>(m_delays->value()),
                    .start = m_start->value(),
                    .lowest = m_lowest->value(),
                    .highest = m_highest->value()},
            .longestLag = std::chrono::milliseconds{m_lag->value()}};
}

void StrategyDialog::refresh()
{
    const StrategyKind kind = choice().kind;
    for (const StrategyModel::Entry& entry : StrategyModel::entries())
        if (entry.kind == kind)
            m_sentence->setText(entry.sentence);
    m_strategy->setAccessibleDescription(m_sentence->text());
    const bool isAsa = kind == StrategyKind::AsaAdaptive || kind == StrategyKind::AsaFixed;
    m_delays->setEnabled(kind == StrategyKind::AsaAdaptive);
    m_start->setEnabled(isAsa);
    m_lowest->setEnabled(isAsa);
    m_highest->setEnabled(isAsa);
    m_lag->setEnabled(kind == StrategyKind::LocalLag);
    // The first rate lies between the others, and the lowest below the highest.
    m_highest->setMinimum(m_lowest->value());
    m_start->setRange(m_lowest->value(), m_highest->value());
}

} // namespace carina
