#include "apps/viewer/join_question.h"

#include "ui/join_dialog.h"

namespace carina::viewer
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

} // namespace carina::viewer
