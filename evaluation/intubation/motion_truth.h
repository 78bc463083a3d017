#pragma once

#include "engine/lungs/mechanics/tube_place.h"
#include "evaluation/intubation/intubation_motion.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace carina
{

/// Where the tip of a tube truly is.
enum class TrueSeat : std::uint8_t {
    Outside, ///< there is none, or it is above the vocal cords
    Trachea,
    RightMain,
    LeftMain,
    Oesophagus, ///< from the level of the cords on, behind them
};
inline constexpr std::array kTrueSeats{TrueSeat::Outside, TrueSeat::Trachea, TrueSeat::RightMain,
                                       TrueSeat::LeftMain, TrueSeat::Oesophagus};
/// The same as a patient's lungs know it.
[[nodiscard]] TubeSeat seatOf(TrueSeat truth);

enum class TrueStep : std::uint8_t {
    BladeIn, ///< its tip passes the plane through the upper incisors across the way there
    BladeOut,
    TubePastTeeth,
    TubeOut,
    ThroughCords,
    BackAboveCords,
    InOesophagus, ///< the tip passes the level of the cords, behind them
    OutOfOesophagus,
    PastCarina,
    BackAboveCarina,
    CuffInflated,
    CuffDeflated,
    StyletOut,
    FirstBreath, ///< of the breaths that begin
};

struct TrueEvent {
    TrueStep step = TrueStep::BladeIn;
    Duration at{};                     ///< from the motion's start
    TrueSeat seat = TrueSeat::Outside; ///< of the tip from then on
};

/// What happened in a motion.
struct MotionTruth {
    std::vector<TrueEvent> events;        ///< by time
    TrueSeat outcome = TrueSeat::Outside; ///< in the end
    Length depthAtTeeth{};                ///< likewise
    std::optional<Length> tipAboveCarina; ///< likewise, of a tip on a way that passes the carina
    int attempts = 0;                     ///< how often the blade went in
};

/// From the true poses alone: where signed distances of the tips from planes and places change
/// their sign, within 0.1 ms. A tip that is back within a quarter of a second was not away.
[[nodiscard]] MotionTruth truthOf(const IntubationMotion& motion);

} // namespace carina
