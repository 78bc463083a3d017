#include "models/objects/object_words.h"

#include <QCoreApplication>
#include <QStringList>

namespace carina
{
namespace
{

QString objectWords(const char* text) { return QCoreApplication::translate("ObjectWords", text); }

QString tubeWord() { return objectWords(QT_TRANSLATE_NOOP("ObjectWords", "Second tube")); }

} // namespace

QString groupWord(OrganGroup group)
{
    switch (group) {
    case OrganGroup::Airway:
        return objectWords(QT_TRANSLATE_NOOP("ObjectWords", "Airway"));
    case OrganGroup::Lungs:
        return objectWords(QT_TRANSLATE_NOOP("ObjectWords", "Lungs"));
    case OrganGroup::Skeleton:
        return objectWords(QT_TRANSLATE_NOOP("ObjectWords", "Skeleton"));
    case OrganGroup::Vessels:
        return objectWords(QT_TRANSLATE_NOOP("ObjectWords", "Heart and vessels"));
    case OrganGroup::Muscles:
        return objectWords(QT_TRANSLATE_NOOP("ObjectWords", "Muscles"));
    case OrganGroup::Other:
        return objectWords(QT_TRANSLATE_NOOP("ObjectWords", "Other organs"));
    }
    return {};
}

QString objectWord(const SharedObject& object)
{
    if (object.kind == ObjectKind::SpareTube)
        return tubeWord();
    const auto group =
        object.kind == ObjectKind::OrganGroup ? groupFromName(object.name) : std::nullopt;
    return group ? groupWord(*group) : QString::fromStdString(object.name);
}

QString participantWord(const SessionState& state, ParticipantId id)
{
    const auto found = state.participants().find(id);
    return found == state.participants().end()
               ? objectWords(QT_TRANSLATE_NOOP("ObjectWords", "an unknown participant"))
               : QString::fromStdString(found->second.name);
}

QString liftedWord(const LiftedObject& lifted)
{
    const QString what = lifted.group ? groupWord(*lifted.group) : tubeWord();
    if (lifted.isOwn)
        return objectWords(QT_TRANSLATE_NOOP("ObjectWords", "%1 (you)")).arg(what);
    return objectWords(QT_TRANSLATE_NOOP("ObjectWords", "%1 (%2)"))
        .arg(what, QString::fromStdString(lifted.ownerName));
}

QString liftedText(const std::vector<LiftedObject>& lifted)
{
    QStringList words;
    for (const LiftedObject& each : lifted)
        words += liftedWord(each);
    return words.isEmpty() ? QString{}
                           : objectWords(QT_TRANSLATE_NOOP("ObjectWords", "▲ Lifted out: %1"))
                                 .arg(words.join(QStringLiteral(", ")));
}

} // namespace carina
