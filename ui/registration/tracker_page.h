#pragma once

#include "ui/registration/registration_page.h"

namespace carina
{

/// Chooses the present tracker for the site, or another one.
class TrackerPage : public RegistrationPage
{
    Q_OBJECT

public:
    explicit TrackerPage(RegistrationModel& registration);

    [[nodiscard]] QString actionText() const override;
    void act() override;

Q_SIGNALS:
    void anotherWanted();
};

} // namespace carina
