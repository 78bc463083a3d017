#pragma once

#include "engine/geometry/fit/weighted_fit.h"
#include "engine/registration/landmarks/landmark_order.h"

#include <QJsonObject>

#include <optional>
#include <string>
#include <vector>

namespace carina::lab
{

/// What `carina-lab fit` prints of a fit; the keys are in fit_page.h.
[[nodiscard]] QJsonObject describeFit(const std::vector<std::string>& names, const RigidFit& fit);

/// Adds the localisation error by the residuals, and what leaving each landmark out shows.
void describeErrors(QJsonObject& object, const std::vector<std::string>& names, const RigidFit& fit,
                    const std::vector<std::optional<double>>& leftOut);

/// Adds how the residuals agree with the covariances.
void describeWeights(QJsonObject& object, const WeightedFit& fit);

/// Adds what order the touches are in.
void describeOrder(QJsonObject& object, const std::vector<std::string>& names,
                   const OrderFinding& order);

} // namespace carina::lab
