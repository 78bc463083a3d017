#pragma once

#include "models/session/entrance.h"
#include "models/session/found_sessions_model.h"

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
/// pressed once nothing is. It is accepted once the session has let them in; a session that refuses
/// leads back to the field that is wrong, with what was typed.
class JoinDialog : public QDialog
{
    Q_OBJECT

public:
    /// @param begin shown first @pre sessions and entrance outlive the dialog.
    JoinDialog(FoundSessionsModel& sessions, Entrance& entrance, const JoinForm& begin,
               QWidget* parent = nullptr);

    [[nodiscard]] JoinForm form() const;

    /// Joins, if nothing is missing.
    void accept() override;
    /// Stops joining; leaves where nothing is under way.
    void reject() override;

private:
    [[nodiscard]] QLineEdit* field(const char* name, const QString& label, const QString& text);
    void layOut();
    void choose(const QModelIndex& session);
    void readLink();
    void follow();
    void refresh();
    [[nodiscard]] QLineEdit* fieldOf(JoinField field) const;

    FoundSessionsModel& m_sessions;
    Entrance& m_entrance;
    QListView* m_list;
    QLabel* m_searching;
    QLineEdit* m_address;
    QLineEdit* m_port;
    QLineEdit* m_code;
    QLineEdit* m_name;
    QComboBox* m_role;
    QLineEdit* m_certificate;
    QWidget* m_typed; ///< all of the above that a person types or chooses
    QLabel* m_missing;
    QPushButton* m_join;
};

} // namespace carina
