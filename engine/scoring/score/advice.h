#pragma once

#include "engine/scoring/score/metric.h"

#include <cstdint>
#include <vector>

namespace carina
{

/// What a trainee may do next, by priority: first what harmed the patient, then what would have
/// helped, then how it was done. Each has a sentence in models/scoring.
enum class Advice : std::uint8_t {
    TakeTubeOut,      ///< it is in the oesophagus
    RecogniseSooner,  ///< that it was there; its seven breaths are of PUMA 2022, from textbooks
    PullTubeBack,     ///< it is beyond the carina
    VentilateBetween, ///< the saturation fell below 90 %
    SeeGlottisFirst,  ///< the tube went in without a view
    ShapeTube,        ///< there was a view, and the tube did not come to the trachea
    ChangeSomething,  ///< before another attempt: there were several
    SpareTheTeeth,
    AdvanceTube,  ///< not as deep as the rule says
    WithdrawTube, ///< deeper than the rule says
    InflateCuff,
    SpareTheTongue,
    ExtendHead,
    HoldBladeUpright, ///< its plane was far from the vertical
    BendLess,         ///< the head went up and down
    BeQuicker,
    // Of every try, where less is to be said
    TryHarderPatient,
    TryOtherManikin, ///< which halves the odds of success (Plummer and Owen 2001)
    Repeat,          ///< a success teaches about as much as 12 failures (likewise)
};
inline constexpr Advice kLastAdvice = Advice::Repeat;
inline constexpr std::size_t kAdviceGiven = 3;

// From where on something is advised; of ours, unless said otherwise.
inline constexpr Duration kRecognisedAtOnce = std::chrono::seconds{10};
inline constexpr double kDepthTolerance_mm = 10.0;
inline constexpr double kSteady_deg2 = 28.7; ///< Carlson 2012, the intermediate person
inline constexpr double kCalmHead_cm = 31.1; ///< St. Marianna 10(2):51, the novices less one SD
inline constexpr double kQuick_s = 60.0;     ///< to the first breath
inline constexpr double kExtendedHead_deg = 10.0;

/// The first kAdviceGiven, by priority, that hold for a try. What was not measured is not advised
/// about. A harder patient and another manikin are advised after a tube in the trachea only.
[[nodiscard]] std::vector<Advice> adviceFor(const TryMetrics& metrics);

} // namespace carina
