#pragma once

class QApplication;

namespace carina
{

/// Sets the common dark theme of the programs: Fusion style, one palette with one accent colour,
/// fonts of at least 12 points, and resources/styles/dark.qss. Widgets take their colours from the
/// palette.
void applyDarkTheme(QApplication& application);

} // namespace carina
