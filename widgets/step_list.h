#pragma once

#include <QString>
#include <QWidget>

#include <cstdint>
#include <vector>

class QLabel;
class QPushButton;

namespace carina
{

enum class StepState : std::uint8_t { Open, Waits, Begun, Done, Stale };

/// The steps of a task as a column of buttons, each with its number, its state as mark and word,
/// the shortcut Alt + number, and a line below that says why it is not done. All can be entered.
class StepList : public QWidget
{
    Q_OBJECT

public:
    struct Step {
        QString title;
        StepState state = StepState::Open;
        bool isHere = false; ///< the step shown now
        QString why{};       ///< why it waits or is stale; may be empty
    };

    explicit StepList(QWidget* parent = nullptr);

    void setSteps(const std::vector<Step>& steps);

Q_SIGNALS:
    /// A step was chosen, counted from 0.
    void chosen(int step);

private:
    struct Row {
        QPushButton* button; ///< both are children of this
        QLabel* why;
    };

    void addRow();
    static void show(const Row& row, int number, const Step& step);

    std::vector<Row> m_rows;
};

} // namespace carina
