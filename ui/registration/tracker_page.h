#pragma once

#include "models/tracker/pose_recording.h"
#include "ui/registration/registration_page.h"

namespace carina
{

/// Chooses the present tracker for the site, or another one.
class TrackerPage : public RegistrationPage
{
    Q_OBJECT

public:
    TrackerPage(RegistrationModel& registration, PoseRecording& recording);

    [[nodiscard]] QString actionText() const override;
    void act() override;

Q_SIGNALS:
    void anotherWanted();
};

} // namespace carina
