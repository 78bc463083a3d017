#include "ui/instructor/reading_order.h"

#include <QScrollArea>
#include <QStatusBar>
#include <QToolBar>

#include <algorithm>
#include <array>
#include <vector>

namespace carina
{
namespace
{

struct Stop {
    QWidget* control = nullptr;
    std::array<int, 3> pane{}; ///< kind, left and top: panes are read in this order
    QRect place{};             ///< in the window
};

bool isTabStop(const QWidget& control)
{
    return (control.focusPolicy() & Qt::TabFocus) != 0 && !control.focusProxy()
           && control.isVisible() && control.isEnabled();
}

QRect placeIn(const QWidget& window, const QWidget& control)
{
    return {control.mapTo(&window, QPoint{}), control.size()};
}

/// Of a child of the window.
std::array<int, 3> paneOrder(const QWidget& pane)
{
    const int kind = qobject_cast<const QToolBar*>(&pane)     ? 0
                     : qobject_cast<const QStatusBar*>(&pane) ? 2
                                                              : 1;
    return {kind, pane.x(), pane.y()};
}

std::vector<Stop> stopsOf(const QWidget& window)
{
    std::vector<Stop> stops;
    for (QWidget* control : window.findChildren<QWidget*>()) {
        if (control->window() != &window
            || (!isTabStop(*control) && control != window.focusWidget()))
            continue;
        const QWidget* pane = control;
        while (pane->parentWidget() != &window)
            pane = pane->parentWidget();
        stops.push_back({control, paneOrder(*pane), placeIn(window, *control)});
    }
    return stops;
}

/// Whether two controls stand beside each other. Controls of one row may have unequal heights; what
/// lies over the edge of a picture is no row with it.
bool isOneRow(const QRect& a, const QRect& b)
{
    const int shared = std::min(a.bottom(), b.bottom()) - std::max(a.top(), b.top()) + 1;
    return 2 * shared > std::max(a.height(), b.height());
}

/// Puts the stops of one pane in order.
void sortByRows(std::vector<Stop>::iterator begin, std::vector<Stop>::iterator end)
{
    std::stable_sort(begin, end, [](const Stop& a, const Stop& b) {
        return a.place.center().y() < b.place.center().y();
    });
    while (begin != end) {
        const auto row = std::find_if(
            begin + 1, end, [&](const Stop& stop) { return !isOneRow(begin->place, stop.place); });
        std::stable_sort(begin, row,
                         [](const Stop& a, const Stop& b) { return a.place.x() < b.place.x(); });
        begin = row;
    }
}

void sortAsRead(std::vector<Stop>& stops)
{
    std::ranges::stable_sort(stops, {}, &Stop::pane);
    for (auto begin = stops.begin(); begin != stops.end();) {
        const auto end = std::find_if(begin, stops.end(),
                                      [&](const Stop& stop) { return stop.pane != begin->pane; });
        sortByRows(begin, end);
        begin = end;
    }
}

QWidget* nextInReadingOrder(const QWidget& window, bool forward)
{
    std::vector<Stop> stops = stopsOf(window);
    if (stops.empty())
        return nullptr;
    sortAsRead(stops);
    const auto present = std::ranges::find(stops, window.focusWidget(), &Stop::control);
    if (present == stops.end())
        return forward ? stops.front().control : stops.back().control;
    const auto place = std::size_t(present - stops.begin());
    return stops[(place + (forward ? 1 : stops.size() - 1)) % stops.size()].control;
}

} // namespace

bool focusNextAsRead(QWidget& window, bool forward)
{
    QWidget* to = nextInReadingOrder(window, forward);
    if (!to)
        return false;
    to->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    for (QWidget* around = to->parentWidget(); around; around = around->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(around))
            area->ensureWidgetVisible(to);
    return true;
}

} // namespace carina
