#include "ui/message_line.h"

#include <QAccessible>

namespace carina
{

void MessageLine::warn(const QString& problem)
{
    say(problem.isEmpty() ? QString{} : tr("▲ %1", "a warning").arg(problem));
}

void MessageLine::confirm(const QString& notice) { say(tr("✓ %1", "what was done").arg(notice)); }

void MessageLine::say(const QString& message)
{
    if (text() == message)
        return;
    setText(message);
    setAccessibleDescription(message);
    QAccessibleEvent event{this, QAccessible::Alert};
    if (!message.isEmpty())
        QAccessible::updateAccessibility(&event);
}

} // namespace carina
