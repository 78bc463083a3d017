#include "models/airway/head_position_model.h"

#include "engine/core/expects.h"
#include "models/airway/head_positions.h"
#include "models/patient/session_patient.h"

#include <utility>

namespace carina
{

HeadPositionModel::HeadPositionModel(SessionModel& session, StationId station, QObject* parent)
    : GradualDecisionOf{session, station, howDecided(), parent}
{
}

HeadPositionModel::Kind HeadPositionModel::howDecided()
{
    return {.decidedAt = [](const Station& station,
                            SessionTime t) { return station.headPosition.decidedAt(t); },
            .presentAt = headPositionAt,
            .overAt = [](const Station& station,
                         SessionTime t) { return station.headPosition.overAt(t); },
            .factOf = [](const HeadPosition& position, Duration over) -> FactBody {
                return fact::HeadPositionSet{position, over};
            },
            .textOf =
                [](const HeadPosition& position) {
                    return tr("Head position → %1").arg(headPositionText(position));
                }};
}

void HeadPositionModel::setPosition(const HeadPosition& position)
{
    CARINA_EXPECTS(withinReach(position) == position);
    request(position);
}

void HeadPositionModel::setPatient(const SessionPatient& patient)
{
    m_patient = &patient;
    refresh();
}

HeadPosition HeadPositionModel::present() const
{
    const HeadPosition position = presentValue();
    return m_lying ? m_lying->neck(position).position() : position;
}

QString HeadPositionModel::inForceText() const
{
    const QString figures = headFiguresText(present());
    const QString limit = limitText();
    return limit.isEmpty()
               ? figures
               : tr("%1 (%2)", "position of the head; what stops it").arg(figures, limit);
}

QString HeadPositionModel::limitText() const
{
    return present().flexion < presentValue().flexion ? tr("this patient's neck flexes no farther")
                                                      : QString{};
}

bool HeadPositionModel::refreshMore()
{
    SharedPatientModel lying = m_patient ? m_patient->patient() : nullptr;
    if (lying && !liesAt(*session().node().state(), stations().shown, *lying))
        lying.reset();
    return std::exchange(m_lying, lying) != lying;
}

} // namespace carina
