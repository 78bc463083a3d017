#include "apps/instructor/shown_station.h"

#include "engine/io/anatomy_set/anatomy_cache.h"

#include <utility>

namespace carina
{

ShownStation::ShownStation(SessionNode& node, StationId station, SharedPatientModel first,
                           ObjectPoses own)
    : m_node{node},
      m_station{station},
      m_patient{node, station, std::move(first), AnatomyCache::defaultFolder()},
      m_own{std::move(own)},
      m_view{std::make_unique<StationView>(node, station, m_patient.patient()->lungs(), m_own)}
{
}

/// Whether the patient that is drawn lies at the station, or none was chosen for it.
bool ShownStation::isDrawn() const
{
    const auto state = m_node.state();
    const auto station = state->stations().find(m_station);
    return station == state->stations().end() || station->second.anatomyHash.empty()
           || station->second.anatomyHash == m_patient.patient()->contentHash();
}

void ShownStation::setStation(StationId station)
{
    m_station = station;
    if (isDrawn())
        m_view->setStation(station);
    m_patient.setStation(station);
}

void ShownStation::onShown(std::function<void(const PatientModel&, StationView&)> callback)
{
    m_patient.follow([this, callback = std::move(callback)](const SharedPatientModel& another) {
        auto view = std::make_unique<StationView>(m_node, m_station, another->lungs(), m_own);
        callback(*another, *view);
        m_view = std::move(view);
        return Result<void>{};
    });
}

} // namespace carina
