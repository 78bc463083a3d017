#include "models/session/session_plan.h"

#include "engine/session/facts/fact_rules.h"
#include "models/station/stations_model.h"

#include <QCoreApplication>

namespace carina
{
namespace
{

class PlanWords
{
    Q_DECLARE_TR_FUNCTIONS(carina::SessionPlan)
};

} // namespace

QString reachMeaning(SessionReach reach)
{
    switch (reach) {
    case SessionReach::ThisComputer:
        return PlanWords::tr("Only programs on this computer can join; nothing is open to others.");
    case SessionReach::Network:
        return PlanWords::tr("Computers in the same network find the session by its name, and join "
                             "with the code of their role.");
    case SessionReach::ByLink:
        return PlanWords::tr("Nobody finds the session by searching: who has its link, or address, "
                             "port and code, joins from wherever this computer is reached.");
    }
    return {};
}

QString faultOf(const SessionPlan& plan)
{
    const fact::SessionCreated created{plan.name.trimmed().toStdString(), std::string(32, '0')};
    if (plan.name.trimmed().isEmpty())
        return PlanWords::tr("Type a name for the session.");
    if (!checkBody(created))
        return PlanWords::tr("Type a shorter name for the session, without special characters.");
    return StationsModel::faultOfPatient(plan.patient);
}

} // namespace carina
