#include "widgets/step_list.h"

#include "widgets/plain_label.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace carina
{
namespace
{

constexpr int kIndent = 24; ///< of what is said of a step, pixels

QString stateShape(StepState state)
{
    switch (state) {
    case StepState::Open:
        return QStringLiteral("○");
    case StepState::Waits:
        return QStringLiteral("·");
    case StepState::Begun:
        return QStringLiteral("◐");
    case StepState::Done:
        return QStringLiteral("✓");
    case StepState::Stale:
        return QStringLiteral("▲");
    }
    return {};
}

QString stateWord(StepState state)
{
    switch (state) {
    case StepState::Open:
        return StepList::tr("open");
    case StepState::Waits:
        return StepList::tr("not yet");
    case StepState::Begun:
        return StepList::tr("begun");
    case StepState::Done:
        return StepList::tr("done");
    case StepState::Stale:
        return StepList::tr("redo");
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
    while (m_rows.size() < steps.size())
        addRow();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        m_rows[i].button->setVisible(i < steps.size());
        m_rows[i].why->setVisible(i < steps.size() && !steps[i].why.isEmpty());
        if (i < steps.size())
            show(m_rows[i], int(i) + 1, steps[i]);
    }
}

void StepList::addRow()
{
    const int step = int(m_rows.size());
    auto* button = new QPushButton{this};
    button->setObjectName(QStringLiteral("step%1").arg(step + 1));
    button->setStyleSheet(QStringLiteral("text-align: left"));
    connect(button, &QPushButton::clicked, this, [this, step] { Q_EMIT chosen(step); });
    auto* why = new PlainLabel{this};
    why->setWordWrap(true);
    why->setIndent(kIndent);
    layout()->addWidget(button);
    layout()->addWidget(why);
    m_rows.push_back({button, why});
}

void StepList::show(const Row& row, int number, const Step& step)
{
    row.button->setText(tr("%1  &%2  %3 – %4", "shape of its state, number, task, its state")
                            .arg(stateShape(step.state))
                            .arg(number)
                            .arg(step.title, stateWord(step.state)));
    row.button->setAccessibleName(
        step.isHere
            ? tr("Step %1, %2: %3, shown now").arg(number).arg(step.title, stateWord(step.state))
            : tr("Step %1, %2: %3").arg(number).arg(step.title, stateWord(step.state)));
    row.button->setAccessibleDescription(step.why);
    row.button->setDefault(step.isHere);
    row.why->setText(step.why);
}

} // namespace carina
