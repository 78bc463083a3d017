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

/// The import of an anatomy set: progress of reading; then the recognised role of each surface, the
/// unit and the axes, which a person can correct; then progress of building. It can be cancelled at
/// any time. Files that could not be used are listed.
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
