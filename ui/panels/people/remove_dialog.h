#pragma once

#include <QDialog>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace carina
{

/// Asks why a participant is to be removed, and whether for good.
class RemoveDialog : public QDialog
{
    Q_OBJECT

public:
    explicit RemoveDialog(const QString& name, QWidget* parent = nullptr);

    [[nodiscard]] QString reason() const;
    [[nodiscard]] bool isForGood() const;

private:
    void refresh();

    QLineEdit* m_reason;
    QCheckBox* m_forGood;
    QLabel* m_missing;
    QPushButton* m_remove;
};

} // namespace carina
