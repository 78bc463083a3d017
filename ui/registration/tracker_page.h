#pragma once

#include "models/tracker/pose_recording.h"
#include "ui/registration/registration_page.h"

namespace carina
{

class DevicesBox;

/// Chooses the present tracker for the site, or another one; and the site's devices.
class TrackerPage : public RegistrationPage
{
    Q_OBJECT

public:
    TrackerPage(RegistrationModel& registration, PoseRecording& recording);

    void refresh() override;
    void refreshLive() override;
    [[nodiscard]] QString actionText() const override;
    void act() override;

Q_SIGNALS:
    void anotherWanted();
    /// The site's devices are to be used in place of the present tracker.
    void devicesWanted();

private:
    DevicesBox* m_devices; ///< a child of this
};

} // namespace carina
