#pragma once

#include "models/console/saved_views.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace carina
{

/// Asks under which name a view is to be saved.
class SaveViewDialog : public QDialog
{
    Q_OBJECT

public:
    /// @pre views outlives the dialog.
    explicit SaveViewDialog(const SavedViews& views, QWidget* parent = nullptr);

    [[nodiscard]] QString name() const;

private:
    void refresh();

    const SavedViews& m_views;
    QLineEdit* m_name;
    QLabel* m_fault;
    QPushButton* m_save;
};

} // namespace carina
