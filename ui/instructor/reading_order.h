#pragma once

class QMainWindow;
class QWidget;

namespace carina
{

/// The control that Tab goes to (or Shift+Tab) from the one of a window that has the focus, as the
/// window is read at present: its toolbars; its panels and its middle from left to right, from top
/// to bottom where they stand beneath each other; its status bar; and within each of these row by
/// row. Qt's own order is that in which they were made, and panels are moved, and tabs made anew.
/// @returns null where there is none
[[nodiscard]] QWidget* nextInReadingOrder(const QMainWindow& window, bool forward);

} // namespace carina
