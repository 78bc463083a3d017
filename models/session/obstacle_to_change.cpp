#include "models/session/obstacle_to_change.h"

#include "models/errors/error_text.h"

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
    static QString watches() { return tr("Observers watch; trainees handle the tube."); }
    static QString isElsewhere() { return tr("You are at another station."); }
};

/// Why nobody in this place, whatever their role, changes anything.
QString obstacleToAll(const SessionModel& session)
{
    if (!session.node().state()->participants().contains(session.node().self()))
        return ObstacleWords::notAdmitted();
    return session.phase() == SessionPhase::Ended ? ObstacleWords::ended() : QString{};
}

} // namespace

QString obstacleToChange(const SessionModel& session)
{
    if (const QString obstacle = obstacleToAll(session); !obstacle.isEmpty())
        return obstacle;
    const auto state = session.node().state();
    return state->participants().at(session.node().self()).role == Role::Instructor
               ? QString{}
               : ObstacleWords::notAnInstructor();
}

QString obstacleToTube(const SessionModel& session, StationId station)
{
    if (const QString obstacle = obstacleToAll(session); !obstacle.isEmpty())
        return obstacle;
    const auto state = session.node().state();
    const Participant& person = state->participants().at(session.node().self());
    if (person.muted)
        return errorText({Errc::Muted, {}});
    if (person.role == Role::Observer)
        return ObstacleWords::watches();
    if (person.role == Role::Trainee && person.station != station)
        return ObstacleWords::isElsewhere();
    return {};
}

} // namespace carina
