#include "ui/panels/breathing/condition_panel.h"

#include "engine/core/units.h"
#include "models/respiration/respiration_words.h"
#include "models/text/shown_as_is.h"
#include "ui/refusal_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSlider>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kSeveritySteps = 100; ///< of the slider
constexpr double kSeverityStep = 0.05;
constexpr int kTravellingLines = 3;
constexpr int kConditionLines = 3;
constexpr int kFormGap = 3;       ///< pixels between the rows, so that a window of 800 holds them
constexpr int kShownLetters = 12; ///< of a choice; its list is as wide as it has to be
constexpr double kUsualOwnEffort = 0.5; ///< of a quiet breath's

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

void nameField(QWidget& field, const char* objectName, const QString& accessibleName)
{
    field.setObjectName(QLatin1String{objectName});
    field.setAccessibleName(accessibleName);
}

} // namespace

ConditionPanel::ConditionPanel(QWidget* parent)
    : QWidget{parent},
      m_obstacle{new PlainLabel},
      m_controls{new QWidget},
      m_position{new QComboBox},
      m_conditions{new QListWidget},
      m_add{new QPushButton{tr("&New")}},
      m_remove{new QPushButton{tr("&Remove")}},
      m_condition{new QComboBox},
      m_severity{new CheckedDoubleSpinBox},
      m_severitySlider{new QSlider{Qt::Horizontal}},
      m_side{new QComboBox},
      m_mode{new QComboBox},
      m_refused{new RefusalLine},
      m_travelling{new PlainLabel},
      m_undo{new QPushButton{tr("&Undo last change")}}
{
    layOut();
    offerChoices();
    offerList();
    setFocusProxy(m_condition);
}

void ConditionPanel::layOut()
{
    auto* rows = new QFormLayout{m_controls};
    rows->setContentsMargins({});
    rows->setVerticalSpacing(kFormGap);
    rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    const auto add = [rows](QWidget* field, const char* objectName, const QString& label,
                            const QString& accessibleName) {
        nameField(*field, objectName, accessibleName);
        rows->addRow(label, field);
    };
    add(m_position, "position", tr("Pos&ition"), tr("Position of the patient"));
    add(m_conditions, "conditions", tr("C&onditions"), tr("Conditions of the lungs, a list"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_add);
    buttons->addWidget(m_remove);
    rows->addRow(buttons);
    add(m_condition, "condition", tr("&Condition"), tr("Selected condition of the lungs"));
    addSeverity(*rows);
    add(m_side, "side", tr("&Lung"), tr("Side of the condition"));
    add(m_mode, "mode", tr("&Breathes"), tr("Ventilation: spontaneous, or by a ventilator"));
    const QString pressure = tr(" cmH2O");
    m_peep = addNumber(*rows, "peep", tr("PEEP"),
                       tr("Positive end-expiratory pressure (PEEP), cmH2O"), pressure);
    m_driving = addNumber(*rows, "driving", tr("Above PEEP"),
                          tr("Inspiratory pressure above PEEP, cmH2O"), pressure);
    m_limit =
        addNumber(*rows, "limit", tr("Limit"), tr("Pressure limit of the airway, cmH2O"), pressure);
    m_pause = addNumber(*rows, "pause", tr("Pau&se"),
                        tr("Pause at the end of inspiration, per cent of inspiration"), tr(" %"));
    m_ownRate =
        addNumber(*rows, "ownRate", tr("Own breaths"),
                  tr("Own efforts of a patient who is ventilated, per minute"), tr(" /min"));
    m_ownEffort = addNumber(*rows, "ownEffort", tr("Effort"),
                            tr("Strength of own efforts, per cent of a quiet breath's"), tr(" %"));
    m_trigger = addNumber(*rows, "trigger", tr("Trigger"),
                          tr("Flow trigger: inspiratory flow at which the ventilator begins a "
                             "breath, litres per minute"),
                          tr(" L/min"));
    explain();
    m_travelling->setObjectName(QStringLiteral("travelling"));
    m_travelling->setWordWrap(true);
    m_travelling->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_travelling->setMinimumHeight(kTravellingLines * m_travelling->fontMetrics().lineSpacing());
    m_undo->setObjectName(QStringLiteral("undoCondition"));
    m_undo->setToolTip(tr("Undoes the last change (Alt+U)"));
    m_obstacle->setObjectName(QStringLiteral("obstacle"));
    m_obstacle->setWordWrap(true);
    auto* column = new QVBoxLayout{this};
    for (QWidget* widget :
         {static_cast<QWidget*>(m_obstacle), m_controls, static_cast<QWidget*>(m_refused),
          static_cast<QWidget*>(m_travelling), static_cast<QWidget*>(m_undo)})
        column->addWidget(widget);
    column->addStretch(1);
}

void ConditionPanel::addSeverity(QFormLayout& rows)
{
    nameField(*m_severity, "severity", tr("Severity of the condition, 0 to 1"));
    nameField(*m_severitySlider, "severitySlider", tr("Severity slider"));
    auto* row = new QHBoxLayout;
    row->addWidget(m_severitySlider, 1);
    row->addWidget(m_severity);
    auto* label = new PlainLabel{tr("Se&verity")};
    label->setBuddy(m_severity);
    rows.addRow(label, row);
}

void ConditionPanel::offerList()
{
    m_add->setObjectName(QStringLiteral("addCondition"));
    m_add->setAccessibleName(tr("Add another condition"));
    m_add->setToolTip(tr("Adds another condition, and selects it (Alt+N)"));
    m_remove->setObjectName(QStringLiteral("removeCondition"));
    m_remove->setAccessibleName(tr("Remove the selected condition"));
    m_remove->setToolTip(tr("Removes the selected condition (Alt+R, or Delete in the list)"));
    m_conditions->setFixedHeight(kConditionLines * m_conditions->fontMetrics().lineSpacing()
                                 + 2 * m_conditions->frameWidth());
    m_conditions->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_conditions->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_conditions->setToolTip(tr("All conditions of the lungs at once. The controls below change "
                                "the one that is selected"));
}

void ConditionPanel::explain()
{
    m_mode->setToolTip(tr("Spontaneous: the patient's own muscles. Volume control: the ventilator "
                          "delivers the tidal volume at constant flow. Pressure control: it holds "
                          "a pressure above PEEP during inspiration."));
    m_peep->setToolTip(tr("PEEP: the pressure that the ventilator keeps in the airway at the end "
                          "of expiration"));
    m_driving->setToolTip(tr("Inspiratory pressure above PEEP, in pressure control"));
    m_limit->setToolTip(tr("The ventilator ends inspiration at this airway pressure"));
    m_pause->setToolTip(tr("Part of inspiration without flow, after which the plateau pressure is "
                           "measured"));
    m_trigger->setToolTip(tr("Inspiratory flow of the patient at which the ventilator begins a "
                             "breath"));
    m_severity->setToolTip(tr("0 is healthy; 0.3 mild, 0.6 moderate, 0.9 severe"));
}

CheckedDoubleSpinBox* ConditionPanel::addNumber(QFormLayout& rows, const char* objectName,
                                                const QString& label, const QString& accessibleName,
                                                const QString& unit)
{
    auto* box = new CheckedDoubleSpinBox;
    nameField(*box, objectName, accessibleName);
    box->setSuffix(unit);
    box->setDecimals(0);
    box->setAlignment(Qt::AlignRight);
    rows.addRow(label, box);
    return box;
}

void ConditionPanel::offerChoices()
{
    for (const BodyPosition position : kBodyPositions)
        m_position->addItem(positionText(position));
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
    m_pause->setRange(0.0, 100.0 * kLongestPause);
    m_pause->setSingleStep(5.0);
    m_ownRate->setRange(inPerMinute(kSlowestBreathing) - 1.0, inPerMinute(kFastestBreathing));
    m_ownRate->setSpecialValueText(tr("none"));
    m_ownEffort->setRange(0.0, 100.0 * kStrongestEffort);
    m_ownEffort->setSingleStep(10.0);
    m_trigger->setRange(0.0, inLitresPerMinute(kLargestTrigger));
    m_trigger->setSpecialValueText(tr("none"));
    for (QComboBox* box : {m_position, m_condition, m_side, m_mode}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(kShownLetters);
    }
    m_severity->setAlignment(Qt::AlignRight);
    for (const CheckedDoubleSpinBox* box :
         {m_severity, m_peep, m_driving, m_limit, m_pause, m_ownRate, m_ownEffort, m_trigger})
        m_refused->watch(*box);
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
    connect(m_position, &QComboBox::activated, m_model,
            [this](int place) { m_model->setPosition(static_cast<BodyPosition>(place)); });
    connect(m_conditions, &QListWidget::currentRowChanged, this, &ConditionPanel::refreshSelected);
    connect(m_add, &QPushButton::clicked, this, &ConditionPanel::addCondition);
    const auto remove = [this] { m_model->removeCondition(place()); };
    connect(m_remove, &QPushButton::clicked, m_model, remove);
    auto* deleted =
        new QShortcut{QKeySequence::Delete, m_conditions, nullptr, nullptr, Qt::WidgetShortcut};
    connect(deleted, &QShortcut::activated, m_model, remove);
    connect(m_condition, &QComboBox::activated, this, [this](int kind) {
        const std::size_t chosen = place();
        if (kind == static_cast<int>(ConditionKind::Normal)) {
            m_isAdding = true;
            selectRow(-1);
        }
        m_model->choose(chosen, static_cast<ConditionKind>(kind));
    });
    connect(m_side, &QComboBox::activated, this, &ConditionPanel::setCondition);
    connect(m_severity, &QDoubleSpinBox::valueChanged, this, &ConditionPanel::setCondition);
    connect(m_severitySlider, &QSlider::valueChanged, m_severity,
            [this](int value) { m_severity->setValue(double(value) / kSeveritySteps); });
}

void ConditionPanel::connectVentilator()
{
    connect(m_mode, &QComboBox::activated, this, [this](int place) {
        VentilatorSettings settings = m_model->ventilator();
        settings.mode = static_cast<VentilationMode>(place);
        m_model->setVentilator(settings);
    });
    const auto vary = [this](CheckedDoubleSpinBox* box, void (*set)(VentilatorSettings&, double)) {
        connect(box, &QDoubleSpinBox::valueChanged, this, [this, set](double value) {
            VentilatorSettings settings = m_model->ventilator();
            set(settings, value);
            m_model->setVentilator(settings);
        });
    };
    vary(m_peep, [](VentilatorSettings& s, double value) { s.peep = cmH2O(value); });
    vary(m_driving, [](VentilatorSettings& s, double value) { s.drivingPressure = cmH2O(value); });
    vary(m_limit, [](VentilatorSettings& s, double value) { s.pressureLimit = cmH2O(value); });
    vary(m_pause, [](VentilatorSettings& s, double value) { s.pauseShare = 0.01 * value; });
    vary(m_ownEffort, [](VentilatorSettings& s, double value) { s.ownEffort = 0.01 * value; });
    vary(m_trigger,
         [](VentilatorSettings& s, double value) { s.trigger = litresPerMinute(value); });
    vary(m_ownRate, [](VentilatorSettings& s, double value) {
        const bool isNone = value < inPerMinute(kSlowestBreathing);
        s.ownRate = isNone ? Frequency{} : perMinute(value);
        s.ownEffort = isNone ? 0.0 : s.ownEffort > 0.0 ? s.ownEffort : kUsualOwnEffort;
    });
}

/// Of the selected condition; where none is, of one that would be added.
std::size_t ConditionPanel::place() const
{
    const int row = m_conditions->currentRow();
    return row < 0 ? m_model->conditions().size() : static_cast<std::size_t>(row);
}

void ConditionPanel::selectRow(int row)
{
    const QSignalBlocker blocker{m_conditions};
    m_conditions->setCurrentRow(row);
}

// Entries stand in the order of the enumerators.

void ConditionPanel::setCondition()
{
    m_model->setCondition(place(), {static_cast<ConditionKind>(m_condition->currentIndex()),
                                    m_severity->value(),
                                    static_cast<ConditionSide>(m_side->currentIndex())});
}

/// Adds the first kind that the patient does not have; its kind is what is chosen next.
void ConditionPanel::addCondition()
{
    const std::size_t last = m_model->conditions().size();
    const auto isFree = [&](ConditionKind kind) {
        return kind != ConditionKind::Normal && m_model->canChoose(last, kind);
    };
    const auto kind = std::ranges::find_if(kConditionKinds, isFree);
    if (kind == kConditionKinds.end())
        return;
    m_model->choose(last, *kind);
    m_conditions->setCurrentRow(static_cast<int>(last));
    m_condition->setFocus();
}

void ConditionPanel::refreshConditions()
{
    const LungConditions conditions = m_model->conditions();
    const int count = static_cast<int>(conditions.size());
    const bool isMore = count > m_conditions->count();
    const QSignalBlocker blocker{m_conditions};
    while (m_conditions->count() > count)
        delete m_conditions->takeItem(m_conditions->count() - 1);
    while (m_conditions->count() < count)
        m_conditions->addItem(QString{});
    for (int row = 0; row < count; ++row) {
        const QString text = conditionText(conditions[std::size_t(row)]);
        m_conditions->item(row)->setText(text);
        m_conditions->item(row)->setToolTip(
            shownAsIs(tr("%1 (0 is healthy, 1 the most severe)").arg(text)));
    }
    if (m_conditions->currentRow() < 0 && (isMore || !m_isAdding)) {
        m_conditions->setCurrentRow(m_isAdding ? count - 1 : 0);
        m_isAdding = false;
    }
    m_add->setEnabled(conditions.size() < kMostConditions);
    m_remove->setEnabled(count > 0);
    refreshSelected();
}

void ConditionPanel::refreshSelected()
{
    const LungConditions conditions = m_model->conditions();
    const bool isIll = place() < conditions.size();
    const LungCondition condition = isIll ? conditions[place()] : LungCondition{};
    display(*m_condition, static_cast<int>(condition.kind));
    display(*m_severity, condition.severity);
    display(*m_side, static_cast<int>(condition.side));
    const QSignalBlocker blocker{m_severitySlider};
    if (!m_severitySlider->isSliderDown())
        m_severitySlider->setValue(qRound(condition.severity * kSeveritySteps));
    for (QWidget* widget : {static_cast<QWidget*>(m_severity),
                            static_cast<QWidget*>(m_severitySlider), static_cast<QWidget*>(m_side)})
        widget->setEnabled(isIll);
    auto* kinds = qobject_cast<QStandardItemModel*>(m_condition->model());
    for (const ConditionKind kind : kConditionKinds)
        kinds->item(static_cast<int>(kind))->setEnabled(m_model->canChoose(place(), kind));
}

void ConditionPanel::refresh()
{
    const QString obstacle = m_model->obstacle();
    m_obstacle->setText(obstacle);
    m_obstacle->setVisible(!obstacle.isEmpty());
    m_controls->setEnabled(obstacle.isEmpty());
    display(*m_position, static_cast<int>(m_model->position()));
    refreshConditions();
    refreshVentilator(m_model->ventilator());
    m_travelling->setText(m_model->travellingText());
    m_undo->setVisible(!m_model->hasHistory()); // which has one for all panels
    if (m_model->hasHistory()) // nothing stands beneath it that more lines would move
        m_travelling->setMinimumHeight(m_travelling->fontMetrics().lineSpacing());
    m_undo->setEnabled(obstacle.isEmpty() && m_model->canUndo());
}

void ConditionPanel::refreshVentilator(const VentilatorSettings& ventilator)
{
    const bool isVentilated = ventilator.mode != VentilationMode::Spontaneous;
    const bool isByVolume = ventilator.mode == VentilationMode::VolumeControl;
    display(*m_mode, static_cast<int>(ventilator.mode));
    // A limit below PEEP would drive no breath, and is refused.
    const QSignalBlocker peep{m_peep};
    const QSignalBlocker limit{m_limit};
    m_peep->setMaximum(std::min(inCmH2O(kHighestPeep), inCmH2O(ventilator.pressureLimit) - 1.0));
    m_limit->setMinimum(std::max(inCmH2O(kLowestPressureLimit), inCmH2O(ventilator.peep) + 1.0));
    display(*m_peep, inCmH2O(ventilator.peep));
    display(*m_driving, inCmH2O(ventilator.drivingPressure));
    display(*m_limit, inCmH2O(ventilator.pressureLimit));
    display(*m_pause, 100.0 * ventilator.pauseShare);
    display(*m_ownRate, inPerMinute(ventilator.ownRate));
    display(*m_ownEffort, 100.0 * ventilator.ownEffort);
    display(*m_trigger, inLitresPerMinute(ventilator.trigger));
    for (CheckedDoubleSpinBox* box : {m_peep, m_ownRate, m_trigger})
        box->setEnabled(isVentilated);
    m_driving->setEnabled(ventilator.mode == VentilationMode::PressureControl);
    m_limit->setEnabled(isByVolume);
    m_pause->setEnabled(isByVolume);
    m_ownEffort->setEnabled(isVentilated && ventilator.ownRate.si > 0.0);
}

} // namespace carina
