#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <QJsonObject>

namespace carina
{

/// The contents of a set, for people and tools: JSON of the schema carina.anatomy/1, whose keys
/// `carina-lab help` lists.
[[nodiscard]] QJsonObject describeSet(const ImportedSet& set);

} // namespace carina
