#pragma once

#include "engine/net/node/session_node.h"
#include "engine/session/respiration/respiration_follower.h"

#include <QObject>
#include <QTimer>

#include <map>

namespace carina
{

/// At the host: leaves a checkpoint of every station's breathing in the log, for those who join
/// late and for those who would drift, every kCheckpointEvery while the session runs.
class CheckpointKeeper : public QObject
{
    Q_OBJECT

public:
    /// @pre node is the host's, and outlives this.
    explicit CheckpointKeeper(SessionNode& node, QObject* parent = nullptr);

    /// One of each station, now.
    void keep();

private:
    SessionNode& m_node;
    std::map<StationId, RespirationFollower> m_stations;
    QTimer m_timer;
};

} // namespace carina
