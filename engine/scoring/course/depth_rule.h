#pragma once

#include "engine/core/units.h"

#include <array>
#include <cstdint>
#include <optional>

namespace carina
{

/// Rules for the depth of a tracheal tube, from its tip to the upper incisors or the lip. They
/// differ by up to 40 mm for the same child, so a scenario states its rule.
enum class DepthRule : std::uint8_t {
    TenthOfHeight,  ///< 0.10 height + 5 cm (Morgan): children
    EighthOfHeight, ///< height / 8 + 3.4 cm (doi 10.1007/s44253-024-00032-7): children
    ThreeDiameters, ///< three times the inner diameter in mm, as cm: children
    HalfOfAge,      ///< age / 2 + 12 cm: children from 1 year
    WomanTwentyOneManTwentyThree, ///< 21 and 23 cm: adults
};
inline constexpr std::array kDepthRules{DepthRule::TenthOfHeight, DepthRule::EighthOfHeight,
                                        DepthRule::ThreeDiameters, DepthRule::HalfOfAge,
                                        DepthRule::WomanTwentyOneManTwentyThree};

/// How options and files call them, in the order of the enumeration.
inline constexpr std::array kDepthRuleWords{"tenth-of-height", "eighth-of-height",
                                            "three-diameters", "half-of-age", "21-23"};
static_assert(kDepthRuleWords.size() == kDepthRules.size());

/// What the rules are about.
struct TubedPatient {
    Length height{};
    double ageInYears = 0.0;
    bool isWoman = false;
    Length innerDiameter{}; ///< of the tube

    friend bool operator==(const TubedPatient&, const TubedPatient&) = default;
};

/// From this age on a rule for adults holds, and no rule for children; of ours.
inline constexpr double kAdultAge = 16.0;

/// The depth that a rule asks for; nothing for a patient whom it is not for.
[[nodiscard]] std::optional<Length> depthBy(DepthRule rule, const TubedPatient& patient);

/// The rule where a scenario states none: TenthOfHeight for children,
/// WomanTwentyOneManTwentyThree for adults.
[[nodiscard]] DepthRule usualDepthRule(const TubedPatient& patient);

} // namespace carina
