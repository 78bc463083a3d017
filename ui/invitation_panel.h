#pragma once

#include "models/session_model.h"

#include <QWidget>

class QLabel;

namespace carina
{

/// By which codes others come into the session, large enough to be read across a room, and who can
/// reach it at all.
class InvitationPanel : public QWidget
{
    Q_OBJECT

public:
    explicit InvitationPanel(QWidget* parent = nullptr);

    using QWidget::show;
    /// The codes of a node that hosts.
    void show(const SessionNode& host);

private:
    QLabel* m_trainee;
    QLabel* m_observer;
    QLabel* m_reach;
};

} // namespace carina
