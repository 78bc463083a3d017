#include "models/airway/head_position_model.h"

#include "engine/core/expects.h"
#include "models/airway/head_positions.h"

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

QString HeadPositionModel::inForceText() const { return headFiguresText(present()); }

} // namespace carina
