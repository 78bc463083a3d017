#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <QString>

#include <vector>

namespace carina
{

/// What a role is called: "Right upper lobe".
[[nodiscard]] QString roleWord(PartRole role);

/// All roles, in their order.
[[nodiscard]] std::vector<PartRole> allRoles();

/// A unit that files may have, and what it is called.
struct UnitChoice {
    double metresPerUnit;
    QString word;
};
[[nodiscard]] std::vector<UnitChoice> unitChoices();

/// A way that the axes of files may point, and what it is called.
struct AxesChoice {
    Mat3 R_AF;
    QString word; ///< "x left, y posterior, z superior"
};
/// All 24 that are right-handed, those most used first.
[[nodiscard]] std::vector<AxesChoice> axesChoices();

/// "x left, y posterior, z superior"
[[nodiscard]] QString axesWord(const Mat3& R_AF);

} // namespace carina
