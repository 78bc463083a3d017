#pragma once

#include "models/session/entrance.h"
#include "models/session/found_sessions_model.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace carina
{

/// Asks a person which session to join, with which code, name and role. The session that they were
/// in last is chosen as soon as it is found, or else the only one, unless they chose. A join link
/// pasted into the address field fills in the fields that it contains. Missing fields are named,
/// and Join is enabled once none is missing. The dialog is accepted when the host admits the
/// person; after a refusal the wrong field gets the focus and all input is kept.
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
    /// Stops joining; closes the dialog if no attempt is running.
    void reject() override;

protected:
    bool event(QEvent* event) override;

private:
    [[nodiscard]] QLineEdit* field(const char* name, const QString& label, const QString& text);
    void layOut();
    void choose(const QModelIndex& session);
    void chooseByItself();
    [[nodiscard]] bool isLeftToItself() const;
    void focusWhatIsMissing(bool isKnown);
    void showMore(bool shown);
    void readLink();
    void follow();
    void refresh();
    void tellSearching();
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
    QLineEdit* m_station;
    QLineEdit* m_certificate;
    QFormLayout* m_form;
    QPushButton* m_more; ///< shows what few need
    QWidget* m_typed;    ///< parent of all input fields above
    QLabel* m_missing;
    QPushButton* m_join;
    JoinForm m_offered;             ///< whose place nobody typed
    bool m_choosesByItself = false; ///< at present
    bool m_wasChosen = false;       ///< a person took a session from the list
};

} // namespace carina
