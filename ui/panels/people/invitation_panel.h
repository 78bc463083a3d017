#pragma once

#include "models/session/session_model.h"
#include "models/session/session_plan.h"

#include <QWidget>

#include <map>

class QGridLayout;
class QLabel;
class QPushButton;
class QRadioButton;

namespace carina
{

class QrCode;

/// The join codes of the session, large enough to be read across a room, who can reach the session,
/// and, on request, the join link of the chosen role as a QR code. The QR code grows with the
/// panel, up to a full screen. While the session is locked there is nothing to invite to, and the
/// panel says so instead.
class InvitationPanel : public QWidget
{
    Q_OBJECT

public:
    explicit InvitationPanel(QWidget* parent = nullptr);

    using QWidget::show;
    /// Shows the codes of a hosting node, as they are now, and who can reach it.
    void show(const SessionNode& host, SessionReach reach);

    /// Asks whether a role is to have a new code. @param why it may need one; empty: it was wanted
    void askForNewCode(Role role, const QString& why);

Q_SIGNALS:
    /// A role is to have a new code; the user has confirmed it.
    void newCodeWanted(carina::Role role);

private:
    struct Invited {
        QRadioButton* choice;
        QLabel* code;
        QString link{};
    };

    void addRow(QGridLayout& rows, Role role, const QString& name, const QString& codeName);
    void choose(Role role);

    std::map<Role, Invited> m_invited;
    JoinCodes m_codes;
    Role m_chosen = Role::Trainee;
    QLabel* m_locked;
    QWidget* m_offer; ///< all that follows
    QrCode* m_picture;
    QLabel* m_reach;
    QLabel* m_certificate; ///< hidden if the host has none
    QPushButton* m_showPicture;
    QPushButton* m_copy;
    QPushButton* m_newCode;
};

} // namespace carina
