#include "engine/scoring/course/depth_rule.h"

namespace carina
{
namespace
{

constexpr double kYoungestByAge = 1.0; ///< years

constexpr Length centimetres(double cm) { return millimetres(10.0 * cm); }

bool isAdult(const TubedPatient& patient) { return patient.ageInYears >= kAdultAge; }

} // namespace

std::optional<Length> depthBy(DepthRule rule, const TubedPatient& patient)
{
    const bool isForAdults = rule == DepthRule::WomanTwentyOneManTwentyThree;
    if (isForAdults != isAdult(patient))
        return std::nullopt;
    switch (rule) {
    case DepthRule::TenthOfHeight:
        return 0.10 * patient.height + centimetres(5.0);
    case DepthRule::EighthOfHeight:
        return 0.125 * patient.height + centimetres(3.4);
    case DepthRule::ThreeDiameters:
        if (patient.innerDiameter <= Length{})
            return std::nullopt;
        return centimetres(3.0 * inMillimetres(patient.innerDiameter));
    case DepthRule::HalfOfAge:
        if (patient.ageInYears < kYoungestByAge)
            return std::nullopt;
        return centimetres(0.5 * patient.ageInYears + 12.0);
    case DepthRule::WomanTwentyOneManTwentyThree:
        return centimetres(patient.isWoman ? 21.0 : 23.0);
    }
    return std::nullopt;
}

DepthRule usualDepthRule(const TubedPatient& patient)
{
    return isAdult(patient) ? DepthRule::WomanTwentyOneManTwentyThree : DepthRule::TenthOfHeight;
}

} // namespace carina
