#include "ui/panels/breathing_panel.h"

#include "models/text/shown_as_is.h"
#include "ui_breathing_panel.h"

#include <QSignalBlocker>

namespace carina
{
namespace
{

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
    : QWidget{parent}, m_ui{std::make_unique<Ui::BreathingPanel>()}
{
    m_ui->setupUi(this);
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
    m_ui->travelling->setText(m_model->travellingText());
    m_ui->undo->setEnabled(m_model->canUndo());
}

} // namespace carina
