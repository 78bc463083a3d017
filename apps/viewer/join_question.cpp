#include "apps/viewer/join_question.h"

#include "ui/join_dialog.h"

namespace carina::viewer
{

std::optional<JoinSettings> askHowToJoin(JoinSettings settings, const QString& link)
{
    FoundSessionsModel sessions;
    JoinDialog dialog{
        sessions,
        {.address = link,
         .code = settings.code ? QString::fromStdString(settings.code->text()) : QString{},
         .name = QString::fromStdString(settings.participantName),
         .role = settings.role,
         .certificate = settings.certificate ? QString::fromStdString(settings.certificate->name)
                                             : QString{}}};
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    fillIn(settings, dialog.form());
    return settings;
}

} // namespace carina::viewer
