#pragma once

#include <QString>

class QLabel;
class QWidget;

namespace carina
{

/// A word over a picture that has a window of its own, for which mouse and keys are.
/// @returns hidden, owned by `over`
[[nodiscard]] QLabel* pictureLabel(QWidget& over, const QString& word);

/// Before the picture, which covers what was there first.
void raiseLabel(QLabel& label);

} // namespace carina
