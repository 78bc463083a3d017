#pragma once

#include "engine/net/node/session_node.h"
#include "engine/session/respiration/respiration_follower.h"

#include <QObject>
#include <QTimer>

#include <map>

namespace carina
{

/// At the host: writes a checkpoint of every station's patient, of the breathing and of the body at
/// one time, to the fact log every kCheckpointEvery while the session runs. Participants who join
/// late start from it, and all others continue from it, so that no program drifts.
class CheckpointKeeper : public QObject
{
    Q_OBJECT

public:
    /// @pre node is the host's, and outlives this.
    explicit CheckpointKeeper(SessionNode& node, QObject* parent = nullptr);

    /// Writes one for each station now.
    void keep();

private:
    SessionNode& m_node;
    std::map<StationId, RespirationFollower> m_stations;
    QTimer m_timer;
};

} // namespace carina
