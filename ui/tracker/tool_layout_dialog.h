#pragma once

#include "models/tracker/tool_layout.h"

#include <QDialog>

#include <array>

class QLabel;
class QPushButton;

namespace carina
{

class CheckedDoubleSpinBox;
class CheckedSpinBox;
class MarkerLayout;
class MessageLine;

/// Shows the markers of a tool definition of NDI (.rom) from the front and from the side, moves
/// them, and saves a new definition.
class ToolLayoutDialog : public QDialog
{
    Q_OBJECT

public:
    explicit ToolLayoutDialog(QWidget* parent = nullptr);

    /// What the buttons do with the file that a person chose.
    void openFile(const QString& file);
    void saveTo(const QString& file);

    [[nodiscard]] const ToolLayout& layoutShown() const { return m_layout; }

private:
    void connectControls();
    void layOut();
    void refresh();
    void showMarker(int marker);
    void moveMarker();
    [[nodiscard]] int marker() const;

    ToolLayout m_layout;
    QLabel* m_title; ///< children of this
    MarkerLayout* m_picture;
    CheckedSpinBox* m_number;
    std::array<CheckedDoubleSpinBox*, 3> m_places;
    QPushButton* m_open;
    QPushButton* m_undo;
    QPushButton* m_redo;
    QPushButton* m_save;
    MessageLine* m_message;
};

} // namespace carina
