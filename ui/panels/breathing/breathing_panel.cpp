#include "ui/panels/breathing/breathing_panel.h"

#include "models/text/shown_as_is.h"
#include "ui/refusal_line.h"
#include "ui_breathing_panel.h"
#include "widgets/plain_label.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>

namespace carina
{
namespace
{

constexpr std::array kStoppingTimes_s{0, 30, 60, 120, 300};
/// Below the least rate, the box says "none".
constexpr int kNoBag = int(inPerMinute(kSlowestBreathing)) - 1;

/// Shows a value without telling it back to the model; not while a person is typing into it.
void display(QSpinBox& box, double value)
{
    const QSignalBlocker blocker{box};
    if (!box.hasFocus() || box.cleanText().toInt() == box.value())
        box.setValue(qRound(value));
}

void display(QSlider& slider, double value)
{
    const QSignalBlocker blocker{slider};
    if (!slider.isSliderDown())
        slider.setValue(qRound(value));
}

} // namespace

BreathingPanel::BreathingPanel(QWidget* parent)
    : QWidget{parent},
      m_ui{std::make_unique<Ui::BreathingPanel>()},
      m_stops{new QCheckBox{tr("Breathing &stops")}},
      m_over{new QComboBox},
      m_left{new PlainLabel},
      m_bagRate{new CheckedSpinBox},
      m_bagVolume{new CheckedSpinBox},
      m_refused{new RefusalLine}
{
    m_ui->setupUi(this);
    addApnoea();
    addBag();
    for (const CheckedSpinBox* box : {m_ui->rate, m_ui->tidalVolume, m_bagRate, m_bagVolume})
        m_refused->watch(*box);
    m_refused->watch(*m_ui->ratio);
    m_ui->columns->insertWidget(m_ui->columns->indexOf(m_ui->travelling), m_refused);
    QWidget* before = m_ui->ratio;
    for (QWidget* next : {static_cast<QWidget*>(m_stops), static_cast<QWidget*>(m_over),
                          static_cast<QWidget*>(m_bagRate), static_cast<QWidget*>(m_bagVolume)}) {
        setTabOrder(before, next);
        before = next;
    }
}

void BreathingPanel::addApnoea()
{
    m_stops->setObjectName(QStringLiteral("stops"));
    m_stops->setAccessibleName(tr("The patient's own breathing stops"));
    m_stops->setToolTip(tr("Apnoea: the patient makes no breaths of their own. Untick it, and "
                           "breathing goes on. A ventilator or a bag goes on either way."));
    m_over->setObjectName(QStringLiteral("over"));
    m_over->setAccessibleName(tr("Time over which breathing stops or goes on"));
    for (const int seconds : kStoppingTimes_s)
        m_over->addItem(seconds == 0   ? tr("at once")
                        : seconds < 60 ? tr("over %1\u00a0s").arg(seconds)
                                       : tr("over %1\u00a0min").arg(seconds / 60));
    m_ui->rate->adviseBelow(tr("For apnoea, tick “Breathing stops”."));
    m_left->setObjectName(QStringLiteral("breathingLeft"));
    m_left->setAccessibleName(tr("What is left of the patient's own breathing"));
    m_left->hide();
    auto* row = new QHBoxLayout;
    row->addWidget(m_stops, 1);
    row->addWidget(m_over);
    const int place = m_ui->columns->indexOf(m_ui->travelling);
    m_ui->columns->insertLayout(place, row);
    m_ui->columns->insertWidget(place + 1, m_left);
}

void BreathingPanel::addBag()
{
    auto* label = new PlainLabel{tr("&Bag by hand")};
    label->setBuddy(m_bagRate);
    m_bagRate->setObjectName(QStringLiteral("bagRate"));
    m_bagRate->setAccessibleName(tr("Bag by hand, squeezes per minute; none below 4"));
    m_bagRate->setToolTip(tr("A bag squeezed by hand, in place of the ventilator: 4 to 60 times a "
                             "minute; below that, none"));
    m_bagRate->setRange(kNoBag, int(inPerMinute(kFastestBreathing)));
    m_bagRate->setSpecialValueText(tr("none"));
    m_bagRate->setSuffix(tr(" /min"));
    m_bagVolume->setObjectName(QStringLiteral("bagVolume"));
    m_bagVolume->setAccessibleName(tr("Volume of a squeeze of the bag, millilitres"));
    m_bagVolume->setToolTip(tr("Gas that a squeeze of the bag delivers"));
    m_bagVolume->setRange(int(inMillilitres(kSmallestTidalVolume)),
                          int(inMillilitres(kLargestTidalVolume)));
    m_bagVolume->setSingleStep(10);
    m_bagVolume->setSuffix(tr(" ml"));
    auto* row = new QHBoxLayout;
    row->addWidget(label, 1);
    for (CheckedSpinBox* box : {m_bagRate, m_bagVolume}) {
        box->setAlignment(Qt::AlignRight);
        row->addWidget(box);
    }
    m_ui->columns->insertLayout(m_ui->columns->indexOf(m_ui->travelling), row);
}

BreathingPanel::~BreathingPanel() = default;

void BreathingPanel::setModel(BreathingModel& model)
{
    m_model = &model;
    const auto sets = [this](BreathingParameter parameter) {
        return [this, parameter](auto value) { m_model->set(parameter, double(value)); };
    };
    connect(m_ui->rate, &QSpinBox::valueChanged, this, sets(BreathingParameter::Rate));
    connect(m_ui->rateSlider, &QSlider::valueChanged, this, sets(BreathingParameter::Rate));
    connect(m_ui->tidalVolume, &QSpinBox::valueChanged, this,
            sets(BreathingParameter::TidalVolume));
    connect(m_ui->tidalVolumeSlider, &QSlider::valueChanged, this,
            sets(BreathingParameter::TidalVolume));
    connect(m_ui->ratio, &QDoubleSpinBox::valueChanged, this, sets(BreathingParameter::Expiration));
    connect(m_stops, &QCheckBox::toggled, this, [this](bool stops) {
        const int over_s = kStoppingTimes_s[std::size_t(m_over->currentIndex())];
        m_model->setStoppingTime(std::chrono::seconds{over_s});
        m_model->set(BreathingParameter::Own, stops ? 0.0 : 1.0);
    });
    connect(m_bagRate, &QSpinBox::valueChanged, this, [this](int rate) {
        m_model->set(BreathingParameter::BagRate, rate == kNoBag ? 0.0 : double(rate));
    });
    connect(m_bagVolume, &QSpinBox::valueChanged, this, sets(BreathingParameter::BagVolume));
    connect(m_ui->undo, &QPushButton::clicked, &model, &BreathingModel::undo);
    connect(&model, &BreathingModel::changed, this, &BreathingPanel::refresh);
    refresh();
}

double BreathingPanel::shown(BreathingParameter parameter) const
{
    return m_model->pending(parameter).value_or(m_model->value(parameter));
}

void BreathingPanel::refresh()
{
    const int largest_ml = m_model->largestTidalVolume_ml();
    const QSignalBlocker box{m_ui->tidalVolume};
    const QSignalBlocker slider{m_ui->tidalVolumeSlider};
    m_ui->tidalVolume->setMaximum(largest_ml);
    m_ui->tidalVolumeSlider->setMaximum(largest_ml);
    m_ui->tidalVolume->setToolTip(
        shownAsIs(tr("Tidal volume: gas inspired in one breath; for this patient %1 to %2\u00a0ml")
                      .arg(m_ui->tidalVolume->minimum())
                      .arg(largest_ml)));
    display(*m_ui->rate, shown(BreathingParameter::Rate));
    display(*m_ui->rateSlider, shown(BreathingParameter::Rate));
    display(*m_ui->tidalVolume, shown(BreathingParameter::TidalVolume));
    display(*m_ui->tidalVolumeSlider, shown(BreathingParameter::TidalVolume));
    const QSignalBlocker blocker{m_ui->ratio};
    if (!m_ui->ratio->hasFocus())
        m_ui->ratio->setValue(shown(BreathingParameter::Expiration));
    refreshApnoea(largest_ml);
    m_ui->travelling->setText(m_model->travellingText());
    m_ui->undo->setVisible(!m_model->hasHistory()); // which has one for all panels
    m_ui->undo->setEnabled(m_model->canUndo());
}

void BreathingPanel::refreshApnoea(int largest_ml)
{
    const QSignalBlocker stops{m_stops};
    const QSignalBlocker rate{m_bagRate};
    const QSignalBlocker volume{m_bagVolume};
    m_stops->setChecked(shown(BreathingParameter::Own) == 0.0);
    m_bagVolume->setMaximum(largest_ml);
    const double squeezed = shown(BreathingParameter::BagRate);
    display(*m_bagRate, squeezed == 0.0 ? double(kNoBag) : squeezed);
    display(*m_bagVolume, shown(BreathingParameter::BagVolume));
    const double left = m_model->ownBreathing();
    m_left->setVisible(left < 1.0);
    m_left->setText(left == 0.0 ? tr("■ Apnoea: no breaths of the patient's own")
                                : tr("▲ Own breathing: %1\u00a0% left").arg(qRound(100.0 * left)));
}

} // namespace carina
