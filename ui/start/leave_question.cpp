#include "ui/start/leave_question.h"

#include "models/text/shown_as_is.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

namespace carina
{
namespace
{

class LeaveWords
{
    Q_DECLARE_TR_FUNCTIONS(carina::LeaveQuestion)
};

} // namespace

Leaving askBeforeLeaving(const QString& whoLosesWhat, bool canEnd, QWidget* parent)
{
    QMessageBox box{parent};
    box.setIcon(QMessageBox::Question);
    box.setWindowTitle(LeaveWords::tr("Leave the session?"));
    box.setText(shownAsIs(LeaveWords::tr("The session goes on.")));
    box.setInformativeText(shownAsIs(whoLosesWhat));
    QPushButton* stay = box.addButton(LeaveWords::tr("S&tay"), QMessageBox::RejectRole);
    stay->setObjectName(QStringLiteral("stay"));
    QPushButton* close =
        box.addButton(LeaveWords::tr("&Close, and resume later"), QMessageBox::AcceptRole);
    close->setObjectName(QStringLiteral("closeForNow"));
    QPushButton* start =
        box.addButton(LeaveWords::tr("Close it, to the &start page"), QMessageBox::AcceptRole);
    start->setObjectName(QStringLiteral("toStartPage"));
    QPushButton* end =
        box.addButton(LeaveWords::tr("&End it for everyone"), QMessageBox::DestructiveRole);
    end->setObjectName(QStringLiteral("endForAll"));
    end->setEnabled(canEnd);
    box.setDefaultButton(stay);
    box.setEscapeButton(stay);
    box.exec();
    if (box.clickedButton() == close)
        return Leaving::CloseForNow;
    if (box.clickedButton() == start)
        return Leaving::ToStartPage;
    return box.clickedButton() == end ? Leaving::EndForAll : Leaving::Stay;
}

} // namespace carina
