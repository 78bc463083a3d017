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

/// By which codes others come into the session, large enough to be read across a room, who can
/// reach the session at all, and, where a person wants to see it, the link of the role that is
/// chosen as a QR code. It grows with the panel, up to a screen of its own.
class InvitationPanel : public QWidget
{
    Q_OBJECT

public:
    explicit InvitationPanel(QWidget* parent = nullptr);

    using QWidget::show;
    /// The codes of a node that hosts.
    void show(const SessionNode& host);

private:
    struct Invited {
        QRadioButton* choice;
        QLabel* code;
        QString link{};
    };

    void addRow(QGridLayout& rows, Role role, const QString& name, const QString& codeName);
    void choose(Role role);

    std::map<Role, Invited> m_invited;
    Role m_chosen = Role::Trainee;
    QrCode* m_picture;
    QLabel* m_reach;
    QLabel* m_certificate; ///< hidden where the host has none
    QPushButton* m_showPicture;
    QPushButton* m_copy;
};

} // namespace carina
