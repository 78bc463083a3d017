#include "ui/invitation_panel.h"

#include "models/join_form.h"

#include <QFontDatabase>
#include <QFormLayout>
#include <QLabel>

namespace carina
{
namespace
{

constexpr double kCodeSize = 1.7; ///< as a multiple of the words' size

QLabel* codeLabel(const QString& name)
{
    auto* label = new QLabel;
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setPointSizeF(kCodeSize * label->font().pointSizeF());
    font.setBold(true);
    label->setFont(font);
    label->setAccessibleName(name);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

} // namespace

InvitationPanel::InvitationPanel(QWidget* parent)
    : QWidget{parent},
      m_trainee{codeLabel(tr("Code for trainees"))},
      m_observer{codeLabel(tr("Code for observers"))},
      m_reach{new QLabel}
{
    m_reach->setWordWrap(true);
    auto* form = new QFormLayout{this};
    form->addRow(tr("Trainees"), m_trainee);
    form->addRow(tr("Observers"), m_observer);
    form->addRow(m_reach);
}

void InvitationPanel::show(const SessionNode& host)
{
    const JoinCodes codes = host.joinCodes();
    m_trainee->setText(QString::fromStdString(codes.at(Role::Trainee).text()));
    m_observer->setText(QString::fromStdString(codes.at(Role::Observer).text()));
    m_reach->setText(reachText(host));
}

} // namespace carina
