#include "ui/instructor/session_control.h"

#include "models/text/shown_as_is.h"
#include "widgets/plain_label.h"
#include "widgets/spoken_label.h"

#include <QAction>

#include <algorithm>

namespace carina
{
namespace
{

constexpr int kWidestName = 190; ///< pixels, of the session; the tool tip has all of it
const QString kNameGap = QStringLiteral("   ");

/// Told by shape besides the word.
QString phaseShape(SessionPhase phase)
{
    switch (phase) {
    case SessionPhase::Prepared:
        return QStringLiteral("○");
    case SessionPhase::Running:
        return QStringLiteral("●");
    case SessionPhase::Paused:
        return QStringLiteral("❙❙");
    case SessionPhase::Ended:
        return QStringLiteral("■");
    }
    return {};
}

/// Makes an action's button as wide as it ever gets, so that nothing beside it moves under the
/// pointer when its words change.
void reserve(const QToolBar& bar, QAction& action, const QString& longest)
{
    const QString now = action.text();
    action.setText(longest);
    QWidget* button = bar.widgetForAction(&action);
    button->ensurePolished();
    button->setMinimumWidth(button->sizeHint().width());
    action.setText(now);
}

/// The phase with its mark and, once it has begun, its time.
QString phaseWords(SessionPhase phase, const QString& time)
{
    const QString word = SessionModel::textOf(phase);
    if (phase == SessionPhase::Prepared)
        return SessionControl::tr("%1 %2", "mark; phase").arg(phaseShape(phase), word);
    return SessionControl::tr("%1 %2 %3", "mark; phase; running time")
        .arg(phaseShape(phase), word, time);
}

} // namespace

SessionControl::SessionControl(QToolBar& bar, SessionModel& session, const Actions& actions)
    : QObject{&bar}, m_bar{bar}, m_session{session}, m_actions{actions}, m_phase{new PlainLabel}
{
    addPhase();
    addActions();
    connect(&m_actions.start, &QAction::triggered, &m_session, &SessionModel::start);
    connect(&m_actions.pause, &QAction::triggered, &m_session, &SessionModel::pause);
    connect(&m_actions.end, &QAction::triggered, &m_end, &SecondPress::press);
    connect(&m_end, &SecondPress::changed, this, &SessionControl::refresh);
    connect(&m_end, &SecondPress::confirmed, this, [this] {
        m_session.end();
        refresh();
    });
    refresh();
}

void SessionControl::addPhase()
{
    m_bar.addWidget(m_phase);
    m_phase->setMargin(8);
    QFont bold = m_phase->font(); // that of the bar
    bold.setBold(true);
    m_phase->setFont(bold);
    const QFontMetrics metrics{bold};
    int widest = 0;
    for (const SessionPhase phase :
         {SessionPhase::Prepared, SessionPhase::Running, SessionPhase::Paused, SessionPhase::Ended})
        widest = std::max(widest,
                          metrics.horizontalAdvance(phaseWords(phase, QStringLiteral("888:88"))));
    const int name = std::min(kWidestName, metrics.horizontalAdvance(m_session.name()))
                     + metrics.horizontalAdvance(kNameGap);
    m_phase->setFixedWidth(2 * m_phase->margin() + name + widest);
    m_phase->setToolTip(shownAsIs(m_session.name()));
}

void SessionControl::addActions()
{
    for (QAction* action : {&m_actions.start, &m_actions.pause, &m_actions.end}) {
        action->setAutoRepeat(false);
        m_bar.addAction(action);
        m_bar.widgetForAction(action)->setFocusPolicy(Qt::TabFocus);
    }
    reserve(m_bar, m_actions.start, tr("Go on"));
    reserve(m_bar, m_actions.end, tr("Really end?"));
}

/// One takes turns with the other, and has the keyboard then: from a button that is disabled it
/// would go on to the next, which ends the session.
void SessionControl::refreshStartAndPause()
{
    const bool canPause = m_session.canPause();
    QAction& next = canPause ? m_actions.pause : m_actions.start;
    QAction& last = canPause ? m_actions.start : m_actions.pause;
    next.setEnabled(canPause || m_session.canStart());
    const QWidget* pressed = m_bar.widgetForAction(&last);
    if (next.isEnabled() && pressed->window()->focusWidget() == pressed)
        m_bar.widgetForAction(&next)->setFocus();
    last.setEnabled(false);
}

void SessionControl::refresh()
{
    const SessionPhase phase = m_session.phase();
    const QString words = phaseWords(phase, m_session.runningTimeText());
    const QString name =
        m_phase->fontMetrics().elidedText(m_session.name(), Qt::ElideRight, kWidestName);
    m_phase->setText(name + kNameGap + words);
    speakInstead(*m_phase, tr("%1: %2", "session; its phase").arg(m_session.name(), words));
    m_actions.start.setText(phase == SessionPhase::Paused ? tr("Go on") : tr("Start"));
    refreshStartAndPause();
    m_actions.end.setEnabled(m_session.canEnd());
    m_actions.end.setText(m_end.isAsked() ? tr("Really end?") : tr("End"));
}

} // namespace carina
