#pragma once

#include "engine/core/session_time.h"
#include "engine/core/units.h"

#include <limits>
#include <optional>

namespace carina
{

/// Where the tip of a tube was at a time.
struct TipReading {
    SessionTime at{};
    Length depthAtTeeth{};
    Length aboveCarina{};
    Length besides{}; ///< distance of both shapes

    friend bool operator==(const TipReading&, const TipReading&) = default;
};

/// When a signed value counts as on the other side of 0.
struct CrossingRule {
    double band = 0.0; ///< it stays beyond this for as long as `dwell...` says,
    double sure = std::numeric_limits<double>::infinity(); ///< or in two samples beyond this
    Duration dwellIn{};                                    ///< above 0
    Duration dwellOut{}; ///< below it; only this, not `sure`, ends what is in where keepsIn
    bool keepsIn = false;
};

/// A passage of 0. It is known later than it happened.
struct Passage {
    TipReading reading{};   ///< interpolated at the passage
    bool isIn = false;      ///< to above 0
    bool wasUnseen = false; ///< between two samples far apart, or before the first one
    double beyond = 0.0;    ///< how far on that side it was when it was known

    friend bool operator==(const Passage&, const Passage&) = default;
};

/// Follows a signed value over time, with hysteresis: noise about 0 is no passage.
struct Crossing {
    bool isIn = false;
    std::optional<double> value{};  ///< the latest
    TipReading latest{};            ///< and when
    std::optional<Passage> begun{}; ///< the latest passage out of the present state, while it lasts
    std::optional<SessionTime> beyond{}; ///< since when it is outside of the band

    /// Samples farther apart than this leave a passage between them unseen. Of ours.
    static constexpr Duration kUnseen = std::chrono::milliseconds{150};

    /// @param reading of the value, later than those before
    /// @returns a passage that is known now
    std::optional<Passage> take(double value, const TipReading& reading, const CrossingRule& rule);

    friend bool operator==(const Crossing&, const Crossing&) = default;
};

} // namespace carina
