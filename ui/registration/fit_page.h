#pragma once

#include "ui/registration/registration_page.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace carina
{

class ErrorTable;
class LandmarkList;

/// The fit: residuals and warnings, the expected TRE at the targets, and the refinement on a
/// surface.
class FitPage : public RegistrationPage
{
    Q_OBJECT

public:
    explicit FitPage(RegistrationModel& registration);

    void refresh() override;
    void refreshLive() override;
    [[nodiscard]] QString actionText() const override;
    [[nodiscard]] bool canAct() const override;
    void act() override;

private:
    void layOut();
    void swabOrRefine();
    void refreshSwab();

    LandmarkList* m_list; ///< children of this
    QLabel* m_legend;
    QLabel* m_findings;
    ErrorTable* m_expected;
    QLabel* m_localisation;
    QLabel* m_swabbed;
    QComboBox* m_surface;
    QPushButton* m_swab;
    QPushButton* m_cancel;
};

} // namespace carina
