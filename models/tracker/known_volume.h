#pragma once

#include "engine/tracking/measurement_volume.h"

#include <QString>

#include <optional>
#include <span>

namespace carina
{

/// The volumes of trackers that are known.
enum class KnownVolume : std::uint8_t {
    None,
    PolarisPyramid,
    PolarisExtended,
    SimulatedCone,
};

/// All, in the order in which they are offered.
[[nodiscard]] std::span<const KnownVolume> knownVolumes();

/// As shown: "Polaris, pyramid to 2.4 m".
[[nodiscard]] QString volumeName(KnownVolume volume);

/// Nothing for None.
[[nodiscard]] std::optional<MeasurementVolume> volumeOf(KnownVolume volume);

} // namespace carina
