#pragma once

#include "ui/registration/registration_page.h"

class QPushButton;

namespace carina
{

class LandmarkList;

/// Records the touches of the landmarks on the manikin, and re-registers a moved manikin.
class TouchPage : public RegistrationPage
{
    Q_OBJECT

public:
    explicit TouchPage(RegistrationModel& registration);

    void refresh() override;
    [[nodiscard]] QString actionText() const override { return tr("&Take this point"); }
    [[nodiscard]] bool canAct() const override { return registration().nextLandmark().has_value(); }
    void act() override { registration().takeNow(); }

private:
    LandmarkList* m_list; ///< children of this
    QPushButton* m_keep;
};

} // namespace carina
