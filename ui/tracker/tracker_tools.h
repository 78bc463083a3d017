#pragma once

#include "models/tracker/tracker_form.h"

#include <QWidget>

class QPushButton;
class QTableWidget;

namespace carina
{

/// The tools that a Polaris is to track: for each what it is for, and whether it is plugged in or
/// which definition it has.
class TrackerTools : public QWidget
{
    Q_OBJECT

public:
    explicit TrackerTools(QWidget* parent = nullptr);

    [[nodiscard]] std::vector<FormTool> tools() const;
    void setTools(const std::vector<FormTool>& tools);

    /// Adds a wireless tool, for the first role that is free.
    void addDefinition(const QString& file);

Q_SIGNALS:
    void changed();

private:
    void add(FormTool tool);
    void addPluggedIn();
    void askForDefinitions();
    void removeChosen();
    void refreshButtons();
    [[nodiscard]] ToolRole freeRole() const;

    QTableWidget* m_table;
    QPushButton* m_addPluggedIn;
    QPushButton* m_remove;
};

} // namespace carina
