#pragma once

#include "engine/net/node/session_node.h"
#include "models/respiration/breathing_model.h"

#include <QJsonObject>
#include <QObject>
#include <QWidget>

namespace carina
{

/// An instructor without a person, for a measured demo: starts the session and, once it runs, sets
/// rate and tidal volume, and when somebody else is there turns the virtual patient for a while and
/// puts it back; all by the controls that a person would use.
class ScriptedConsole : public QObject
{
    Q_OBJECT

public:
    /// @pre all outlive this.
    ScriptedConsole(QWidget& window, SessionNode& node, BreathingModel& breathing);

    /// The values in force at the console, and the session time from which on every breath has
    /// them: breathing_rate_per_min, tidal_volume_ml, steady_from_ns (as text, exact). Once the
    /// patient was turned, "action": speed_deg_per_s, from_ns and to_ns when it was, until_ns when
    /// it was put back (as text).
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
    std::optional<SessionTime> m_inForce; ///< since when both are
    QJsonObject m_action;
};

} // namespace carina
