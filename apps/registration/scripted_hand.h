#pragma once

#include "apps/registration/simulated_workplace.h"
#include "models/registration/registration_model.h"

#include <QObject>
#include <QTimer>

#include <random>

namespace carina
{

/// The FLE of the scripted hand: RMS distance of a touch from the true landmark, in three
/// dimensions.
inline constexpr Length kLocalisationError = millimetres(1.0);
/// The same of a touch of a tool, whose places are edges and openings.
inline constexpr Length kToolTouchError = millimetres(0.35);

/// A scripted technician's hand that moves the simulated stylus as the wizard requests. In Stylus
/// it pivots the stylus with its tip in the divot while the wizard waits for that; in Touch and
/// Verify, and while the airway or a tool is touched, it holds the tip at the next point, with a
/// localisation error. Otherwise the stylus is parked.
class ScriptedHand : public QObject
{
    Q_OBJECT

public:
    /// @pre both outlive this.
    ScriptedHand(const RegistrationModel& registration, const SimulatedWorkplace& workplace);

private:
    enum class Task : std::uint8_t { Park, Swing, Hold };
    struct Order {
        Task task = Task::Park;
        QString place{};          ///< to hold at
        Vec3 p_TQ = Vec3::Zero(); ///< where it truly is
        Length error = kLocalisationError;

        friend bool operator==(const Order&, const Order&) = default;
    };

    void work();
    [[nodiscard]] Order wanted() const;
    [[nodiscard]] Order wantedOfTool() const;
    void obey(const Order& order);
    [[nodiscard]] Vec3 localised(const Order& order);

    const RegistrationModel& m_registration;
    const SimulatedWorkplace& m_workplace;
    Order m_order;
    std::mt19937 m_random{2004};
    QTimer m_timer;
};

} // namespace carina
