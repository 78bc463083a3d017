#include "ui/tracker/tracker_panel.h"

#include "models/text/shown_as_is.h"
#include "widgets/plain_label.h"
#include "widgets/volume_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QScrollBar>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kBetweenBeeps_ms = 250;
constexpr double kOldest_s = 99.9; ///< that is told as a number

enum ToolColumn {
    kToolName,
    kToolState,
    kToolRate,
    kToolAge,
    kToolError,
    kToolExpected,
    kToolAhead,
    kToolEdge,
    kToolColumns
};

QString none() { return QStringLiteral("–"); }

/// How good its predicted poses were, and are expected to be.
QString aheadText(const ToolStatus& tool)
{
    if (!tool.predicted_mm || !tool.held_mm)
        return none();
    const QString were = TrackerPanel::tr("%1 (%2)")
                             .arg(*tool.predicted_mm, 0, 'f', 1)
                             .arg(*tool.held_mm, 0, 'f', 1);
    return tool.deviation_mm
               ? TrackerPanel::tr("%1 ± %2").arg(were).arg(*tool.deviation_mm, 0, 'f', 1)
               : were;
}

/// What keeps tools from being seen; empty where nothing does.
QString troubleText(const std::optional<TrackerSight>& sight)
{
    if (!sight)
        return TrackerPanel::tr("This program has no tracker.");
    if (sight->trouble.isEmpty() && !sight->isPlaced)
        return TrackerPanel::tr("Nothing is tracked now: the tools of a tracker are seen once the "
                                "site is registered with it (carina-registration).");
    return sight->trouble;
}

} // namespace

TrackerPanel::TrackerPanel(Sight sight, KeptSound sound, ToolUse use, QWidget* parent)
    : QWidget{parent},
      m_sight{std::move(sight)},
      m_kept{std::move(sound)},
      m_alarm{use},
      m_trouble{new PlainLabel},
      m_table{new QTableWidget{0, kToolColumns}},
      m_sound{new QCheckBox{tr("S&ound when a needed tool is lost or back")}},
      m_volume{new QComboBox},
      m_places{new VolumeView}
{
    m_trouble->setObjectName(QStringLiteral("trouble"));
    m_trouble->setAccessibleName(tr("What keeps the tracker from tracking"));
    m_trouble->setTextFormat(Qt::PlainText);
    m_trouble->setWordWrap(true);
    m_table->setObjectName(QStringLiteral("toolTable"));
    m_table->setAccessibleName(tr("Tools as the tracker sees them"));
    m_table->setHorizontalHeaderLabels({tr("Tool"), tr("State"), tr("Rate,\nHz"), tr("Age,\ns"),
                                        tr("Fit,\nmm"), tr("Expected,\nmm"), tr("Ahead,\nmm"),
                                        tr("To edge,\nmm")});
    m_table->horizontalHeaderItem(kToolAge)->setToolTip(
        tr("How old the newest pose is in which the tool was seen"));
    m_table->horizontalHeaderItem(kToolError)
        ->setToolTip(tr("How far the tool's markers lie from where its pose puts them (RMS), as "
                        "the tracker says"));
    m_table->horizontalHeaderItem(kToolExpected)
        ->setToolTip(tr("The error to expect of the tool's pose at its origin (RMS), and of its "
                        "rotation, by the places of the markers that are seen; where the tracker "
                        "does not tell these, of all that face it, and none of a tool that is "
                        "partly out of view"));
    m_table->horizontalHeaderItem(kToolAhead)
        ->setToolTip(shownAsIs(
            tr("Error of poses predicted by %1 ms, over the last seconds (RMS). In brackets: "
               "the error without prediction. After ±: the error expected now, from the "
               "tool's motion")
                .arg(kPredictedAhead / std::chrono::milliseconds{1})));
    m_table->horizontalHeaderItem(kToolEdge)->setToolTip(
        tr("How far inside the working volume the tool is; below 0 it is outside"));
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->verticalHeader()->hide();
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::NoSelection);
    m_table->setTabKeyNavigation(false);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_sound->setObjectName(QStringLiteral("sound"));
    m_sound->setToolTip(tr("Two beeps of this computer when a tool was lost for half a second to a "
                           "second, one when it is back"));
    m_sound->setChecked(m_kept.isOn());
    connect(m_sound, &QCheckBox::toggled, this, [this](bool isOn) { m_kept.keep(isOn); });
    setFocusProxy(m_table);
    auto* column = new QVBoxLayout{this};
    column->addWidget(m_trouble);
    column->addWidget(m_table, 1);
    column->addWidget(m_places);
    column->addWidget(volumeRow());
    column->addWidget(m_sound);
    auto* timer = new QTimer{this};
    connect(timer, &QTimer::timeout, this, &TrackerPanel::look);
    timer->start(kInterval_ms);
    look();
}

void TrackerPanel::offer(const TreatmentChoice& choice)
{
    auto* predict = new QCheckBox{tr("P&redict poses to the moment they are seen")};
    predict->setObjectName(QStringLiteral("predict"));
    predict->setChecked(choice.now.predicts);
    auto* smooth = new QCheckBox{tr("&Smooth tools held still (1-Euro filter)")};
    smooth->setObjectName(QStringLiteral("smooth"));
    smooth->setToolTip(
        tr("Removes the tracker's jitter from tools that rest. Slow motion is drawn a "
           "little later"));
    smooth->setChecked(choice.now.smooths);
    auto* column = qobject_cast<QVBoxLayout*>(layout());
    for (QCheckBox* box : {predict, smooth}) {
        column->insertWidget(column->indexOf(m_sound), box);
        connect(box, &QCheckBox::toggled, this, [predict, smooth, choose = choice.choose] {
            choose({.predicts = predict->isChecked(), .smooths = smooth->isChecked()});
        });
    }
}

void TrackerPanel::look()
{
    const auto sight = m_sight ? m_sight() : std::nullopt;
    m_trouble->setText(troubleText(sight));
    m_trouble->setVisible(!m_trouble->text().isEmpty());
    suggest(sight ? sight->usualVolume : KnownVolume::None);
    show(sight ? sight->tools : std::vector<ToolStatus>{});
    place(sight ? sight->tools : std::vector<ToolStatus>{});
    listen(sight ? sight->tools : std::vector<ToolStatus>{});
}

QWidget* TrackerPanel::volumeRow()
{
    m_volume->setObjectName(QStringLiteral("volume"));
    m_volume->setAccessibleName(tr("Working volume of the tracker"));
    m_places->setObjectName(QStringLiteral("places"));
    for (const KnownVolume known : knownVolumes())
        m_volume->addItem(volumeName(known), int(known));
    connect(m_volume, &QComboBox::currentIndexChanged, this, &TrackerPanel::look);
    auto* row = new QWidget;
    auto* form = new QFormLayout{row};
    form->setContentsMargins({});
    form->addRow(tr("Working &volume"), m_volume);
    return row;
}

/// That of another tracker; what a person chose for this one is kept.
void TrackerPanel::suggest(KnownVolume volume)
{
    if (std::exchange(m_suggested, volume) == volume)
        return;
    const QSignalBlocker silent{m_volume};
    m_volume->setCurrentIndex(m_volume->findData(int(volume)));
}

void TrackerPanel::place(const std::vector<ToolStatus>& tools)
{
    const auto volume = volumeOf(KnownVolume(m_volume->currentData().toInt()));
    std::vector<VolumeView::Section> sections;
    std::vector<VolumeView::Thing> things;
    if (volume) {
        for (const VolumeSection& section : volume->sections)
            sections.push_back({section.depth, section.halfX, section.halfY});
        for (const ToolStatus& tool : tools)
            if (tool.isVisible && tool.p_T)
                things.push_back({tool.name, -tool.p_T->z(), tool.p_T->x(), tool.p_T->y(),
                                  volume->insideBy(*tool.p_T) >= 0.0});
    }
    m_places->setVisible(volume.has_value());
    m_places->setVolume(std::move(sections));
    m_places->setThings(std::move(things));
}

void TrackerPanel::show(const std::vector<ToolStatus>& tools)
{
    const auto volume = volumeOf(KnownVolume(m_volume->currentData().toInt()));
    m_seen = int(std::ranges::count(tools, true, &ToolStatus::isVisible));
    m_table->setRowCount(int(tools.size()));
    for (int row = 0; row < int(tools.size()); ++row) {
        const ToolStatus& tool = tools[std::size_t(row)];
        const QString mark = tool.isVisible ? QStringLiteral("✓ ") : QStringLiteral("▲ ");
        const auto put = [&](ToolColumn column, const QString& text) {
            if (m_table->item(row, column) == nullptr)
                m_table->setItem(row, column, new QTableWidgetItem);
            m_table->item(row, column)->setText(text);
        };
        put(kToolName, tool.name);
        put(kToolState, mark + tool.state);
        put(kToolRate, tool.rate_Hz > 0.0 ? QString::number(qRound(tool.rate_Hz)) : none());
        put(kToolAge, !tool.age_s               ? none()
                      : *tool.age_s > kOldest_s ? tr("long")
                                                : QString::number(*tool.age_s, 'f', 2));
        put(kToolError, tool.error_mm ? QString::number(*tool.error_mm, 'f', 2) : none());
        put(kToolExpected, tool.expected_mm ? tr("%1, %2°")
                                                  .arg(*tool.expected_mm, 0, 'f', 2)
                                                  .arg(tool.expected_deg.value_or(0.0), 0, 'f', 2)
                                            : none());
        put(kToolAhead, aheadText(tool));
        put(kToolEdge, volume && tool.isVisible && tool.p_T
                           ? QString::number(qRound(1e3 * volume->insideBy(*tool.p_T)))
                           : none());
    }
    fitRows();
}

/// All tools are in sight: what is around the panel scrolls.
void TrackerPanel::fitRows()
{
    const int frame =
        2 * m_table->frameWidth() + m_table->horizontalScrollBar()->sizeHint().height();
    int height = m_table->horizontalHeader()->sizeHint().height() + frame;
    for (int row = 0; row < m_table->rowCount(); ++row)
        height += m_table->rowHeight(row);
    m_table->setMinimumHeight(height);
}

void TrackerPanel::listen(const std::vector<ToolStatus>& tools)
{
    const ToolAlarm::Change change = m_alarm.look(tools);
    for (const QString& tool : change.lost)
        Q_EMIT lost(tool);
    for (const QString& tool : change.back)
        Q_EMIT back(tool);
    if (!m_kept.isOn())
        return;
    if (change.losesNeeded)
        makeSound(kBeepsWhenLost);
    else if (change.returnsNeeded)
        makeSound(kBeepsWhenBack);
}

/// By the system's beep, which has one tone: the number of beeps tells what it is about.
void TrackerPanel::makeSound(int beeps)
{
    for (int beep = 0; beep < beeps; ++beep)
        QTimer::singleShot(beep * kBetweenBeeps_ms, this, [] { QApplication::beep(); });
    Q_EMIT sounded(beeps);
}

} // namespace carina
