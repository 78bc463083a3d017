#pragma once

#include "ui/registration/registration_page.h"

namespace carina
{

/// Takes the tracker that is there.
class TrackerPage : public RegistrationPage
{
    Q_OBJECT

public:
    using RegistrationPage::RegistrationPage;

    [[nodiscard]] QString actionText() const override;
    void act() override;
};

} // namespace carina
