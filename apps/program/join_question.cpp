#include "apps/program/join_question.h"

#include "ui/join/join_dialog.h"

namespace carina::program
{

Entered askHowToJoin(const JoinSettings& settings, const QString& link, bool isComplete)
{
    FoundSessionsModel sessions;
    Entrance entrance{settings};
    JoinForm begin = formOf(settings);
    if (!isComplete)
        begin.address = link;
    JoinDialog dialog{sessions, entrance, begin};
    if (isComplete)
        dialog.accept();
    if (!entrance.isIn() && dialog.exec() != QDialog::Accepted)
        return {};
    return {entrance.take(), entrance.settings().role};
}

} // namespace carina::program
