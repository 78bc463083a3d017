#include "widgets/step_list.h"

#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{
namespace
{

QString stateShape(StepState state)
{
    switch (state) {
    case StepState::Open:
        return QStringLiteral("○");
    case StepState::Now:
        return QStringLiteral("●");
    case StepState::Done:
        return QStringLiteral("✓");
    }
    return {};
}

QString stateWord(StepState state)
{
    switch (state) {
    case StepState::Open:
        return StepList::tr("open");
    case StepState::Now:
        return StepList::tr("now");
    case StepState::Done:
        return StepList::tr("done");
    }
    return {};
}

} // namespace

StepList::StepList(QWidget* parent) : QWidget{parent}
{
    auto* column = new QVBoxLayout{this};
    column->setContentsMargins({});
    column->setAlignment(Qt::AlignTop);
}

void StepList::setSteps(const std::vector<Step>& steps)
{
    while (m_buttons.size() < steps.size())
        addButton();
    for (std::size_t i = 0; i < m_buttons.size(); ++i) {
        m_buttons[i]->setVisible(i < steps.size());
        if (i < steps.size())
            show(*m_buttons[i], int(i) + 1, steps[i]);
    }
}

void StepList::addButton()
{
    const int step = int(m_buttons.size());
    auto* button = new QPushButton{this};
    button->setObjectName(QStringLiteral("step%1").arg(step + 1));
    button->setStyleSheet(QStringLiteral("text-align: left"));
    connect(button, &QPushButton::clicked, this, [this, step] { Q_EMIT chosen(step); });
    layout()->addWidget(button);
    m_buttons.push_back(button);
}

void StepList::show(QPushButton& button, int number, const Step& step)
{
    button.setText(QStringLiteral("%1  &%2  %3 – %4")
                       .arg(stateShape(step.state))
                       .arg(number)
                       .arg(step.title, stateWord(step.state)));
    button.setAccessibleName(
        tr("Step %1, %2: %3").arg(number).arg(step.title, stateWord(step.state)));
    button.setDefault(step.state == StepState::Now);
    button.setEnabled(step.whyNot.isEmpty());
    button.setToolTip(step.whyNot);
}

} // namespace carina
