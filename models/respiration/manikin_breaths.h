#pragma once

#include "engine/net/node/session_node.h"
#include "engine/tracking/breath_detector.h"

#include <QObject>
#include <QTimer>

namespace carina
{

/// Tells the session when the manikin of a station breathes, as a marker on its chest shows it, so
/// that the virtual patient breathes with it.
class ManikinBreaths : public QObject
{
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 15; ///< no sample of a tracker at 60 Hz is missed

    /// @param marker the newest sample of the marker in A; nothing where there is none
    /// @pre node outlives this.
    ManikinBreaths(SessionNode& node, StationId station, PoseSource marker,
                   QObject* parent = nullptr);

    /// Takes the newest sample.
    void look();

private:
    SessionNode& m_node;
    StationId m_station;
    PoseSource m_marker;
    BreathDetector m_detector;
    QTimer m_timer;
};

} // namespace carina
