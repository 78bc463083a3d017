#pragma once

#include "apps/lab/registration/landmark_table.h"
#include "engine/registration/landmarks/landmark_order.h"

#include <QStringList>

#include <optional>
#include <string>

namespace carina::lab
{

/// Why touches in such an order are not to be fitted as they are, and what to do, as the end of a
/// sentence that names their file; nothing where they can be.
[[nodiscard]] std::optional<std::string> whyNotAsGiven(const std::vector<std::string>& names,
                                                       const OrderFinding& order);

/// What else is to be doubted of a fit, each a sentence with its remedy: landmarks nearly on one
/// line, and touches that no order of them explains.
/// @param fle how far touches stray
[[nodiscard]] QStringList fitWarnings(const NamedPairs& named, const OrderFinding& order,
                                      Length fle);

} // namespace carina::lab
