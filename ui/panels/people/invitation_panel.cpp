#include "ui/panels/people/invitation_panel.h"

#include "models/session/join_form.h"
#include "models/text/shown_as_is.h"
#include "widgets/plain_label.h"
#include "widgets/qr_code.h"

#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
#include <QGridLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QRadioButton>

namespace carina
{
namespace
{

constexpr double kCodeSize = 1.7; ///< as a multiple of the words' size

QLabel* codeLabel(const QString& name)
{
    auto* label = new PlainLabel;
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setPointSizeF(kCodeSize * label->font().pointSizeF());
    font.setBold(true);
    label->setFont(font);
    label->setAccessibleName(name);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    return label;
}

QString questionFor(Role role)
{
    switch (role) {
    case Role::Instructor:
        return InvitationPanel::tr("Give instructors a new code?");
    case Role::Trainee:
        return InvitationPanel::tr("Give trainees a new code?");
    case Role::Observer:
        return InvitationPanel::tr("Give observers a new code?");
    }
    return {};
}

} // namespace

InvitationPanel::InvitationPanel(QWidget* parent)
    : QWidget{parent},
      m_locked{
          new PlainLabel{tr("The session is locked: nobody new comes in. Those who were in it can "
                            "come back. Codes and links are shown again when it is unlocked, "
                            "below the table of participants.")}},
      m_offer{new QWidget},
      m_picture{new QrCode},
      m_reach{new PlainLabel},
      m_certificate{new PlainLabel},
      m_showPicture{new QPushButton{tr("&QR code")}},
      m_copy{new QPushButton{tr("Copy lin&k")}},
      m_newCode{new QPushButton{tr("N&ew code…")}}
{
    auto* rows = new QGridLayout;
    rows->setColumnStretch(1, 1);
    addRow(*rows, Role::Trainee, tr("Trainees"), tr("Code for trainees"));
    addRow(*rows, Role::Observer, tr("Observers"), tr("Code for observers"));
    setFocusProxy(m_invited.at(m_chosen).choice);
    m_picture->setObjectName(QStringLiteral("picture"));
    m_picture->hide();
    m_showPicture->setObjectName(QStringLiteral("showPicture"));
    m_showPicture->setCheckable(true);
    m_showPicture->setToolTip(tr("The link as a QR code, for the camera of another computer"));
    connect(m_showPicture, &QPushButton::toggled, m_picture, &QWidget::setVisible);
    m_reach->setObjectName(QStringLiteral("reach"));
    m_locked->setObjectName(QStringLiteral("locked"));
    m_locked->hide();
    for (QLabel* words : {m_locked, m_reach, m_certificate})
        words->setWordWrap(true);
    m_copy->setObjectName(QStringLiteral("copy"));
    m_copy->setToolTip(
        tr("The link in the QR code: carina-trainee takes it in place of address, port and code"));
    connect(m_copy, &QPushButton::clicked, this,
            [this] { QApplication::clipboard()->setText(m_invited.at(m_chosen).link); });
    m_newCode->setObjectName(QStringLiteral("newCode"));
    m_newCode->setToolTip(tr("Replaces the code of the chosen role; those inside stay"));
    connect(m_newCode, &QPushButton::clicked, this, [this] { askForNewCode(m_chosen, {}); });
    auto* page = new QVBoxLayout{this};
    page->addWidget(m_locked);
    page->addWidget(m_offer, 1);
    auto* column = new QVBoxLayout{m_offer};
    column->setContentsMargins({});
    column->addLayout(rows);
    column->addWidget(m_reach);
    column->addWidget(m_certificate);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_showPicture);
    buttons->addWidget(m_copy);
    buttons->addWidget(m_newCode);
    buttons->addStretch(1);
    column->addLayout(buttons);
    column->addWidget(m_picture, 1);
    column->addStretch();
    page->addStretch();
}

void InvitationPanel::addRow(QGridLayout& rows, Role role, const QString& name,
                             const QString& codeName)
{
    const Invited invited{new QRadioButton{name}, codeLabel(codeName)};
    invited.choice->setObjectName(role == Role::Trainee ? QStringLiteral("trainees")
                                                        : QStringLiteral("observers"));
    invited.choice->setToolTip(tr("Their link is copied, or shown as a QR code"));
    invited.choice->setChecked(role == m_chosen);
    connect(invited.choice, &QRadioButton::clicked, this, [this, role] { choose(role); });
    const int row = rows.rowCount();
    rows.addWidget(invited.choice, row, 0);
    rows.addWidget(invited.code, row, 1);
    m_invited.emplace(role, invited);
}

void InvitationPanel::show(const SessionNode& host, SessionReach reach)
{
    m_codes = host.joinCodes();
    const bool isLocked = host.state()->isLocked();
    m_locked->setVisible(isLocked);
    m_offer->setVisible(!isLocked);
    for (auto& [role, invited] : m_invited) {
        invited.code->setText(QString::fromStdString(m_codes.at(role).text()));
        invited.link = joinLinkText(host, role);
    }
    m_reach->setText(reachText(host, reach));
    m_certificate->setText(certificateText(host));
    m_certificate->setVisible(!m_certificate->text().isEmpty());
    choose(m_chosen);
}

void InvitationPanel::askForNewCode(Role role, const QString& why)
{
    auto* question = new QMessageBox{this};
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setIcon(QMessageBox::Question);
    question->setWindowTitle(tr("New code"));
    question->setText(shownAsIs(questionFor(role)));
    const QString effect =
        tr("%1 and its link are void at once. Those who are in the session stay, and those who "
           "were in it can come back.")
            .arg(QString::fromStdString(m_codes.at(role).text()));
    question->setInformativeText(
        shownAsIs(why.isEmpty() ? effect : why + QLatin1Char(' ') + effect));
    QPushButton* change = question->addButton(tr("&New code"), QMessageBox::AcceptRole);
    change->setObjectName(QStringLiteral("change"));
    QPushButton* keep = question->addButton(QMessageBox::Cancel);
    keep->setObjectName(QStringLiteral("keep"));
    question->setDefaultButton(keep);
    connect(change, &QPushButton::clicked, this, [this, role] { Q_EMIT newCodeWanted(role); });
    question->open();
}

void InvitationPanel::choose(Role role)
{
    m_chosen = role;
    m_picture->setText(m_invited.at(role).link);
    m_picture->setAccessibleName(role == Role::Trainee ? tr("Link for trainees, as a QR code")
                                                       : tr("Link for observers, as a QR code"));
}

} // namespace carina
