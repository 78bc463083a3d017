#pragma once

#include "models/station/tool_status.h"

#include <QString>

class QComboBox;
class QWidget;

namespace carina
{

/// A box that offers the roles of a tool.
/// @param label as a screen reader says it
[[nodiscard]] QComboBox* roleBox(ToolRole role, const QString& label);

/// The role in a box. @pre it is one of roleBox().
[[nodiscard]] ToolRole chosenRole(const QWidget& box);

} // namespace carina
