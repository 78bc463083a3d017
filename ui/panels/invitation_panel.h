#pragma once

#include "models/session/session_model.h"

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
/// panel, up to a full screen.
class InvitationPanel : public QWidget
{
    Q_OBJECT

public:
    explicit InvitationPanel(QWidget* parent = nullptr);

    using QWidget::show;
    /// Shows the codes of a hosting node, as they are now.
    void show(const SessionNode& host);

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
    void askForNewCode();

    std::map<Role, Invited> m_invited;
    Role m_chosen = Role::Trainee;
    QrCode* m_picture;
    QLabel* m_reach;
    QLabel* m_certificate; ///< hidden if the host has none
    QPushButton* m_showPicture;
    QPushButton* m_copy;
    QPushButton* m_newCode;
};

} // namespace carina
