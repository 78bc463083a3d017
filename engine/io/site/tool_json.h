#pragma once

#include "engine/io/files/json_fields.h"
#include "engine/io/site/site_tool.h"

namespace carina
{

/// A tool of a site, with lengths in millimetres:
///
///     role                "tube" or "laryngoscope", none twice
///     tool                as the tracker names it; may be left out
///     X_NO_mm             the connector or the blade in the frame of the markers
///     tube                of a tube: length_mm, bends_per_m (of both halves), outer_diameter_mm
///     blade               of a laryngoscope: heel_width_mm, handle_mm, p_L_tip_mm, p_L_half_mm
///     rms_mm, fle_mm, degrees_of_freedom, covariance_N_mm2 (of the tip), touches
///     calibrated_at, operator
///     check               at, error_mm, bound_mm; may be left out
///     stale               as in a site; may be left out
[[nodiscard]] QJsonObject jsonTool(const SiteTool& tool);

/// A tool from its fields; the first fault is kept in them.
[[nodiscard]] SiteTool readTool(JsonFields& fields);

} // namespace carina
