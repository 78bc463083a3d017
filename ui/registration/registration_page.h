#pragma once

#include "models/registration/registration_model.h"

#include <QWidget>

namespace carina
{

/// The page of one step at the right of the wizard, and the action of its main button.
class RegistrationPage : public QWidget
{
public:
    /// @pre registration outlives the page.
    explicit RegistrationPage(RegistrationModel& registration) : m_registration{registration} {}

    /// Updates the page after RegistrationModel::changed().
    virtual void refresh() {}
    /// Updates live values, a few times a second.
    virtual void refreshLive() {}

    /// The text of the main button; empty if the page needs none.
    [[nodiscard]] virtual QString actionText() const = 0;
    [[nodiscard]] virtual bool canAct() const { return true; }
    /// Whether this action is the next thing to do: then the button is highlighted, and Return
    /// presses it.
    [[nodiscard]] virtual bool isReady() const { return true; }
    virtual void act() = 0;

    [[nodiscard]] RegistrationModel& registration() const { return m_registration; }

private:
    RegistrationModel& m_registration;
};

} // namespace carina
