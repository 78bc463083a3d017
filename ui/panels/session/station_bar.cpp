#include "ui/panels/session/station_bar.h"

#include "models/text/shown_as_is.h"
#include "ui/panels/session/station_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QTabBar>
#include <QToolButton>

#include <algorithm>
#include <vector>

namespace carina
{
namespace
{

constexpr int kBarMargin = 8; ///< pixels, as beside the views beneath
constexpr int kBarSpacing = 4;
constexpr int kLeastName = 80;    ///< pixels of a longer name that tell stations apart
constexpr int kWholeName = 10000; ///< pixels, more than any name has
constexpr int kListedName = 220;  ///< pixels
constexpr int kListLetters = 22;

/// Makes a button as wide as it ever gets, so that nothing beside it moves under the pointer when
/// its words change.
void reserveWidth(QToolButton& button, const QString& longest)
{
    const QString now = button.text();
    button.setText(longest);
    button.ensurePolished();
    button.setMinimumWidth(button.sizeHint().width());
    button.setText(now);
}

/// A name as a tab shows it, in at most so many pixels.
QString tabText(const StationsModel::Row& row, int widest, const QFontMetrics& metrics)
{
    QString name = metrics.elidedText(row.name, Qt::ElideMiddle, widest);
    name.replace(QLatin1Char('&'), QStringLiteral("&&")); // no mnemonic
    return StationBar::tr("%1: %2 here").arg(name, QString::number(row.present));
}

/// How wide each of several widths may be so that together they are no wider than the room.
int widestOf(std::vector<int> widths, int room)
{
    std::ranges::sort(widths);
    int left = room;
    for (std::size_t narrower = 0; narrower < widths.size(); ++narrower) {
        const int share = left / int(widths.size() - narrower);
        if (widths[narrower] > share)
            return share;
        left -= widths[narrower];
    }
    return kWholeName;
}

} // namespace

StationBar::StationBar(QWidget* parent)
    : QWidget{parent},
      m_place{new QWidget},
      m_tabs{new QTabBar},
      m_list{new QComboBox},
      m_add{button("add", tr("Add…"))},
      m_rename{button("rename", tr("Rename…"))},
      m_close{button("close", tr("Close"))},
      m_forAll{new QCheckBox{tr("&All")}}
{
    m_tabs->setObjectName(QStringLiteral("stations"));
    m_tabs->setAccessibleName(tr("Station that is shown"));
    m_tabs->setToolTip(tr("The station that is shown, with the number of participants there"));
    m_tabs->setExpanding(false);
    m_tabs->setDrawBase(false);
    m_tabs->setUsesScrollButtons(false); // they would cover what is to be chosen
    m_tabs->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_list->setObjectName(QStringLiteral("stationList"));
    m_list->setAccessibleName(tr("Station that is shown"));
    m_list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_list->setMinimumContentsLength(kListLetters);
    m_list->hide();
    m_forAll->setObjectName(QStringLiteral("forAll"));
    m_forAll->setAccessibleName(tr("All stations"));
    m_forAll->setToolTip(tr("What is changed about breathing, condition and airway is changed "
                            "at all stations, at the same time"));
    m_place->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    auto* chooser = new QHBoxLayout{m_place};
    chooser->setContentsMargins({});
    chooser->addWidget(m_tabs, 1);
    chooser->addWidget(m_list, 1, Qt::AlignLeft);
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins(kBarMargin, 0, 0, 0);
    row->setSpacing(kBarSpacing);
    row->addWidget(m_place, 1);
    row->addWidget(m_forAll);
    for (QToolButton* command : {m_add, m_rename, m_close})
        row->addWidget(command);
}

QToolButton* StationBar::button(const char* name, const QString& text)
{
    auto* made = new QToolButton;
    made->setObjectName(QLatin1String{name});
    made->setText(text);
    made->setFocusPolicy(Qt::StrongFocus);
    return made;
}

void StationBar::setModel(StationsModel& stations)
{
    m_stations = &stations;
    reserveWidth(*m_close, tr("Really?"));
    connect(&stations, &StationsModel::changed, this, &StationBar::refresh);
    connect(&stations, &StationsModel::shownChanged, this, &StationBar::refresh);
    connect(m_tabs, &QTabBar::currentChanged, this, &StationBar::choose);
    connect(m_list, &QComboBox::currentIndexChanged, this, &StationBar::choose);
    connect(m_forAll, &QCheckBox::toggled, &stations, &StationsModel::setForAll);
    connect(m_add, &QToolButton::clicked, this, &StationBar::askForNew);
    connect(m_rename, &QToolButton::clicked, this, &StationBar::askForName);
    connect(m_close, &QToolButton::clicked, &m_closing, &SecondPress::press);
    connect(&stations, &StationsModel::shownChanged, &m_closing, &SecondPress::forget);
    connect(&m_closing, &SecondPress::changed, this, &StationBar::refresh);
    connect(&m_closing, &SecondPress::confirmed, this,
            [this] { m_stations->close(m_stations->shown()); });
    refresh();
}

void StationBar::choose(int place)
{
    const auto& open = m_stations->open();
    if (place >= 0 && place < static_cast<int>(open.size()))
        m_stations->show(open[std::size_t(place)].id);
}

void StationBar::refreshTabs()
{
    const auto& open = m_stations->open();
    const QSignalBlocker quiet{m_tabs};
    while (m_tabs->count() > static_cast<int>(open.size()))
        m_tabs->removeTab(m_tabs->count() - 1);
    while (m_tabs->count() < static_cast<int>(open.size()))
        m_tabs->addTab(QString{});
    for (int tab = 0; tab < m_tabs->count(); ++tab) {
        const StationsModel::Row& row = open[std::size_t(tab)];
        const QString all = tr("%1, participants: %2").arg(row.name, QString::number(row.present));
        m_tabs->setTabToolTip(tab, shownAsIs(all));
        m_tabs->setAccessibleTabName(tab, all);
        if (row.id == m_stations->shown())
            m_tabs->setCurrentIndex(tab);
    }
}

void StationBar::refreshList()
{
    const auto& open = m_stations->open();
    const QSignalBlocker quiet{m_list};
    while (m_list->count() > static_cast<int>(open.size()))
        m_list->removeItem(m_list->count() - 1);
    while (m_list->count() < static_cast<int>(open.size()))
        m_list->addItem(QString{});
    for (int item = 0; item < m_list->count(); ++item) {
        const StationsModel::Row& row = open[std::size_t(item)];
        const QString present = QString::number(row.present);
        const QString name =
            m_list->fontMetrics().elidedText(row.name, Qt::ElideMiddle, kListedName);
        m_list->setItemText(item, tr("%1: %2 here").arg(name, present));
        const QString all = tr("%1, participants: %2").arg(row.name, present);
        m_list->setItemData(item, all, Qt::AccessibleTextRole);
        m_list->setItemData(item, shownAsIs(all), Qt::ToolTipRole);
        if (row.id == m_stations->shown())
            m_list->setCurrentIndex(item);
    }
    m_list->setToolTip(shownAsIs(m_stations->nameOf(m_stations->shown())));
}

void StationBar::nameTabs(int widest)
{
    const auto& open = m_stations->open();
    const QSignalBlocker quiet{m_tabs};
    for (int tab = 0; tab < std::min(m_tabs->count(), static_cast<int>(open.size())); ++tab) {
        const QString text = tabText(open[std::size_t(tab)], widest, m_tabs->fontMetrics());
        if (m_tabs->tabText(tab) != text)
            m_tabs->setTabText(tab, text);
    }
}

/// Tabs as long as names of which enough is seen have room, else the list.
void StationBar::fit()
{
    if (!m_stations)
        return;
    nameTabs(kWholeName);
    if (!m_place->isVisible()) // its width is not known yet
        return;
    std::vector<int> names;
    int all = 0;
    for (const StationsModel::Row& row : m_stations->open()) {
        names.push_back(m_tabs->fontMetrics().horizontalAdvance(row.name));
        all += names.back();
    }
    const int around = m_tabs->sizeHint().width() - all + m_tabs->count(); // with some for rounding
    const int widest = widestOf(names, m_place->width() - around);
    nameTabs(std::max(widest, kLeastName));
    const bool hasRoom = widest >= kLeastName;
    const bool isAsked = m_tabs->hasFocus() || m_list->hasFocus();
    m_tabs->setVisible(hasRoom);
    m_list->setVisible(!hasRoom);
    if (isAsked)
        (hasRoom ? static_cast<QWidget*>(m_tabs) : m_list)->setFocus();
}

void StationBar::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    fit();
}

void StationBar::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    fit();
}

void StationBar::refresh()
{
    const auto& open = m_stations->open();
    refreshTabs();
    refreshList();
    fit();
    m_forAll->setEnabled(open.size() > 1);
    const QString full = m_stations->obstacleToAdding();
    m_add->setEnabled(full.isEmpty());
    m_add->setToolTip(full.isEmpty() ? tr("Open another station, with a patient of its own")
                                     : shownAsIs(full));
    m_rename->setEnabled(!open.empty());
    m_rename->setToolTip(tr("Give the station that is shown another name"));
    const QString occupied = m_stations->obstacleToClosing(m_stations->shown());
    m_close->setText(m_closing.isAsked() ? tr("Really?") : tr("Close"));
    m_close->setEnabled(occupied.isEmpty());
    m_close->setToolTip(occupied.isEmpty() ? tr("Close the station that is shown")
                                           : shownAsIs(occupied));
}

void StationBar::askForNew()
{
    auto* dialog = new StationDialog{*m_stations, kNoStation, this};
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, m_stations,
            [this, dialog] { m_stations->add(dialog->name(), dialog->patient()); });
    dialog->open();
}

void StationBar::askForName()
{
    const StationId station = m_stations->shown();
    auto* dialog = new StationDialog{*m_stations, station, this};
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, m_stations,
            [this, dialog, station] { m_stations->rename(station, dialog->name()); });
    dialog->open();
}

} // namespace carina
