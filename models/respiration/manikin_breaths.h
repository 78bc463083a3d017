#pragma once

#include "engine/net/node/session_node.h"
#include "engine/tracking/breath_detector.h"

#include <QObject>
#include <QTimer>

namespace carina
{

/// Detects the breaths of the manikin at this participant's station from a marker on its chest and
/// reports them to the session, so that the virtual patient breathes in synchrony.
class ManikinBreaths : public QObject
{
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 15; ///< no sample of a tracker at 60 Hz is missed

    /// @param marker returns the newest sample of the marker in A; std::nullopt if there is none
    /// @pre node outlives this.
    ManikinBreaths(SessionNode& node, PoseSource marker, QObject* parent = nullptr);

    /// Processes the newest sample; a timer calls it every kInterval_ms.
    void look();

private:
    SessionNode& m_node;
    PoseSource m_marker;
    BreathDetector m_detector;
    QTimer m_timer;
};

} // namespace carina
