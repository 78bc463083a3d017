#include "ui/instructor/arrows_open_lists.h"

#include <QComboBox>
#include <QKeyEvent>

namespace carina
{
namespace
{

bool stepsThroughList(int key)
{
    switch (key) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown:
    case Qt::Key_Home:
    case Qt::Key_End:
        return true;
    default:
        return false;
    }
}

/// An open list gets its keys itself.
class ListOpener : public QObject
{
public:
    using QObject::QObject;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (event->type() != QEvent::KeyPress
            || !stepsThroughList(static_cast<QKeyEvent*>(event)->key()))
            return false;
        static_cast<QComboBox*>(watched)->showPopup();
        return true;
    }
};

} // namespace

void letArrowsOpenLists(QWidget& panel)
{
    auto* opener = new ListOpener{&panel};
    for (QComboBox* list : panel.findChildren<QComboBox*>())
        list->installEventFilter(opener);
}

} // namespace carina
