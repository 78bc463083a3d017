#include "ui/instructor/intubation_line.h"

#include "models/intubation/intubation_timeline.h"

#include <QAccessible>

#include <algorithm>
#include <utility>

namespace carina
{
namespace
{

constexpr int kLeastStepsWidth = 160; ///< pixels

} // namespace

IntubationLine::IntubationLine(QWidget* parent) : QListView{parent}
{
    setAccessibleName(tr("Steps of the intubation"));
    setSelectionMode(QAbstractItemView::SingleSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setUniformItemSizes(true);
    setTextElideMode(Qt::ElideRight);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setTabKeyNavigation(false);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    hide();
}

void IntubationLine::setTimeline(IntubationTimeline& timeline)
{
    m_timeline = &timeline;
    setModel(&timeline);
    connect(&timeline, &QAbstractItemModel::modelReset, this, &IntubationLine::follow);
    follow();
}

void IntubationLine::choose(SessionTime moment)
{
    const QModelIndex step = m_timeline->index(m_timeline->rowAt(moment), 0);
    if (!step.isValid())
        return;
    setFocus(Qt::OtherFocusReason);
    setCurrentIndex(step);
    scrollTo(step, QAbstractItemView::PositionAtCenter);
}

/// Down to the newest, unless a person reads further up.
void IntubationLine::follow()
{
    const int rows = model()->rowCount();
    const bool wasHidden = isHidden();
    setVisible(rows > 0);
    if (rows == 0) {
        m_newest.clear();
        return;
    }
    if (!hasFocus() || wasHidden)
        scrollToBottom();
    const QString newest = model()->index(rows - 1, 0).data().toString();
    if (std::exchange(m_newest, newest) == newest)
        return;
    setAccessibleDescription(newest);
    QAccessibleEvent event{this, QAccessible::Alert};
    QAccessible::updateAccessibility(&event);
}

QSize IntubationLine::sizeHint() const
{
    const int row = std::max(sizeHintForRow(0), fontMetrics().height());
    return {kLeastStepsWidth, kShownSteps * row + 2 * frameWidth()};
}

} // namespace carina
