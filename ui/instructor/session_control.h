#pragma once

#include "models/session/session_model.h"
#include "widgets/second_press.h"

#include <QToolBar>

class QLabel;

namespace carina
{

/// What a console's bar begins with: the session with its phase and running time, and the actions
/// that start, pause and end it. Each is as wide as it ever gets, so that nothing beside it moves
/// under the pointer when a word changes.
class SessionControl : public QObject
{
    Q_OBJECT

public:
    struct Actions {
        QAction& start;
        QAction& pause;
        QAction& end;
    };

    /// @pre all outlive this.
    SessionControl(QToolBar& bar, SessionModel& session, const Actions& actions);

    void refresh();

private:
    void addPhase();
    void addActions();
    void refreshStartAndPause();

    QToolBar& m_bar;
    SessionModel& m_session;
    Actions m_actions;
    QLabel* m_phase;
    SecondPress m_end;
};

} // namespace carina
