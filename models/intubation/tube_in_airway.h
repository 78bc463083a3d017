#pragma once

#include "engine/airway/tube/elastic_tube.h"
#include "models/station/station_view.h"

#include <functional>
#include <vector>

namespace carina
{

/// How a tube lies in the airway that it is drawn in.
struct TubeInAirway {
    std::vector<Vec3> p_E; ///< centre line; empty: as at rest
    TubeDrawing drawing = TubeDrawing::AsMeasured;
};
using TubeInAirwayAt =
    std::function<TubeInAirway(const StationMoment& moment, const TissueAround& tissue)>;

} // namespace carina
