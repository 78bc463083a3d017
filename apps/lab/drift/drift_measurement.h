#pragma once

#include "apps/lab/drift/drift_request.h"

#include <QJsonObject>

namespace carina::lab
{

/// What `drift` prints of a request: describeRequest, and what was measured, in virtual or in real
/// time.
///
/// @returns what runLiveDrift and the network do.
[[nodiscard]] Result<QJsonObject> measuredDrift(const DriftRequest& request);

/// Adds what was asked for.
void describeRequest(const DriftRequest& request, QJsonObject& object);

} // namespace carina::lab
