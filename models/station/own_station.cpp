#include "models/station/own_station.h"

#include <algorithm>
#include <utility>

namespace carina
{

OwnStation::OwnStation(SessionModel& session, QObject* parent)
    : QObject{parent}, m_session{session}, m_id{ownStation(session.node())}
{
    connect(&m_session, &SessionModel::changed, this, &OwnStation::look);
}

void OwnStation::look()
{
    const StationId now = ownStation(m_session.node());
    if (std::exchange(m_id, now) != now)
        Q_EMIT changed(now);
}

QString stationText(const SessionNode& node)
{
    const auto state = node.state();
    const auto open = std::ranges::count_if(state->stations(),
                                            [](const auto& entry) { return !entry.second.closed; });
    const auto own = state->stations().find(ownStation(node));
    if (open < 2 || own == state->stations().end())
        return {};
    return OwnStation::tr("Station: %1").arg(QString::fromStdString(own->second.name));
}

} // namespace carina
