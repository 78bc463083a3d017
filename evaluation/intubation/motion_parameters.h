#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <string>
#include <string_view>

namespace carina
{

/// The motions by which it is measured whether an intubation is understood.
enum class MotionKind : std::uint8_t {
    Good,
    Slow,             ///< the same, with longer movements and pauses
    Oesophageal,      ///< into the oesophagus, and left there
    RightMainstem,    ///< into the right main bronchus
    LeftMainstem,     ///< into the left one
    ThreeAttempts,    ///< given up before the larynx, then in the oesophagus, then good
    DentalLever,      ///< the blade is levered on the upper teeth
    TooShallow,       ///< through the cords, with the cuff between them
    NeckFlexed,       ///< good, and the neck is flexed afterwards
    StuckAtArytenoid, ///< the tip meets the right arytenoid several times, and then passes
    CuffAboveCords,   ///< the tip is just through the cords
    LateRecognition,  ///< in the oesophagus, which is noticed late; then good
};

struct NamedMotion {
    std::string_view name;
    MotionKind kind = MotionKind::Good;
};
inline constexpr std::array kNamedMotions{
    NamedMotion{"good", MotionKind::Good},
    NamedMotion{"slow", MotionKind::Slow},
    NamedMotion{"oesophageal", MotionKind::Oesophageal},
    NamedMotion{"right_mainstem", MotionKind::RightMainstem},
    NamedMotion{"left_mainstem", MotionKind::LeftMainstem},
    NamedMotion{"three_attempts", MotionKind::ThreeAttempts},
    NamedMotion{"dental_lever", MotionKind::DentalLever},
    NamedMotion{"too_shallow", MotionKind::TooShallow},
    NamedMotion{"neck_flexed", MotionKind::NeckFlexed},
    NamedMotion{"stuck_at_arytenoid", MotionKind::StuckAtArytenoid},
    NamedMotion{"cuff_above_cords", MotionKind::CuffAboveCords},
    NamedMotion{"late_recognition", MotionKind::LateRecognition}};

/// All names, with commas between them.
[[nodiscard]] std::string namesOfMotions();
[[nodiscard]] std::optional<MotionKind> motionFromName(std::string_view name);

/// What differs between two runs of a motion. Lengths are those of an adult; they are in proportion
/// to the airway.
enum class MotionParameter : std::uint8_t {
    BladeIn_s,     ///< from the teeth to the vallecula
    View_s,        ///< how long the larynx is looked at
    TubeIn_s,      ///< from in front of the face to the larynx
    Hesitation_s,  ///< before the larynx
    Through_s,     ///< from there to the final depth
    BladeOut_s,    ///< out of the mouth
    ToCuff_s,      ///< until the cuff is inflated
    ToBreath_s,    ///< and until the first breath
    Lift_share,    ///< of the usual lift
    Tremor_mm,     ///< of the hand, root mean square along one axis
    Sway_mm,       ///< likewise
    Roll_deg,      ///< of the tube about the line from teeth to tip
    Corner_mm,     ///< by which it enters beside the midline, to the patient's right
    Deeper_mm,     ///< than the usual depth
    Slower,        ///< factor of all durations
    Oesophagus_mm, ///< beyond the level of the cords
    Bronchus_mm,   ///< beyond the carina
    Lever_deg,     ///< of the blade
    Cords_mm,      ///< beyond the cords, where the cuff is between them
    Tip_share,     ///< of the way from tip to cuff that is beyond the cords
    Flexion_deg,   ///< of the neck
    Pushes,        ///< at the arytenoid
    Recognised_s,  ///< from the first breath on
};
inline constexpr std::size_t kMotionParameters = 23;

/// The range of a parameter in usual runs, and how far beyond it, on one side, it may be in others.
struct MotionRange {
    std::string_view name;
    double least = 0.0, most = 0.0;
    double beyond = 0.0;
};
/// All of ours.
[[nodiscard]] const MotionRange& rangeOf(MotionParameter parameter);

/// Whether a motion depends on a parameter.
[[nodiscard]] bool uses(MotionKind kind, MotionParameter parameter);

/// The parameters of one run.
struct MotionParameters {
    std::array<double, kMotionParameters> values{};
    std::optional<MotionParameter> outside; ///< the one that is not within its usual range

    [[nodiscard]] double operator[](MotionParameter parameter) const
    {
        return values[static_cast<std::size_t>(parameter)];
    }
};

/// Draws the parameters, each even in its range; in a third of all runs one of those that the
/// motion depends on is drawn from beyond it.
[[nodiscard]] MotionParameters drawnParameters(MotionKind kind, std::mt19937& random);

} // namespace carina
