#pragma once

#include "engine/io/anatomy_set/imported_set.h"

#include <QString>

#include <vector>

namespace carina
{

/// The name of a role: "Right upper lobe".
[[nodiscard]] QString roleWord(PartRole role);

/// All roles, in their order.
[[nodiscard]] std::vector<PartRole> allRoles();

/// A length unit of files, and its name.
struct UnitChoice {
    double metresPerUnit;
    QString word;
};
[[nodiscard]] std::vector<UnitChoice> unitChoices();

/// An orientation of the axes of the frame F of files, and its name.
struct AxesChoice {
    Mat3 R_AF;
    QString word; ///< "x left, y posterior, z superior"
};
/// All 24 right-handed orientations, the most common ones first.
[[nodiscard]] std::vector<AxesChoice> axesChoices();

/// "x left, y posterior, z superior"
[[nodiscard]] QString axesWord(const Mat3& R_AF);

} // namespace carina
