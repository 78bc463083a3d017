#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <QJsonObject>

namespace carina
{

/// What a set holds, for people and tools: the JSON schema carina.anatomy/1, whose keys
/// `carina-lab help` names.
[[nodiscard]] QJsonObject describeSet(const ImportedSet& set);

} // namespace carina
