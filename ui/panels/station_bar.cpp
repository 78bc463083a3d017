#include "ui/panels/station_bar.h"

#include "models/text/shown_as_is.h"
#include "ui/panels/station_dialog.h"
#include "widgets/plain_label.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QTabBar>
#include <QToolButton>

namespace carina
{
namespace
{

constexpr int kBarMargin = 8; ///< pixels, as beside the views beneath
constexpr int kBarSpacing = 4;

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

} // namespace

StationBar::StationBar(QWidget* parent)
    : QWidget{parent},
      m_tabs{new QTabBar},
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
    m_tabs->setUsesScrollButtons(true);
    m_forAll->setObjectName(QStringLiteral("forAll"));
    m_forAll->setAccessibleName(tr("All stations"));
    m_forAll->setToolTip(tr("What is changed about breathing and condition is changed at all "
                            "stations, at the same time"));
    auto* label = new PlainLabel{tr("Station")};
    auto* row = new QHBoxLayout{this};
    row->setContentsMargins(kBarMargin, 0, 0, 0);
    row->setSpacing(kBarSpacing);
    row->addWidget(label);
    row->addWidget(m_tabs, 1);
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
    connect(m_tabs, &QTabBar::currentChanged, this, [this](int tab) {
        const auto& open = m_stations->open();
        if (tab >= 0 && tab < static_cast<int>(open.size()))
            m_stations->show(open[std::size_t(tab)].id);
    });
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

void StationBar::refresh()
{
    const auto& open = m_stations->open();
    {
        const QSignalBlocker quiet{m_tabs};
        while (m_tabs->count() > static_cast<int>(open.size()))
            m_tabs->removeTab(m_tabs->count() - 1);
        while (m_tabs->count() < static_cast<int>(open.size()))
            m_tabs->addTab(QString{});
        for (int tab = 0; tab < m_tabs->count(); ++tab) {
            const StationsModel::Row& row = open[std::size_t(tab)];
            QString name = row.name;
            name.replace(QLatin1Char('&'), QStringLiteral("&&")); // no mnemonic
            m_tabs->setTabText(tab, tr("%1: %2 here").arg(name, QString::number(row.present)));
            m_tabs->setAccessibleTabName(
                tab, tr("%1, participants: %2").arg(row.name, QString::number(row.present)));
            if (row.id == m_stations->shown())
                m_tabs->setCurrentIndex(tab);
        }
    }
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
