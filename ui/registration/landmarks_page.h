#pragma once

#include "ui/registration/registration_page.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace carina
{

class ErrorTable;
class LandmarkList;

/// Chooses the landmarks and their positions, and shows the TRE predicted for them.
class LandmarksPage : public RegistrationPage
{
    Q_OBJECT

public:
    explicit LandmarksPage(RegistrationModel& registration);

    void refresh() override;
    [[nodiscard]] QString actionText() const override { return tr("&Use these landmarks"); }
    void act() override { registration().landmarkTask().accept(); }

private:
    void layOut();
    void connectTask();
    void chooseImport();
    void chooseExport();
    [[nodiscard]] QString advice() const;

    QComboBox* m_sets; ///< children of this
    LandmarkList* m_list;
    QCheckBox* m_snapping;
    ErrorTable* m_forecast;
    QLabel* m_advice;
};

} // namespace carina
