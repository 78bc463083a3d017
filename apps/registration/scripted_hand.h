#pragma once

#include "apps/registration/simulated_workplace.h"
#include "models/registration_model.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <random>

namespace carina
{

/// How far from a landmark's true place somebody touches it: root mean square, in three dimensions.
inline constexpr Length kLocalisationError = millimetres(1.0);

/// The hand of a technician without a person: it does with the stylus what the wizard asks for. In
/// Stylus it sets the tip into the divot and swings it when that is asked for; in Touch it holds
/// the tip where it takes the next landmark to be; in Verify it holds it at one landmark after
/// another, for three seconds each. Otherwise the stylus is parked.
class ScriptedHand : public QObject
{
    Q_OBJECT

public:
    /// @pre both outlive this.
    ScriptedHand(const RegistrationModel& registration, const SimulatedWorkplace& workplace);

private:
    enum class Task : std::uint8_t { Park, Ready, Swing, Hold };
    struct Order {
        Task task = Task::Park;
        std::size_t landmark = 0; ///< to hold at
        int round = 0;            ///< how often it was held at before

        friend bool operator==(const Order&, const Order&) = default;
    };

    void work();
    [[nodiscard]] Order wanted() const;
    [[nodiscard]] Order wantedToVerify() const;
    void obey(const Order& order);
    [[nodiscard]] Vec3 localised(std::size_t landmark);

    const RegistrationModel& m_registration;
    const SimulatedWorkplace& m_workplace;
    Order m_order;
    SiteStep m_step;
    QElapsedTimer m_inStep;
    std::mt19937 m_random{2004};
    QTimer m_timer;
};

} // namespace carina
