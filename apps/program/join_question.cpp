#include "apps/program/join_question.h"

#include "ui/join/join_dialog.h"

namespace carina::program
{
namespace
{

/// What the window begins with.
JoinForm firstForm(const KnownEntry& known)
{
    JoinForm form = formOf(known.settings);
    if (known.isComplete)
        return form;
    form.address = known.link;
    if (!known.isNamed) {
        form.name.clear();
        form = withLastPerson(form, known.settings.tokens);
    }
    return known.isAnother ? form : withLastPlace(form, known.settings.tokens);
}

} // namespace

Entered askHowToJoin(const KnownEntry& known)
{
    FoundSessionsModel sessions;
    Entrance entrance{known.settings};
    const JoinForm begin = firstForm(known);
    if (const auto last = lastSession(begin, known.settings.tokens); last && !known.isAnother)
        sessions.lookFor(*last);
    JoinDialog dialog{sessions, entrance, begin};
    if (known.isComplete)
        dialog.accept();
    if (!entrance.isIn() && dialog.exec() != QDialog::Accepted)
        return {};
    keepLastTime(entrance.settings().tokens, dialog.form());
    return {entrance.take(), entrance.settings().role};
}

} // namespace carina::program
