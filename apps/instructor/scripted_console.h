#pragma once

#include "engine/net/node/session_node.h"
#include "models/respiration/breathing_model.h"

#include <QJsonObject>
#include <QObject>
#include <QWidget>

namespace carina
{

/// A scripted instructor for a measured demonstration: starts the session and, once it runs, sets
/// rate and tidal volume; when another participant is present it rotates the virtual patient for a
/// while and resets it. It operates the same controls as a person.
class ScriptedConsole : public QObject
{
    Q_OBJECT

public:
    /// @pre all outlive this.
    ScriptedConsole(QWidget& window, SessionNode& node, BreathingModel& breathing);

    /// The values in force at the console, and the session time from which every breath has them:
    /// breathing_rate_per_min, tidal_volume_ml, steady_from_ns (as text, exact). After the rotation
    /// also "action": speed_deg_per_s, from_ns and to_ns of the rotation, and until_ns of the reset
    /// (as text).
    [[nodiscard]] QJsonObject report() const;

private:
    void work();
    void waitForCompany();
    void turnPatient();
    void press(const char* button);
    void note(const char* key);

    QWidget& m_window;
    SessionNode& m_node;
    BreathingModel& m_breathing;
    std::optional<SessionTime> m_inForce; ///< since when both values are in force
    QJsonObject m_action;
};

} // namespace carina
