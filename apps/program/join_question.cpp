#include "apps/program/join_question.h"

#include "ui/join/join_dialog.h"

namespace carina::program
{
Entered askHowToJoin(const JoinSettings& settings, const QString& link, bool isComplete,
                     bool isNamed)
{
    FoundSessionsModel sessions;
    Entrance entrance{settings};
    JoinForm begin = formOf(settings);
    if (!isComplete)
        begin.address = link;
    if (!isComplete && !isNamed)
        begin.name = lastName(settings.tokens);
    JoinDialog dialog{sessions, entrance, begin};
    if (isComplete)
        dialog.accept();
    if (!entrance.isIn() && dialog.exec() != QDialog::Accepted)
        return {};
    keepLastName(entrance.settings().tokens, dialog.form().name);
    return {entrance.take(), entrance.settings().role};
}

} // namespace carina::program
