#pragma once

#include "models/tracker/tracker_form.h"
#include "models/tracker/tracker_trial.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace carina
{

/// The fields for a server of OpenIGTLink, such as PLUS: its address, how it is asked for poses,
/// and its tools, each with the name by which the server sends it and its role. The server can be
/// looked at before: the names that it sends are told, and are added by one button, each with the
/// role that its name tells.
class ServerFields : public QWidget
{
    Q_OBJECT

public:
    explicit ServerFields(QWidget* parent = nullptr);

    void fill(const TrackerForm& form);
    /// Puts what is in the fields into a form.
    void read(TrackerForm& form) const;
    /// Leaves the server.
    void endTrial();

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] QWidget* toolsWithButtons();
    void layOut();
    void add(const ServedTool& tool);
    void addSent();
    void removeChosen();
    void look();
    void edited();
    void refresh();
    [[nodiscard]] std::vector<ServedTool> tools() const;

    TrackerTrial m_trial;
    QLineEdit* m_address;
    QComboBox* m_asked;
    QTableWidget* m_table;
    QPushButton* m_add;
    QPushButton* m_addSent;
    QPushButton* m_remove;
    QPushButton* m_try;
    QLabel* m_found;
};

} // namespace carina
