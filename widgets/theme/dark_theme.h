#pragma once

class QApplication;

namespace carina
{

/// Gives a program the calm dark look of all of Carina: Fusion, one palette with one accent colour,
/// 12 points at least, and resources/styles/dark.qss. Widgets take their colours from the palette.
void applyDarkTheme(QApplication& application);

} // namespace carina
