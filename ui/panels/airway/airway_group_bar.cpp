#include "ui/panels/airway/airway_group_bar.h"

#include "models/airway/airway_words.h"
#include "models/text/shown_as_is.h"

#include <QGridLayout>
#include <QPushButton>

#include <algorithm>
#include <iterator>

namespace carina
{
namespace
{

constexpr int kHeadingColumns = 4;
constexpr int kHeadingGap = 2; ///< pixels

QByteArray nameOf(const AirwayGroup& group)
{
    return {group.name.data(), qsizetype(group.name.size())};
}

const AirwayGroup* groupCalled(const QByteArray& name)
{
    return airwayGroupNamed({name.constData(), static_cast<std::size_t>(name.size())});
}

/// "Tongue oedema, Trismus"
QString listed(std::span<const AirwayEventKind> kinds)
{
    QStringList words;
    std::ranges::transform(kinds, std::back_inserter(words), eventText);
    return words.join(QStringLiteral(", "));
}

} // namespace

AirwayGroupBar::AirwayGroupBar(QWidget* parent)
    : QWidget{parent}, m_chosen{nameOf(airwayGroups().front())}
{
    auto* grid = new QGridLayout{this};
    grid->setContentsMargins({});
    grid->setSpacing(kHeadingGap);
    for (const AirwayGroup& group : airwayGroups()) {
        m_headings.push_back(addHeading(nameOf(group), int(m_headings.size())));
        m_headings.back()->setText(groupText(group));
    }
    m_all = addHeading(kAll, int(m_headings.size()));
    m_all->setText(tr("All event&s"));
    m_all->setToolTip(tr("Every event of the airway, one group below the other"));
    choose(m_chosen);
}

/// In columns of one width, so that none moves when the words of another grow.
QPushButton* AirwayGroupBar::addHeading(const QByteArray& name, int place)
{
    auto* heading = new QPushButton;
    heading->setObjectName(QStringLiteral("airwayGroup_") + QString::fromLatin1(name));
    heading->setProperty("isLow", true); // by the style sheet
    heading->setCheckable(true);
    connect(heading, &QPushButton::clicked, this, [this, name] {
        choose(name);
        Q_EMIT chosenByHand();
    });
    auto* grid = static_cast<QGridLayout*>(layout());
    grid->addWidget(heading, place / kHeadingColumns, place % kHeadingColumns);
    grid->setColumnStretch(place % kHeadingColumns, 1);
    return heading;
}

void AirwayGroupBar::addBehind(QWidget& widget)
{
    const int place = int(m_headings.size()) + 1; // the last heading is that of all
    static_cast<QGridLayout*>(layout())->addWidget(&widget, place / kHeadingColumns,
                                                   place % kHeadingColumns);
}

void AirwayGroupBar::setModel(const AirwayEventModel& model)
{
    m_model = &model;
    connect(&model, &AirwayEventModel::changed, this, &AirwayGroupBar::refresh);
    refresh();
}

void AirwayGroupBar::choose(const QByteArray& name)
{
    if (name == kAll || groupCalled(name))
        m_chosen = name;
    for (std::size_t place = 0; place < m_headings.size(); ++place) {
        const bool isChosen = nameOf(airwayGroups()[place]) == m_chosen;
        m_headings[place]->setChecked(isChosen);
        if (isChosen)
            m_heading = m_headings[place];
    }
    m_all->setChecked(m_chosen == kAll);
    if (m_all->isChecked())
        m_heading = m_all;
}

bool AirwayGroupBar::shows(AirwayEventKind kind) const
{
    if (m_chosen == kAll)
        return true;
    const auto kinds = groupCalled(m_chosen)->kinds;
    return std::ranges::find(kinds, kind) != kinds.end();
}

void AirwayGroupBar::refresh()
{
    for (std::size_t place = 0; place < m_headings.size(); ++place)
        refreshHeading(place);
}

/// What is set is told where the rows are out of sight, too; "set" would leave no room for four
/// headings beside each other.
void AirwayGroupBar::refreshHeading(std::size_t place)
{
    const AirwayGroup& group = airwayGroups()[place];
    const AirwayEvents set = setOf(group);
    AirwayEvents notShown = set;
    std::erase_if(notShown, [this](const AirwayEvent& event) {
        return m_model->limits().canShow(event.kind);
    });
    QPushButton& heading = *m_headings[place];
    QString words = groupText(group);
    QStringList told{listed(group.kinds)};
    if (!set.empty()) {
        words = notShown.empty()
                    ? tr("%1 · %2", "group of events; how many are set").arg(words).arg(set.size())
                    : tr("%1 ▲ %2", "group of events; how many are set, of which some not shown")
                          .arg(words)
                          .arg(set.size());
        told += tr("Set: %1").arg(eventsText(set));
    }
    if (!notShown.empty())
        told += tr("Not shown by this patient: %1").arg(eventsText(notShown));
    heading.setText(words);
    heading.setToolTip(shownAsIs(told.join(QLatin1Char{'\n'})));
    heading.setAccessibleDescription(told.join(QStringLiteral(". ")));
}

AirwayEvents AirwayGroupBar::setOf(const AirwayGroup& group) const
{
    AirwayEvents set = m_model->events();
    std::erase_if(set, [&group](const AirwayEvent& event) {
        return std::ranges::find(group.kinds, event.kind) == group.kinds.end();
    });
    return set;
}

} // namespace carina
