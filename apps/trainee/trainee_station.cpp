#include "apps/trainee/trainee_station.h"

#include <utility>

namespace carina
{

TraineeStation::TraineeStation(std::unique_ptr<SessionNode> node, SharedTools::Hardware hardware,
                               SharedTools::PlaceOf placeOf)
    : m_node{std::move(node)},
      m_station{ownStation(*m_node)},
      m_tools{*m_node, std::move(hardware), std::move(placeOf)}
{
    m_tools.onReplaced([this] { showAnew(); });
}

void TraineeStation::setStation(StationId station)
{
    m_station = station;
    m_tools.setStation(station);
    if (m_view)
        m_view->setStation(station);
}

void TraineeStation::showAnew()
{
    const std::unique_ptr<StationView> before =
        std::exchange(m_view, std::make_unique<StationView>(*m_node, m_station, patient().lungs(),
                                                            m_tools.posesOnScreen()));
    if (m_tools.tracker() && !m_manikin)
        m_manikin = std::make_unique<ManikinBreaths>(*m_node, m_tools.source(ToolRole::Chest));
    for (const auto& told : m_onShown)
        told();
}

} // namespace carina
