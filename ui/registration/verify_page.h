#pragma once

#include "ui/registration/registration_page.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace carina
{

/// Verifies the registration at points that its fit did not use, and records the verdict.
class VerifyPage : public RegistrationPage
{
    Q_OBJECT

public:
    explicit VerifyPage(RegistrationModel& registration);

    void refresh() override;
    void refreshLive() override;
    [[nodiscard]] QString actionText() const override;
    [[nodiscard]] bool canAct() const override;
    [[nodiscard]] bool isReady() const override;
    void act() override;

private:
    void fillPoints();
    void refreshName();
    [[nodiscard]] QString verdict() const;
    [[nodiscard]] QString verdictOfErrors() const;
    [[nodiscard]] QString tolerated() const;
    [[nodiscard]] QString rule() const;

    QTableWidget* m_points; ///< children of this
    QLabel* m_verdict;
    QLabel* m_nameWanted; ///< why the name is asked for, while it is not known
    QLineEdit* m_name;
    QLabel* m_stylus;
    QPushButton* m_take;
};

} // namespace carina
