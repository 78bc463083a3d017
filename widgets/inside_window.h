#pragma once

#include <QWidget>

namespace carina
{

/// Whether a widget has a place inside its window. Qt moves a dock that lies behind others in their
/// place out of the window, and leaves it visible.
[[nodiscard]] inline bool isInsideWindow(const QWidget& widget)
{
    const QWidget& window = *widget.window();
    return window.rect().intersects({widget.mapTo(&window, QPoint{}), widget.size()});
}

} // namespace carina
