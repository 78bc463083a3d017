#pragma once

#include "engine/core/units.h"

#include <array>
#include <cstdint>

namespace carina
{

/// Where the tip of a tracheal tube lies.
enum class TubeSeat : std::uint8_t {
    None,      ///< no tube, or its tip is above the vocal cords
    Trachea,   ///< between the cords and the carina
    RightMain, ///< in the right main bronchus
    LeftMain,  ///< in the left one
    Oesophagus,
};
inline constexpr std::array kTubeSeats{TubeSeat::None, TubeSeat::Trachea, TubeSeat::RightMain,
                                       TubeSeat::LeftMain, TubeSeat::Oesophagus};

[[nodiscard]] constexpr bool isInMainBronchus(TubeSeat seat)
{
    return seat == TubeSeat::RightMain || seat == TubeSeat::LeftMain;
}

/// Whether the tip is beyond the vocal cords, in the airway.
[[nodiscard]] constexpr bool isThroughCords(TubeSeat seat)
{
    return seat == TubeSeat::Trachea || isInMainBronchus(seat);
}

/// A tube as the mechanics and the gas exchange of a patient know it.
struct TubePlace {
    TubeSeat seat = TubeSeat::None;
    Length innerDiameter{};   ///< 0: no tube
    double leak = 0.0;        ///< share of a delivered breath that escapes beside the cuff, 0 to 1
    double obstruction = 0.0; ///< 0 open to 1 shut, by a kink, a bite or secretions

    friend bool operator==(const TubePlace&, const TubePlace&) = default;
};

/// A tube as an instructor sets it; where the inner diameter is 0, none is set, and its seat is
/// None.
struct SetTube {
    TubeSeat seat = TubeSeat::None;
    Length innerDiameter{};

    [[nodiscard]] bool isSet() const { return innerDiameter.si > 0.0; }

    friend bool operator==(const SetTube&, const SetTube&) = default;
};

} // namespace carina
