#include "apps/instructor/shown_station.h"

#include "engine/io/anatomy_set/anatomy_cache.h"

#include <utility>

namespace carina
{
namespace
{

/// What is pointed with in the picture, and the tools of the tracker.
ObjectPoses together(const ObjectPoses& pointer, ObjectPoses tools)
{
    tools.at = [pointer = pointer.at, at = std::move(tools.at)](ObjectKind kind, SessionTime t) {
        return kind == ObjectKind::Pointer ? pointer(kind, t) : at(kind, t);
    };
    return tools;
}

} // namespace

ShownStation::ShownStation(SessionNode& node, StationId station, const SharedPatientModel& first,
                           const ObjectPoses& pointer, SharedTools& tools)
    : m_node{node},
      m_station{station},
      m_drawnAt{station},
      m_patient{node, station, first, AnatomyCache::defaultFolder()},
      m_tools{tools},
      m_own{together(pointer, tools.posesOnScreen())}
{
    m_tools.onReplaced([this] { showAnew(); });
    lay(first);
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
    if (isDrawn()) {
        m_drawnAt = station;
        m_view->setStation(station);
        m_tools.setStation(station);
    }
    m_patient.setStation(station);
}

void ShownStation::onShown(std::function<void(const PatientModel&, StationView&)> callback)
{
    m_onShown = std::move(callback);
    m_patient.follow([this](const SharedPatientModel& another) {
        lay(another);
        return Result<void>{};
    });
}

/// In any case: a patient is to be seen also where the tools cannot be.
void ShownStation::lay(const SharedPatientModel& patient)
{
    m_drawnAt = m_station;
    m_tools.setStation(m_station);
    m_tools.layAnyhow(patient);
}

/// Another tracker alone changes nothing of the picture but its tools, which are looked up in each
/// frame.
void ShownStation::showAnew()
{
    if (m_tools.patient() == m_drawn)
        return;
    const SharedPatientModel before = std::exchange(m_drawn, m_tools.patient());
    auto view = std::make_unique<StationView>(m_node, m_drawnAt, m_drawn->lungs(), m_own);
    if (m_onShown)
        m_onShown(*m_drawn, *view);
    m_view = std::move(view);
}

} // namespace carina
