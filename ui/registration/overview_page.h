#pragma once

#include "ui/registration/registration_page.h"

class QLabel;
class QLineEdit;
class QPushButton;

namespace carina
{

class ManikinBox;

/// Summary of the site: its state, its operator, its manikin, and import and export of its file.
class OverviewPage : public RegistrationPage
{
    Q_OBJECT

public:
    explicit OverviewPage(RegistrationModel& registration);

    void refresh() override;
    [[nodiscard]] QString actionText() const override;
    void act() override;

Q_SIGNALS:
    /// Everything is done, and the person closes the wizard.
    void finished();
    void reportWanted();

private:
    void layOut();
    void chooseExport();
    void chooseImport();

    QLabel* m_health; ///< children of this
    QLineEdit* m_operator;
    QPushButton* m_moved;
    QLabel* m_whyNotMoved;
    QPushButton* m_report;
    ManikinBox* m_manikin;
};

} // namespace carina
