#include "evaluation/intubation/motion_parameters.h"

#include "evaluation/intubation/hand_track.h"

#include <algorithm>
#include <vector>

namespace carina
{
namespace
{

constexpr std::array<MotionRange, kMotionParameters> kRanges{
    {{"blade_in_s", 2.0, 5.0, 9.0},      {"view_s", 1.0, 5.0, 12.0},
     {"tube_in_s", 1.2, 3.5, 6.0},       {"hesitation_s", 0.3, 1.5, 5.0},
     {"through_s", 1.0, 2.5, 0.6},       {"blade_out_s", 0.9, 2.0, 4.0},
     {"to_cuff_s", 1.0, 4.0, 10.0},      {"to_breath_s", 1.5, 5.0, 12.0},
     {"lift_share", 0.75, 1.0, 0.5},     {"tremor_mm", 0.05, 0.2, 0.5},
     {"sway_mm", 0.2, 0.6, 1.5},         {"roll_deg", -12.0, 12.0, 40.0},
     {"corner_mm", 0.0, 8.0, 15.0},      {"deeper_mm", -8.0, 8.0, 15.0},
     {"slower", 2.0, 3.0, 5.0},          {"oesophagus_mm", 50.0, 100.0, 140.0},
     {"bronchus_mm", 12.0, 22.0, 30.0},  {"lever_deg", 8.0, 15.0, 22.0},
     {"cords_mm", 25.0, 40.0, 50.0},     {"tip_share", 0.55, 0.85, 0.98},
     {"flexion_deg", 15.0, 30.0, 35.0},  {"pushes", 2.0, 4.0, 7.0},
     {"recognised_s", 30.0, 70.0, 120.0}}};

/// The motion whose own parameter this is; nothing for one of several motions.
std::optional<MotionKind> ownerOf(MotionParameter parameter)
{
    switch (parameter) {
    case MotionParameter::Slower:
        return MotionKind::Slow;
    case MotionParameter::Lever_deg:
        return MotionKind::DentalLever;
    case MotionParameter::Cords_mm:
        return MotionKind::TooShallow;
    case MotionParameter::Tip_share:
        return MotionKind::CuffAboveCords;
    case MotionParameter::Flexion_deg:
        return MotionKind::NeckFlexed;
    case MotionParameter::Pushes:
        return MotionKind::StuckAtArytenoid;
    case MotionParameter::Recognised_s:
        return MotionKind::LateRecognition;
    default:
        return std::nullopt;
    }
}

bool isOneOf(MotionKind kind, std::initializer_list<MotionKind> kinds)
{
    return std::ranges::find(kinds, kind) != kinds.end();
}

double beyondOf(const MotionRange& range, std::mt19937& random)
{
    const double edge = range.beyond > range.most ? range.most : range.least;
    return evenBetween(edge, range.beyond, random);
}

} // namespace

std::string namesOfMotions()
{
    std::string names;
    for (const NamedMotion& motion : kNamedMotions)
        names.append(names.empty() ? "" : ", ").append(motion.name);
    return names;
}

std::optional<MotionKind> motionFromName(std::string_view name)
{
    const auto* found = std::ranges::find(kNamedMotions, name, &NamedMotion::name);
    return found != kNamedMotions.end() ? std::optional{found->kind} : std::nullopt;
}

const MotionRange& rangeOf(MotionParameter parameter)
{
    return kRanges[static_cast<std::size_t>(parameter)];
}

bool uses(MotionKind kind, MotionParameter parameter)
{
    if (const auto owner = ownerOf(parameter))
        return kind == *owner;
    const bool isBronchial = isOneOf(kind, {MotionKind::RightMainstem, MotionKind::LeftMainstem});
    switch (parameter) {
    case MotionParameter::Bronchus_mm:
        return isBronchial;
    case MotionParameter::Oesophagus_mm:
        return isOneOf(kind, {MotionKind::Oesophageal, MotionKind::ThreeAttempts,
                              MotionKind::LateRecognition});
    case MotionParameter::Deeper_mm:
        return !isBronchial
               && !isOneOf(kind, {MotionKind::Oesophageal, MotionKind::TooShallow,
                                  MotionKind::CuffAboveCords});
    default:
        return true;
    }
}

MotionParameters drawnParameters(MotionKind kind, std::mt19937& random)
{
    MotionParameters drawn;
    std::vector<MotionParameter> used;
    for (std::size_t i = 0; i < kMotionParameters; ++i) {
        drawn.values[i] = evenBetween(kRanges[i].least, kRanges[i].most, random);
        if (uses(kind, static_cast<MotionParameter>(i)))
            used.push_back(static_cast<MotionParameter>(i));
    }
    constexpr double kOutsideShare = 1.0 / 3.0;
    if (evenOf(random) < kOutsideShare) {
        drawn.outside = used[static_cast<std::size_t>(evenOf(random) * double(used.size()))];
        drawn.values[static_cast<std::size_t>(*drawn.outside)] =
            beyondOf(rangeOf(*drawn.outside), random);
    }
    return drawn;
}

} // namespace carina
