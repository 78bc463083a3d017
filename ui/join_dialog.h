#pragma once

#include "models/found_sessions_model.h"
#include "models/join_form.h"

#include <QDialog>

class QComboBox;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace carina
{

/// Asks a person which session to come into, with which code, name and role. A join link in the
/// place of the address fills in what it says. What is missing is said in words, and Join can be
/// pressed once nothing is.
class JoinDialog : public QDialog
{
    Q_OBJECT

public:
    /// @param begin shown first @pre sessions outlives the dialog.
    JoinDialog(FoundSessionsModel& sessions, const JoinForm& begin, QWidget* parent = nullptr);

    [[nodiscard]] JoinForm form() const;

private:
    [[nodiscard]] QLineEdit* field(const char* name, const QString& label, const QString& text);
    void layOut();
    void choose(const QModelIndex& session);
    void readLink();
    void refresh();

    FoundSessionsModel& m_sessions;
    QListView* m_list;
    QLabel* m_searching;
    QLineEdit* m_address;
    QLineEdit* m_port;
    QLineEdit* m_code;
    QLineEdit* m_name;
    QComboBox* m_role;
    QLineEdit* m_certificate;
    QLabel* m_missing;
    QPushButton* m_join;
};

} // namespace carina
