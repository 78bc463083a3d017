#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace carina
{

/// Makes a label over a picture that is a native window; the label does not receive mouse or keys.
/// @returns the label, hidden and owned by `over`
[[nodiscard]] QLabel* pictureLabel(QWidget& over, const QString& word);

/// Raises a label above the picture, whose native window covers earlier widgets.
void raiseLabel(QLabel& label);

} // namespace carina
