#pragma once

#include "ui/registration/registration_page.h"

class QLabel;
class QPushButton;

namespace carina
{

/// Calibrates the tip of the stylus and the axis of its shaft, and shows the accuracy.
class StylusPage : public RegistrationPage
{
    Q_OBJECT

public:
    explicit StylusPage(RegistrationModel& registration);

    void refresh() override;
    void refreshLive() override;
    [[nodiscard]] QString actionText() const override;
    [[nodiscard]] bool isReady() const override;
    void act() override;

private:
    [[nodiscard]] QString calibration() const;
    [[nodiscard]] QString swinging() const;

    QLabel* m_tip; ///< children of this
    QLabel* m_live;
    QPushButton* m_spin;
};

} // namespace carina
