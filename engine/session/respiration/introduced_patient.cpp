#include "engine/session/respiration/introduced_patient.h"

namespace carina
{

std::vector<FactBody> introducedPatient(const PatientBuild& build)
{
    const BreathingPattern quiet = restingPattern(build);
    return {fact::PatientBuildSet{build}, fact::BreathingRateSet{quiet.rate},
            fact::TidalVolumeSet{quiet.tidalVolume},
            fact::InspiratoryFractionSet{quiet.inspiratoryFraction}};
}

} // namespace carina
