#pragma once

class QWidget;

namespace carina
{

/// Moves the focus to the control that Tab goes to (or Shift+Tab) from the one of a window that has
/// it, as the window is read at present: its toolbars; its panels and its middle from left to
/// right, from top to bottom where they stand beneath each other; its status bar; and within each
/// of these row by row. Qt's own order is that in which they were made, and panels are moved, and
/// tabs made anew; a panel that floats it leaves in parts that Tab does not leave.
/// @returns false where there is none
bool focusNextAsRead(QWidget& window, bool forward);

} // namespace carina
