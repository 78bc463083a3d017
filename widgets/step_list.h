#pragma once

#include <QString>
#include <QWidget>

#include <cstdint>
#include <vector>

class QPushButton;

namespace carina
{

enum class StepState : std::uint8_t { Open, Now, Done };

/// The steps of a task as a column of buttons, each with its number, its state as shape and word,
/// and Alt and its number as shortcut. Which step is shown as entered is up to who feeds it.
class StepList : public QWidget
{
    Q_OBJECT

public:
    struct Step {
        QString title;
        StepState state = StepState::Open;
        QString whyNot{}; ///< why the step cannot be entered; empty where it can
    };

    explicit StepList(QWidget* parent = nullptr);

    void setSteps(const std::vector<Step>& steps);

Q_SIGNALS:
    /// A step was chosen, counted from 0.
    void chosen(int step);

private:
    void addButton();
    static void show(QPushButton& button, int number, const Step& step);

    std::vector<QPushButton*> m_buttons; ///< children of this
};

} // namespace carina
