#include "models/respiration/checkpoint_keeper.h"

namespace carina
{

CheckpointKeeper::CheckpointKeeper(SessionNode& node, QObject* parent)
    : QObject{parent}, m_node{node}
{
    // At once, too: after a gap all programs then continue from the host's state.
    QMetaObject::invokeMethod(this, &CheckpointKeeper::keep, Qt::QueuedConnection);
    m_timer.callOnTimeout(this, &CheckpointKeeper::keep);
    m_timer.start(std::chrono::duration_cast<std::chrono::milliseconds>(kCheckpointEvery));
}

void CheckpointKeeper::keep()
{
    // The time first: whatever is decided that the state does not have yet counts from later.
    const auto now = m_node.now();
    const auto state = m_node.state();
    if (!now)
        return;
    for (const auto& [id, station] : state->stations()) {
        if (station.closed || !station.respiration.runsAt(*now))
            continue;
        for (const FactBody& part : m_stations[id].at(station.respiration, *now).checkpoint())
            m_node.propose(id, part);
    }
}

} // namespace carina
