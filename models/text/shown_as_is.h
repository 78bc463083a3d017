#pragma once

#include <QString>

namespace carina
{

/// A text for a tooltip or a message box, which is then shown as it is. Qt takes a text there for
/// rich text where it looks like that, and loads the pictures that it names: a participant called
/// `<img src=/dev/zero>` would use up the memory. Labels are PlainLabel instead.
[[nodiscard]] QString shownAsIs(const QString& text);

} // namespace carina
