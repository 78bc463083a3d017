#pragma once

#include "ui/registration/registration_page.h"

namespace carina
{

/// Chooses the present tracker for the site.
class TrackerPage : public RegistrationPage
{
    Q_OBJECT

public:
    using RegistrationPage::RegistrationPage;

    [[nodiscard]] QString actionText() const override;
    void act() override;
};

} // namespace carina
