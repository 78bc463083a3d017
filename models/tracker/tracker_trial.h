#pragma once

#include "engine/net/devices/device_tracker.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

namespace carina
{

/// Tries whether a tracker answers, before it is used: connects to it, and says what is there. It
/// goes on until it is ended, so that a tracker may be switched on meanwhile.
class TrackerTrial : public QObject
{
    Q_OBJECT

public:
    static constexpr int kInterval_ms = 200;

    enum class State : std::uint8_t {
        Idle,
        Looking, ///< and nothing is known yet
        Answers,
        Silent, ///< nothing answers, as far as is known
    };

    TrackerTrial();

    /// @returns the errors of DeviceTracker::make and start.
    [[nodiscard]] Result<void> begin(const TrackerDescription& description);
    /// Gives the port free.
    void end();

    [[nodiscard]] State state() const { return m_state; }
    /// The names of the tools that a server sends, as far as they are known.
    [[nodiscard]] QStringList sentTools() const;
    /// What was found, and of each tool how it is seen: a sentence and lines beneath. Of a tracker
    /// that does not answer what to look at. Empty while idle.
    [[nodiscard]] QString text() const;

Q_SIGNALS:
    void changed();

private:
    void look();
    [[nodiscard]] QString trouble() const;
    [[nodiscard]] QString foundText(const DeviceFound& found) const;

    std::string m_address;
    bool m_isServer = false; ///< of OpenIGTLink
    std::unique_ptr<DeviceTracker> m_tracker;
    State m_state = State::Idle;
    QTimer m_timer;
};

} // namespace carina
