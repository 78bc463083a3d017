#include "models/station/people_words.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

QString peopleWords(const char* text) { return QCoreApplication::translate("PeopleWords", text); }

} // namespace

QString nameBeside(const PersonPose& person, ParticipantId worker)
{
    const QString name = QString::fromStdString(person.ownerName);
    switch (person.kind) {
    case ObjectKind::Head:
        return person.owner == worker
                   ? peopleWords(QT_TRANSLATE_NOOP("PeopleWords", "● %1, at work")).arg(name)
                   : name;
    case ObjectKind::Tube:
        if (person.isOwn)
            return peopleWords(QT_TRANSLATE_NOOP("PeopleWords", "Your tube"));
        return peopleWords(QT_TRANSLATE_NOOP("PeopleWords", "Tube of %1")).arg(name);
    case ObjectKind::Laryngoscope:
    case ObjectKind::Jaw:
    case ObjectKind::Stylus:
    case ObjectKind::Patient:
    case ObjectKind::Hand:
    case ObjectKind::OrganGroup:
    case ObjectKind::SpareTube:
    case ObjectKind::View:
    case ObjectKind::Pointer:
        break;
    }
    return {};
}

QString throughEyesText(const SessionState& state, const StationMoment& moment,
                        ParticipantId participant)
{
    const auto who = state.participants().find(participant);
    const QString name =
        who == state.participants().end() ? QString{} : QString::fromStdString(who->second.name);
    const PersonPose* head = headOf(moment.people, participant);
    if (head == nullptr || head->pose.validity == Validity::Lost)
        return peopleWords(
                   QT_TRANSLATE_NOOP("PeopleWords",
                                     "▲ Through the eyes of %1, whose head is not tracked now"))
            .arg(name);
    return peopleWords(QT_TRANSLATE_NOOP("PeopleWords", "● Through the eyes of %1")).arg(name);
}

} // namespace carina
