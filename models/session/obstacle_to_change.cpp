#include "models/session/obstacle_to_change.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

class ObstacleWords
{
    Q_DECLARE_TR_FUNCTIONS(carina::ObstacleToChange)

public:
    static QString notAdmitted() { return tr("Wait until the session has let you in."); }
    static QString ended() { return tr("The session has ended."); }
    static QString notAnInstructor() { return tr("Only an instructor changes the patient."); }
};

} // namespace

QString obstacleToChange(const SessionModel& session)
{
    const auto state = session.node().state();
    const auto person = state->participants().find(session.node().self());
    if (person == state->participants().end())
        return ObstacleWords::notAdmitted();
    if (session.phase() == SessionPhase::Ended)
        return ObstacleWords::ended();
    if (person->second.role != Role::Instructor)
        return ObstacleWords::notAnInstructor();
    return {};
}

} // namespace carina
