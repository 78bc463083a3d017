#include "ui/condition_panel.h"

#include "engine/core/units.h"
#include "models/respiration_words.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kSeveritySteps = 100; ///< of the slider
constexpr double kSeverityStep = 0.05;
constexpr int kTravellingLines = 3;
constexpr int kShownLetters = 12; ///< of a choice; its list is as wide as it has to be
constexpr double kTubeStep_mm = 0.5;

/// Shows a value without telling it back to the model; not while a person is typing into it.
void display(QDoubleSpinBox& box, double value)
{
    const QSignalBlocker blocker{box};
    if (!box.hasFocus() || box.cleanText() == box.textFromValue(box.value()))
        box.setValue(value);
}

void display(QComboBox& box, int place)
{
    const QSignalBlocker blocker{box};
    box.setCurrentIndex(place);
}

} // namespace

ConditionPanel::ConditionPanel(QWidget* parent)
    : QWidget{parent},
      m_obstacle{new QLabel},
      m_controls{new QWidget},
      m_condition{new QComboBox},
      m_severity{new QDoubleSpinBox},
      m_severitySlider{new QSlider{Qt::Horizontal}},
      m_side{new QComboBox},
      m_mode{new QComboBox},
      m_tube{new QDoubleSpinBox},
      m_travelling{new QLabel},
      m_undo{new QPushButton{tr("&Undo last change")}}
{
    layOut();
    offerChoices();
    setFocusProxy(m_condition);
}

void ConditionPanel::layOut()
{
    auto* rows = new QFormLayout{m_controls};
    rows->setContentsMargins({});
    rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const auto add = [rows](QWidget* field, const char* objectName, const QString& label,
                            const QString& accessibleName) {
        field->setObjectName(QLatin1String{objectName});
        field->setAccessibleName(accessibleName);
        if (label.isEmpty())
            rows->addRow(field);
        else
            rows->addRow(label, field);
    };
    add(m_condition, "condition", tr("&Condition"), tr("Condition of the lungs"));
    add(m_severity, "severity", tr("Se&verity"), tr("Severity of the condition, 0 to 1"));
    add(m_severitySlider, "severitySlider", {}, tr("Severity slider"));
    add(m_side, "side", tr("&Lung"), tr("Which lung the condition is of"));
    add(m_mode, "mode", tr("&Breathes"), tr("Who breathes the patient"));
    m_peep = addPressure(*rows, "peep", tr("PEEP"), tr("End-expiratory pressure, cmH2O"));
    m_driving = addPressure(*rows, "driving", tr("&Above PEEP"),
                            tr("Pressure of inspiration above PEEP, cmH2O"));
    m_limit =
        addPressure(*rows, "limit", tr("Limi&t"), tr("Highest pressure at the airway, cmH2O"));
    add(m_tube, "tube", tr("Tu&be"), tr("Inner diameter of the tracheal tube, millimetres"));
    m_travelling->setObjectName(QStringLiteral("travelling"));
    m_travelling->setWordWrap(true);
    m_travelling->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_travelling->setMinimumHeight(kTravellingLines * m_travelling->fontMetrics().lineSpacing());
    m_undo->setObjectName(QStringLiteral("undoCondition"));
    m_undo->setToolTip(tr("Sets what was changed last back (Alt+U)"));
    m_obstacle->setObjectName(QStringLiteral("obstacle"));
    m_obstacle->setWordWrap(true);
    auto* column = new QVBoxLayout{this};
    for (QWidget* widget : {static_cast<QWidget*>(m_obstacle), m_controls,
                            static_cast<QWidget*>(m_travelling), static_cast<QWidget*>(m_undo)})
        column->addWidget(widget);
    column->addStretch(1);
}

QDoubleSpinBox* ConditionPanel::addPressure(QFormLayout& rows, const char* objectName,
                                            const QString& label, const QString& accessibleName)
{
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QLatin1String{objectName});
    box->setAccessibleName(accessibleName);
    box->setSuffix(tr(" cmH2O"));
    box->setDecimals(0);
    box->setKeyboardTracking(false);
    box->setAlignment(Qt::AlignRight);
    rows.addRow(label, box);
    return box;
}

void ConditionPanel::offerChoices()
{
    for (const ConditionKind kind : kConditionKinds)
        m_condition->addItem(conditionText(kind));
    for (const ConditionSide side :
         {ConditionSide::Both, ConditionSide::Right, ConditionSide::Left})
        m_side->addItem(sideText(side));
    for (const VentilationMode mode : {VentilationMode::Spontaneous, VentilationMode::VolumeControl,
                                       VentilationMode::PressureControl})
        m_mode->addItem(modeText(mode));
    m_severity->setRange(0.0, 1.0);
    m_severity->setSingleStep(kSeverityStep);
    m_severitySlider->setRange(0, kSeveritySteps);
    m_severitySlider->setPageStep(kSeveritySteps / 10);
    m_peep->setRange(0.0, inCmH2O(kHighestPeep));
    m_driving->setRange(0.0, inCmH2O(kHighestDrivingPressure));
    m_limit->setRange(inCmH2O(kLowestPressureLimit), inCmH2O(kHighestPressureLimit));
    m_tube->setRange(inMillimetres(kNarrowestTube) - kTubeStep_mm, inMillimetres(kWidestTube));
    m_tube->setDecimals(1);
    m_tube->setSingleStep(kTubeStep_mm);
    m_tube->setSuffix(tr(" mm"));
    m_tube->setSpecialValueText(tr("none"));
    m_tube->setToolTip(tr("Inner diameter, 2 to 12 mm; below that, none"));
    for (QComboBox* box : {m_condition, m_side, m_mode}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kShownLetters);
    }
    for (QDoubleSpinBox* box : {m_severity, m_tube}) {
        box->setKeyboardTracking(false);
        box->setAlignment(Qt::AlignRight);
    }
}

void ConditionPanel::setModel(RespirationModel& model)
{
    m_model = &model;
    connectCondition();
    connectVentilator();
    connect(m_undo, &QPushButton::clicked, &model, &RespirationModel::undo);
    connect(&model, &RespirationModel::changed, this, &ConditionPanel::refresh);
    refresh();
}

void ConditionPanel::connectCondition()
{
    connect(m_condition, &QComboBox::activated, m_model,
            [this](int place) { m_model->choose(static_cast<ConditionKind>(place)); });
    connect(m_side, &QComboBox::activated, this, &ConditionPanel::setCondition);
    connect(m_severity, &QDoubleSpinBox::valueChanged, this, &ConditionPanel::setCondition);
    connect(m_severitySlider, &QSlider::valueChanged, m_severity,
            [this](int value) { m_severity->setValue(double(value) / kSeveritySteps); });
}

void ConditionPanel::connectVentilator()
{
    connect(m_mode, &QComboBox::activated, this, &ConditionPanel::setVentilator);
    for (QDoubleSpinBox* box : {m_peep, m_driving, m_limit})
        connect(box, &QDoubleSpinBox::valueChanged, this, &ConditionPanel::setVentilator);
    connect(m_tube, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        m_model->setTube(value < inMillimetres(kNarrowestTube) ? Length{} : millimetres(value));
    });
}

// Entries stand in the order of the enumerators.

void ConditionPanel::setCondition()
{
    m_model->setCondition({static_cast<ConditionKind>(m_condition->currentIndex()),
                           m_severity->value(),
                           static_cast<ConditionSide>(m_side->currentIndex())});
}

void ConditionPanel::setVentilator()
{
    VentilatorSettings settings = m_model->ventilator();
    settings.mode = static_cast<VentilationMode>(m_mode->currentIndex());
    settings.peep = cmH2O(m_peep->value());
    settings.drivingPressure = cmH2O(m_driving->value());
    settings.pressureLimit = cmH2O(m_limit->value());
    m_model->setVentilator(settings);
}

void ConditionPanel::refresh()
{
    const QString obstacle = m_model->obstacle();
    m_obstacle->setText(obstacle);
    m_obstacle->setVisible(!obstacle.isEmpty());
    m_controls->setEnabled(obstacle.isEmpty());
    const LungCondition condition = m_model->condition();
    const bool isIll = condition.kind != ConditionKind::Normal;
    display(*m_condition, static_cast<int>(condition.kind));
    display(*m_severity, condition.severity);
    display(*m_side, static_cast<int>(condition.side));
    const QSignalBlocker blocker{m_severitySlider};
    if (!m_severitySlider->isSliderDown())
        m_severitySlider->setValue(qRound(condition.severity * kSeveritySteps));
    for (QWidget* widget : {static_cast<QWidget*>(m_severity),
                            static_cast<QWidget*>(m_severitySlider), static_cast<QWidget*>(m_side)})
        widget->setEnabled(isIll);
    const VentilatorSettings ventilator = m_model->ventilator();
    display(*m_mode, static_cast<int>(ventilator.mode));
    display(*m_peep, inCmH2O(ventilator.peep));
    display(*m_driving, inCmH2O(ventilator.drivingPressure));
    display(*m_limit, inCmH2O(ventilator.pressureLimit));
    m_peep->setEnabled(ventilator.mode != VentilationMode::Spontaneous);
    m_driving->setEnabled(ventilator.mode == VentilationMode::PressureControl);
    m_limit->setEnabled(ventilator.mode == VentilationMode::VolumeControl);
    display(*m_tube, inMillimetres(m_model->tube()));
    m_travelling->setText(m_model->travellingText());
    m_undo->setEnabled(obstacle.isEmpty() && m_model->canUndo());
}

} // namespace carina
