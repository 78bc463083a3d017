#include "ui/panels/airway/airway_panel.h"

#include "models/airway/airway_groups.h"
#include "models/airway/airway_presets.h"
#include "models/airway/airway_words.h"
#include "models/text/shown_as_is.h"
#include "ui/panels/airway/airway_group_bar.h"
#include "ui/panels/airway/head_position_row.h"
#include "ui/refusal_line.h"
#include "widgets/checked_spin_box.h"
#include "widgets/elided_label.h"
#include "widgets/plain_label.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace carina
{
namespace
{

constexpr int kSeverityStep_percent = 10;
constexpr int kMostPercent = 100;
constexpr int kChangeStep_s = 5;
// Pixels, so that a window of 800 holds any group below all headings.
constexpr int kEventGap = 2;
constexpr int kEdge = 4;     ///< above and below all
constexpr int kSide = 6;     ///< to the left and right of all
constexpr int kLowFrame = 6; ///< around the words of a control: 25 high with 12 points
constexpr int kPresetLetters = 16;
constexpr int kLeastSlider = 40; ///< pixels, so that the console's column holds a row

std::size_t placeOf(AirwayEventKind kind) { return static_cast<std::size_t>(kind); }

/// The longest stands in two lines.
QString labelOf(AirwayEventKind kind)
{
    return kind == AirwayEventKind::ExternalPressure
               ? AirwayPanel::tr("Pressure on the\nlarynx (BURP)")
               : eventText(kind);
}

QString textOfPresent(int percent) { return AirwayPanel::tr("now %1\u00a0%").arg(percent); }

QString textOfDrawn(int percent) { return AirwayPanel::tr("drawn %1\u00a0%").arg(percent); }

int percentOf(double severity) { return qRound(100.0 * severity); }

/// Shows a severity without telling it back to the model; not while a person is typing into it.
void showSeverity(CheckedSpinBox& box, int percent)
{
    const QSignalBlocker blocker{box};
    if (!box.hasFocus() || box.cleanText().toInt() == box.value())
        box.setValue(percent);
}

void showSeverity(QSlider& slider, int percent)
{
    const QSignalBlocker blocker{slider};
    if (!slider.isSliderDown())
        slider.setValue(percent);
}

void makeLow(QWidget& control)
{
    control.setProperty("isLow", true); // a button gets less padding by the style sheet
    control.setFixedHeight(control.fontMetrics().lineSpacing() + kLowFrame);
}

/// Where there is nothing to say it takes no room.
void sayOrHide(QLabel& label, const QString& text)
{
    label.setText(text);
    label.setVisible(!text.isEmpty());
}

/// As they are offered.
std::vector<AirwayEventKind> kindsByGroup()
{
    std::vector<AirwayEventKind> kinds;
    for (const AirwayGroup& group : airwayGroups())
        kinds.insert(kinds.end(), group.kinds.begin(), group.kinds.end());
    return kinds;
}

} // namespace

AirwayPanel::AirwayPanel(QWidget* parent)
    : QWidget{parent},
      m_obstacle{new PlainLabel},
      m_notShown{new PlainLabel},
      m_controls{new QWidget},
      m_presets{new QComboBox},
      m_condition{new PlainLabel},
      m_over{new CheckedSpinBox},
      m_head{new HeadPositionRow},
      m_groups{new AirwayGroupBar},
      m_events{new QWidget},
      m_suction{new QPushButton{tr("Suction of all fluids")}},
      m_clear{new QPushButton{tr("&Clear airway")}},
      m_refused{new RefusalLine},
      m_travelling{new ElidedLabel}
{
    layOut();
    m_refused->watch(*m_over);
    for (const Row& row : m_rows)
        m_refused->watch(*row.severity);
    connect(m_groups, &AirwayGroupBar::chosenByHand, this, [this] {
        showRows();
        if (m_events->isAncestorOf(focusProxy())) // the first event of the group
            focusProxy()->setFocus(Qt::TabFocusReason);
        Q_EMIT groupChosen(m_groups->chosen());
    });
    showRows();
}

void AirwayPanel::layOut()
{
    auto* controls = new QVBoxLayout{m_controls};
    controls->setContentsMargins({});
    controls->setSpacing(kEventGap);
    addPresets(*controls);
    addTimeAndClear(*controls);
    controls->addWidget(m_head);
    addRows();
    m_travelling->setObjectName(QStringLiteral("airwayTravelling"));
    m_groups->addBehind(*m_travelling);
    m_obstacle->setObjectName(QStringLiteral("airwayObstacle"));
    m_obstacle->setWordWrap(true);
    m_notShown->setObjectName(QStringLiteral("airwayNotShown"));
    m_notShown->setWordWrap(true);
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins(kSide, kEdge, kSide, kEdge);
    column->setSpacing(kEventGap);
    for (QWidget* widget :
         {static_cast<QWidget*>(m_obstacle), static_cast<QWidget*>(m_notShown), m_controls,
          static_cast<QWidget*>(m_groups), m_events, static_cast<QWidget*>(m_refused)})
        column->addWidget(widget);
    column->addStretch(1);
}

void AirwayPanel::addPresets(QBoxLayout& column)
{
    m_presets->setObjectName(QStringLiteral("airwayPreset"));
    m_presets->setAccessibleName(tr("Preset of the airway"));
    m_presets->setToolTip(
        tr("Sets all events as one change, over the time of a change; Custom "
           "stands here where the severities are of no preset. An infant is another "
           "patient: chosen on the start page, or when a station is added"));
    m_presets->setPlaceholderText(tr("Custom"));
    m_presets->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_presets->setMinimumContentsLength(kPresetLetters);
    makeLow(*m_presets);
    for (const AirwayPreset& preset : airwayPresets()) {
        m_presets->addItem(presetText(preset),
                           QByteArray{preset.name.data(), qsizetype(preset.name.size())});
        QStringList told{eventsText(preset.events), limitsText(preset)};
        told.removeAll(QString{});
        m_presets->setItemData(m_presets->count() - 1, shownAsIs(told.join(QLatin1Char{'\n'})),
                               Qt::ToolTipRole);
    }
    auto* label = new PlainLabel{tr("Se&veral by preset")};
    label->setBuddy(m_presets);
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(m_presets, 1);
    column.addLayout(row);
    m_condition->setObjectName(QStringLiteral("airwayPresetCondition"));
    m_condition->setWordWrap(true);
    column.addWidget(m_condition);
}

void AirwayPanel::addTimeAndClear(QBoxLayout& column)
{
    m_over->setObjectName(QStringLiteral("airwayOver"));
    m_over->setAccessibleName(tr("Time over which the airway changes, seconds"));
    m_over->setToolTip(tr("How long a change takes, from the next one on: at once, or up to 600 "
                          "seconds in which severities and the head go evenly to what is new. "
                          "Events that are still on their way then come within that time, too"));
    m_over->setRange(0, int(toSeconds(kLongestAirwayChange)));
    m_over->setSingleStep(kChangeStep_s);
    m_over->setSpecialValueText(tr("at once"));
    m_over->setSuffix(tr(" s"));
    m_over->setAlignment(Qt::AlignRight);
    makeLow(*m_over);
    m_clear->setObjectName(QStringLiteral("clearAirway"));
    m_clear->setToolTip(tr("All events of the airway go, over the time of a change (Alt+C); the "
                           "head lies as before"));
    makeLow(*m_clear);
    auto* label = new PlainLabel{tr("Time &of a change")};
    label->setBuddy(m_over);
    auto* row = new QHBoxLayout;
    row->addWidget(label, 1);
    row->addWidget(m_over);
    row->addWidget(m_clear);
    column.addLayout(row);
}

void AirwayPanel::addRows()
{
    auto* rows = new QGridLayout{m_events};
    rows->setContentsMargins({});
    rows->setVerticalSpacing(kEventGap);
    int widest = 0;
    for (const AirwayEventKind kind : kindsByGroup()) {
        const Row& row = m_rows[placeOf(kind)] = addRow(*rows, kind);
        widest = std::max(widest, row.label->sizeHint().width());
    }
    rows->setColumnMinimumWidth(0, widest); // whichever group is in sight
    addSuction();
}

void AirwayPanel::addSuction()
{
    m_suction->setObjectName(QStringLiteral("suction"));
    m_suction->setToolTip(tr("Clears secretions, blood and vomit within 5 seconds, as a helper "
                             "with a suction catheter would. Other events stay as they are set; "
                             "those that are still changing reach their setting within that time"));
    makeLow(*m_suction);
    auto* rows = static_cast<QGridLayout*>(m_events->layout());
    rows->addWidget(m_suction, rows->rowCount(), 1, 1, -1);
}

/// Name, box and slider, and room for the present severity, so that nothing moves when it appears;
/// below, what the patient does not show of it.
AirwayPanel::Row AirwayPanel::addRow(QGridLayout& rows, AirwayEventKind kind)
{
    const Row row{new PlainLabel{labelOf(kind)}, new PlainLabel, new CheckedSpinBox,
                  new QSlider{Qt::Horizontal}, new PlainLabel};
    const QString name = QLatin1String{eventName(kind)};
    const QString effect = eventEffect(kind);
    row.severity->setObjectName(name);
    row.severity->setAccessibleName(tr("%1, severity in per cent").arg(eventText(kind)));
    row.severity->setToolTip(shownAsIs(effect));
    row.severity->setRange(0, kMostPercent);
    row.severity->setSingleStep(kSeverityStep_percent);
    row.severity->setSuffix(tr(" %"));
    row.severity->setAlignment(Qt::AlignRight);
    makeLow(*row.severity);
    row.slider->setObjectName(name + QStringLiteral("Slider"));
    row.slider->setAccessibleName(tr("%1, severity slider").arg(eventText(kind)));
    row.slider->setToolTip(shownAsIs(effect));
    row.slider->setRange(0, kMostPercent);
    row.slider->setMinimumWidth(kLeastSlider);
    row.slider->setPageStep(kSeverityStep_percent);
    row.present->setObjectName(name + QStringLiteral("Now"));
    row.present->setAccessibleName(tr("%1, present severity").arg(eventText(kind)));
    row.present->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row.present->setMinimumWidth(
        row.present->fontMetrics().horizontalAdvance(textOfDrawn(kMostPercent - 1)));
    row.notShown->setObjectName(name + QStringLiteral("NotShown"));
    row.notShown->setWordWrap(true);
    row.label->setBuddy(row.severity);
    row.label->setToolTip(shownAsIs(effect));
    const int line = rows.rowCount();
    rows.addWidget(row.label, line, 0);
    rows.addWidget(row.severity, line, 1);
    rows.addWidget(row.slider, line, 2);
    rows.addWidget(row.present, line, 3);
    rows.addWidget(row.notShown, line + 1, 0, 1, -1);
    return row;
}

void AirwayPanel::setModels(AirwayEventModel& events, HeadPositionModel& head)
{
    m_model = &events;
    m_headModel = &head;
    m_head->setModel(head);
    m_groups->setModel(events);
    connect(m_presets, &QComboBox::activated, this, &AirwayPanel::choosePreset);
    connect(m_over, &QSpinBox::valueChanged, this, [this](int seconds) {
        m_model->setChangeTime(std::chrono::seconds{seconds});
        m_headModel->setChangeTime(std::chrono::seconds{seconds});
    });
    for (std::size_t place = 0; place < m_rows.size(); ++place)
        connectRow(static_cast<AirwayEventKind>(place));
    connect(m_suction, &QPushButton::clicked, &events, &AirwayEventModel::suction);
    connect(m_clear, &QPushButton::clicked, &events, &AirwayEventModel::clear);
    connect(&events, &AirwayEventModel::changed, this, &AirwayPanel::refresh);
    connect(&head, &HeadPositionModel::changed, this, &AirwayPanel::refresh);
    refresh();
}

void AirwayPanel::connectRow(AirwayEventKind kind)
{
    const Row& row = m_rows[placeOf(kind)];
    connect(row.severity, &QSpinBox::valueChanged, this,
            [this, kind](int percent) { m_model->setSeverity(kind, percent / 100.0); });
    connect(row.slider, &QSlider::valueChanged, row.severity, &QSpinBox::setValue);
}

void AirwayPanel::choosePreset(int place)
{
    const QByteArray name = m_presets->itemData(place).toByteArray();
    if (const AirwayPreset* preset =
            presetNamed({name.constData(), static_cast<std::size_t>(name.size())}))
        m_model->setEvents(preset->events);
    refreshPreset();
}

void AirwayPanel::showGroup(const QByteArray& name)
{
    m_groups->choose(name);
    showRows();
}

void AirwayPanel::showRows()
{
    for (const AirwayEventKind kind : kindsByGroup()) {
        const Row& row = m_rows[placeOf(kind)];
        const bool isShown = m_groups->shows(kind);
        for (QWidget* of : {static_cast<QWidget*>(row.label), static_cast<QWidget*>(row.severity),
                            static_cast<QWidget*>(row.slider), static_cast<QWidget*>(row.present)})
            of->setVisible(isShown);
        row.notShown->setVisible(isShown && !row.notShown->text().isEmpty());
    }
    m_suction->setVisible(m_groups->shows(AirwayEventKind::Secretions));
    offerWhatCanBeSet();
}

void AirwayPanel::refresh()
{
    const QString obstacle = m_model->obstacle();
    sayOrHide(*m_obstacle, obstacle);
    sayOrHide(*m_notShown, m_model->limits().all);
    m_controls->setEnabled(obstacle.isEmpty());
    m_events->setEnabled(obstacle.isEmpty()); // the groups can be looked at
    refreshPreset();
    for (std::size_t place = 0; place < m_rows.size(); ++place)
        refreshRow(static_cast<AirwayEventKind>(place));
    showRows();
    m_suction->setEnabled(m_model->hasFluid());
    m_clear->setEnabled(m_model->hasEvents());
    QStringList travelling{m_model->travellingText(), m_headModel->travellingText()};
    travelling.removeAll(QString{});
    m_travelling->setText(travelling.join(QStringLiteral(" · ")));
    m_travelling->setToolTip(shownAsIs(m_travelling->text()));
}

void AirwayPanel::refreshPreset()
{
    const AirwayEvents set = m_model->events();
    const AirwayPreset* preset = presetOf(set);
    m_presets->setCurrentIndex(preset ? int(preset - airwayPresets().data()) : -1);
    const bool isLookedAtOtherwise =
        preset
        && (m_headModel->position() != preset->look.head || preset->look.eye != ScopeEye::Video);
    const bool hasCondition = preset && (preset->grade == 0 || isLookedAtOtherwise);
    sayOrHide(*m_condition, hasCondition ? limitsText(*preset) : QString{});
    m_presets->setAccessibleDescription(
        QStringList{eventsText(set), m_condition->text()}.join(QLatin1Char{' '}).trimmed());
}

void AirwayPanel::refreshRow(AirwayEventKind kind)
{
    const Row& row = m_rows[placeOf(kind)];
    const int set = percentOf(m_model->severity(kind));
    const QString& notShown = m_model->limits().said(kind);
    showSeverity(*row.severity, set);
    showSeverity(*row.slider, set);
    refreshPresent(kind);
    for (QWidget* control :
         {static_cast<QWidget*>(row.severity), static_cast<QWidget*>(row.slider)}) {
        control->setEnabled(m_model->canBeSet(kind));
        control->setAccessibleDescription(notShown);
    }
    row.notShown->setText(notShown);
}

/// What is drawn, where that is less than the severity of now; else this, where it changes.
void AirwayPanel::refreshPresent(AirwayEventKind kind)
{
    QLabel& label = *m_rows[placeOf(kind)].present;
    const int present = percentOf(m_model->present(kind));
    const int drawn = percentOf(m_model->drawn(kind));
    const bool isLess = m_model->limits().canShow(kind) && drawn < present;
    const bool changes = present != percentOf(m_model->severity(kind));
    label.setText(isLess ? textOfDrawn(drawn) : changes ? textOfPresent(present) : QString{});
    const QString why = isLess
                            ? tr("Events that fill the throat share its room: together they are "
                                 "drawn as two of them at 100\u00a0%, and each less in proportion")
                            : QString{};
    label.setToolTip(shownAsIs(why));
    label.setAccessibleDescription(why);
}

/// Presets where any event can be set. The keyboard comes to the first event in sight that can be,
/// else, and where this person can set none, to the heading of its group.
void AirwayPanel::offerWhatCanBeSet()
{
    const auto boxOf = [this](AirwayEventKind kind) { return m_rows[placeOf(kind)].severity; };
    const auto canBeSet = [&](AirwayEventKind kind) { return boxOf(kind)->isEnabledTo(m_events); };
    const std::vector<AirwayEventKind> kinds = kindsByGroup();
    const auto first = std::ranges::find_if(
        kinds, [&](AirwayEventKind kind) { return m_groups->shows(kind) && canBeSet(kind); });
    const bool isAny = std::ranges::any_of(kinds, canBeSet);
    m_presets->setEnabled(isAny);
    if (!m_events->isEnabled())
        setFocusProxy(m_groups->heading()); // which can be looked through
    else if (first != kinds.end())
        setFocusProxy(boxOf(*first));
    else
        setFocusProxy(isAny ? static_cast<QWidget*>(m_groups->heading()) : m_over);
}

} // namespace carina
