#include "ui/panels/people/participants_panel.h"

#include "models/text/shown_as_is.h"
#include "ui/panels/people/people_menus.h"
#include "ui/panels/people/remove_dialog.h"
#include "ui_participants_panel.h"
#include "widgets/wrapped_text.h"

#include <QEvent>
#include <QHeaderView>

#include <algorithm>
#include <array>

namespace carina
{
namespace
{

/// What everybody wants to know stands first; the others stand behind it, for who scrolls there,
/// and the figures of the network have a panel of their own.
constexpr std::array kFirst{ParticipantsModel::Name, ParticipantsModel::State,
                            ParticipantsModel::Delay, ParticipantsModel::Same,
                            ParticipantsModel::RoleColumn};
/// Figures that the panel of the network has; what each sends is here, to be compared.
constexpr std::array kElsewhere{ParticipantsModel::Age, ParticipantsModel::DriftAngle,
                                ParticipantsModel::DriftDistance};
/// Of the first, what is in sight beside the names.
constexpr std::array kInSight{ParticipantsModel::State, ParticipantsModel::Delay,
                              ParticipantsModel::Same};
constexpr int kLeastNames = 90; ///< pixels

/// What there is no room for is in the tip.
void tell(QLabel& line, const QString& text)
{
    line.setText(text);
    line.setToolTip(shownAsIs(text));
}

} // namespace

ParticipantsPanel::ParticipantsPanel(QWidget* parent)
    : QWidget{parent}, m_ui{std::make_unique<Ui::ParticipantsPanel>()}
{
    m_ui->setupUi(this);
}

ParticipantsPanel::~ParticipantsPanel() = default;

void ParticipantsPanel::setModel(ParticipantsModel& participants, ConductModel& conduct,
                                 StationsModel& stations, PeopleModel& people)
{
    m_conduct = &conduct;
    m_participants = &participants;
    m_stations = &stations;
    m_people = &people;
    m_ui->table->setModel(&participants);
    layTable();
    m_ui->move->setMenu(&m_moves);
    connect(&m_moves, &QMenu::aboutToShow, this, &ParticipantsPanel::offerStations);
    connect(&stations, &StationsModel::changed, this, &ParticipantsPanel::refresh);
    connect(&conduct, &ConductModel::changed, this, &ParticipantsPanel::refresh);
    connect(&participants, &QAbstractItemModel::modelReset, this, &ParticipantsPanel::refresh);
    connect(m_ui->table->selectionModel(), &QItemSelectionModel::currentChanged, this,
            &ParticipantsPanel::refresh);
    connect(&participants, &QAbstractItemModel::dataChanged, this,
            &ParticipantsPanel::refreshFigures);
    connect(&participants, &QAbstractItemModel::dataChanged, this,
            &ParticipantsPanel::refreshColumns);
    connect(&participants, &QAbstractItemModel::rowsInserted, this,
            &ParticipantsPanel::refreshColumns);
    connect(m_ui->mute, &QPushButton::clicked, this, &ParticipantsPanel::muteOrNot);
    connect(m_ui->remove, &QPushButton::clicked, this, &ParticipantsPanel::removeOrLetBack);
    connect(m_ui->lock, &QCheckBox::clicked, &conduct, &ConductModel::setLocked);
    connect(m_ui->work, &QPushButton::clicked, this, [this] {
        if (const auto id = chosen())
            m_people->giveWork(*id);
    });
    m_ui->place->setMenu(new PlaceMenu{people,
                                       [this] { return chosen(); },
                                       [this] { return m_ownHead ? m_ownHead() : std::nullopt; },
                                       {},
                                       this});
    connect(&people, &PeopleModel::changed, this, &ParticipantsPanel::refreshPerson);
    refresh();
}

void ParticipantsPanel::layTable()
{
    QTableView& table = *m_ui->table;
    QHeaderView* header = table.horizontalHeader();
    header->setSectionResizeMode(QHeaderView::ResizeToContents); // contents and headings whole
    header->setSectionResizeMode(ParticipantsModel::Name, QHeaderView::Fixed);
    for (std::size_t place = 0; place < kFirst.size(); ++place)
        header->moveSection(header->visualIndex(kFirst[place]), int(place));
    for (const int figure : kElsewhere)
        table.setColumnHidden(figure, true);
    table.setItemDelegateForColumn(ParticipantsModel::Name, new WrappedTextDelegate{&table});
    table.verticalHeader()->setMinimumSectionSize(table.verticalHeader()->defaultSectionSize());
    table.viewport()->installEventFilter(this);
    m_fitting.setSingleShot(true);
    m_fitting.setInterval(0); // a header that is laying its columns is not to be changed
    connect(&m_fitting, &QTimer::timeout, this, &ParticipantsPanel::fitNames);
    connect(header, &QHeaderView::sectionResized, this, [this](int column) {
        if (column != ParticipantsModel::Name)
            m_fitting.start();
    });
    connect(m_participants, &QAbstractItemModel::rowsInserted, &m_fitting,
            qOverload<>(&QTimer::start));
    connect(m_participants, &QAbstractItemModel::modelReset, &m_fitting,
            qOverload<>(&QTimer::start));
}

/// Names have what the columns that stay in sight leave of the width, and as many lines as that
/// needs.
void ParticipantsPanel::fitNames()
{
    QTableView& table = *m_ui->table;
    QHeaderView& header = *table.horizontalHeader();
    int room = table.viewport()->width();
    for (const int column : kInSight)
        room -= header.sectionSize(column);
    const int whole =
        static_cast<const QAbstractItemView&>(table).sizeHintForColumn(ParticipantsModel::Name);
    const int least = std::max(kLeastNames, header.sectionSizeHint(ParticipantsModel::Name));
    header.resizeSection(ParticipantsModel::Name, std::max(least, std::min(room, whole)));
    table.resizeRowsToContents();
}

bool ParticipantsPanel::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::FontChange)
        m_fitting.start();
    return QWidget::eventFilter(watched, event);
}

void ParticipantsPanel::choose(ParticipantId participant)
{
    const QModelIndexList rows =
        m_participants->match(m_participants->index(0, 0), ParticipantsModel::kIdRole,
                              uint{participant.value}, 1, Qt::MatchExactly);
    if (!rows.isEmpty())
        m_ui->table->setCurrentIndex(rows.first());
}

std::optional<ParticipantId> ParticipantsPanel::chosen() const
{
    const QModelIndex current = m_ui->table->currentIndex();
    if (!current.isValid())
        return std::nullopt;
    return ParticipantId{
        static_cast<std::uint16_t>(current.data(ParticipantsModel::kIdRole).toUInt())};
}

void ParticipantsPanel::refresh()
{
    const auto id = chosen();
    const auto standing = id ? m_conduct->standingOf(*id) : ConductModel::Standing{};
    m_ui->mute->setText(standing.isMuted ? tr("Un&mute") : tr("&Mute"));
    m_ui->mute->setToolTip(
        standing.isMuted
            ? tr("What the chosen participant sends has its effect again")
            : tr("The chosen participant sees everything, and what they send has no effect"));
    m_ui->mute->setEnabled(standing.canMute && !standing.isBanned);
    m_ui->remove->setText(standing.isBanned ? tr("L&et back in") : tr("R&emove…"));
    m_ui->remove->setEnabled(standing.canRemove || standing.isBanned);
    m_ui->lock->setChecked(m_conduct->isLocked());
    m_ui->move->setVisible(m_stations->open().size() > 1);
    m_ui->move->setEnabled(id.has_value());
    const QString whom =
        standing.name.isEmpty() ? tr("Choose a participant in the table") : standing.name;
    m_ui->mute->setAccessibleDescription(whom);
    m_ui->remove->setAccessibleDescription(whom);
    m_ui->move->setAccessibleDescription(whom);
    refreshPerson();
    refreshFigures();
    refreshColumns();
}

/// Those that tell the same of everybody take no room.
void ParticipantsPanel::refreshColumns()
{
    QTableView& table = *m_ui->table;
    table.setColumnHidden(ParticipantsModel::Station, m_stations->open().size() < 2);
    table.setColumnHidden(ParticipantsModel::Registration, !m_participants->hasRegistrations());
}

void ParticipantsPanel::offerStations()
{
    m_moves.clear();
    const auto id = chosen();
    if (!id)
        return;
    for (const StationsModel::Row& row : m_stations->open()) {
        QString name = row.name;
        name.replace(QLatin1Char('&'), QStringLiteral("&&")); // no mnemonic
        QAction* move = m_moves.addAction(
            name, this, [this, id = *id, to = row.id] { m_stations->move(id, to); });
        const bool isThere = m_stations->stationOf(*id) == row.id;
        move->setCheckable(isThere);
        move->setChecked(isThere);
        move->setEnabled(!isThere);
    }
}

void ParticipantsPanel::refreshPerson()
{
    const auto id = chosen();
    const QString work = id ? m_people->obstacleToWork(*id) : QString{};
    const QString place = id ? m_people->obstacleToPlace(*id) : QString{};
    m_ui->work->setEnabled(id && work.isEmpty());
    m_ui->place->setEnabled(id && place.isEmpty());
    const QString whom =
        id ? m_conduct->standingOf(*id).name : tr("Choose a participant in the table");
    m_ui->work->setAccessibleDescription(work.isEmpty() ? whom : work);
    m_ui->place->setAccessibleDescription(place.isEmpty() ? whom : place);
    QStringList obstacles{work, place};
    obstacles.removeAll(QString{});
    obstacles.removeDuplicates();
    tell(*m_ui->obstacles, obstacles.join(QLatin1Char{' '}));
}

/// Of the chosen participant, for who has no mouse.
void ParticipantsPanel::refreshFigures()
{
    const QModelIndex same = m_ui->table->currentIndex().siblingAtColumn(ParticipantsModel::Same);
    tell(*m_ui->sameFigures, same.data(Qt::AccessibleDescriptionRole).toString());
}

void ParticipantsPanel::muteOrNot()
{
    if (const auto id = chosen())
        m_conduct->setMuted(*id, !m_conduct->standingOf(*id).isMuted);
}

void ParticipantsPanel::removeOrLetBack()
{
    const auto id = chosen();
    if (!id)
        return;
    const auto standing = m_conduct->standingOf(*id);
    if (standing.isBanned)
        return m_conduct->letBack(*id);
    auto* dialog = new RemoveDialog{standing.name, this};
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, id, role = standing.role] {
        m_conduct->remove(*id, dialog->reason(), dialog->isForGood());
        if (dialog->isForGood())
            Q_EMIT banned(role);
    });
    dialog->open();
}

} // namespace carina
