#pragma once

#include "models/patient/set_import.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace carina
{

/// An anatomy set on its way into the program: how far reading it is; then what each of its
/// surfaces was taken for, the unit and the axes, for a person to correct; then how far building it
/// is. It can be stopped at any time. Files that could not be used are named.
class ImportDialog : public QDialog
{
    Q_OBJECT

public:
    /// Starts the import. @pre it outlives the dialog.
    explicit ImportDialog(SetImport& import, QWidget* parent = nullptr);

    void reject() override;

private:
    void layOut();
    void showProgress(double share);
    void review(const SetDraft& draft);
    void fillSurfaces(const SetDraft& draft);
    void fillFrame(const SetDraft& draft);
    [[nodiscard]] QComboBox* roleChoice(const DraftSurface& surface);
    [[nodiscard]] SetCorrections corrections() const;
    void filter(const QString& words);
    void use();
    void end();

    SetImport& m_import;
    SetDraft m_draft;
    QLabel* m_step;
    QProgressBar* m_progress;
    QWidget* m_review;
    QLineEdit* m_words;
    QTableWidget* m_surfaces;
    QComboBox* m_unit;
    QComboBox* m_axes;
    QLabel* m_faults;
    QPushButton* m_use;
};

} // namespace carina
