#include "ui/panels/people/people_menus.h"

#include <algorithm>

namespace carina
{
namespace
{

/// A name is no shortcut.
QString asText(QString name) { return name.replace(QLatin1Char('&'), QStringLiteral("&&")); }

} // namespace

EyesMenu::EyesMenu(const PeopleModel& people, const QString& title, QWidget* parent)
    : QMenu{title, parent}, m_people{people}
{
    connect(this, &QMenu::aboutToShow, this, &EyesMenu::fill);
    fill();
}

void EyesMenu::add(const QString& text, std::optional<ParticipantId> participant)
{
    QAction* action = addAction(text, this, [this, participant] {
        m_chosen = participant;
        Q_EMIT chosen(participant);
    });
    action->setCheckable(true);
    action->setChecked(participant == m_chosen);
}

void EyesMenu::fill()
{
    clear();
    add(tr("&Own view"), std::nullopt);
    for (const PeopleModel::Person& person : m_people.people())
        if (person.hasHead && !person.isSelf)
            add(tr("Through the eyes of %1").arg(asText(person.name)), person.id);
    if (actions().size() == 1)
        addAction(tr("Nobody else shares a head"))->setEnabled(false);
}

PlaceMenu::PlaceMenu(PeopleModel& people, Whom whom, Head ownHead, const QString& title,
                     QWidget* parent)
    : QMenu{title, parent}, m_people{people}, m_whom{std::move(whom)}, m_ownHead{std::move(ownHead)}
{
    add(tr("As &tracked"), std::nullopt, "asTracked");
    add(tr("At the patient's &head"), PatientSide::Head, "atHead");
    add(tr("At the patient's &right"), PatientSide::Right, "atRight");
    add(tr("At the patient's &left"), PatientSide::Left, "atLeft");
    add(tr("At the patient's &feet"), PatientSide::Feet, "atFeet");
    connect(this, &QMenu::aboutToShow, this, [this] {
        const auto chosen = m_whom();
        const auto person = chosen ? m_people.person(*chosen) : std::nullopt;
        for (QAction* action : actions())
            action->setEnabled(person && person->canBePlaced);
    });
}

void PlaceMenu::add(const QString& text, std::optional<PatientSide> side, const char* name)
{
    QAction* action = addAction(text, this, [this, side] {
        if (const auto whom = m_whom())
            m_people.place(*whom, side, m_ownHead());
    });
    action->setObjectName(QLatin1StringView{name});
}

WorkMenu::WorkMenu(PeopleModel& people, const QString& title, QWidget* parent)
    : QMenu{title, parent}, m_people{people}
{
    connect(this, &QMenu::aboutToShow, this, &WorkMenu::fill);
    fill();
}

void WorkMenu::fill()
{
    clear();
    addAction(asText(m_people.workText()))->setEnabled(false);
    for (const PeopleModel::Person& person : m_people.people())
        if (person.canBeGiven)
            addAction(person.isSelf ? tr("&Take up the work")
                                    : tr("Hand over to %1").arg(asText(person.name)),
                      this, [this, id = person.id] { m_people.giveWork(id); });
}

} // namespace carina
