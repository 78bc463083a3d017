#pragma once

#include "models/registration/registration_model.h"

#include <QWidget>

namespace carina
{

/// The right-hand side of the wizard for one step, and what its main button does.
class RegistrationPage : public QWidget
{
public:
    /// @pre registration outlives the page.
    explicit RegistrationPage(RegistrationModel& registration) : m_registration{registration} {}

    /// Takes in that the registration changed.
    virtual void refresh() {}
    /// Takes in what moves by itself, a few times a second.
    virtual void refreshLive() {}

    /// What the main button says; empty where the page needs none.
    [[nodiscard]] virtual QString actionText() const = 0;
    [[nodiscard]] virtual bool canAct() const { return true; }
    /// Whether that is what to do next: then the button is in colour, and Return presses it.
    [[nodiscard]] virtual bool isReady() const { return true; }
    virtual void act() = 0;

    [[nodiscard]] RegistrationModel& registration() const { return m_registration; }

private:
    RegistrationModel& m_registration;
};

} // namespace carina
