#include "models/intubation/drawn_ways.h"

namespace carina
{
namespace
{

/// Below it, in an adult, what lies around the airway is trachea and no larynx: the cricoid. Of
/// ours.
constexpr Length kCordsToTrachea = millimetres(25.0);

bool tellsWays(PartRole role)
{
    return role == PartRole::RightMainBronchus || role == PartRole::LeftMainBronchus
           || role == PartRole::Oesophagus;
}

std::vector<AnatomyPart> partsOfWays(const PatientModel& patient)
{
    std::vector<AnatomyPart> parts;
    for (const PatientSurface& surface : patient.surfaces()) {
        if (!tellsWays(surface.description.role))
            continue;
        parts.push_back(surface.description);
        parts.back().levels.push_back(*surface.levels.front());
    }
    return parts;
}

/// As the larynx, which a blade tilts; what is above it less and less, as the pharynx, and the
/// palate and the teeth not at all.
Vec3 tilted(const BladeFrame<double>& blade, const Vec3& p_A)
{
    const double height = blade.up.dot(p_A) + blade.upFrom;
    const double lean = formula::leaning(height).value;
    const double share = lean > 0.0 ? formula::leaningOfPharynx(height).value / lean : 0.0;
    return p_A + share * larynxTilt<double>(blade, p_A).d;
}

} // namespace

PatientWays waysOf(const PatientModel& patient)
{
    const auto laryngoscopy = Laryngoscopy::of(patient, bladeOf(kUsualBlade));
    const auto upper = laryngoscopy ? std::optional{laryngoscopy->script().airway} : std::nullopt;
    return patientWays(patient.landmarks(), upper, partsOfWays(patient));
}

PatientWays drawnWays(const PatientWays& ways, const AirwayField& changes,
                      const FollowingThroat& throat, const BladeField& tissue)
{
    const Vec3 up = ways.up_A();
    const Vec3 p_A_glottis = ways.p_A_glottis();
    const double larynx = ways.size * kCordsToTrachea.si;
    return moved(ways, [&](const Vec3& place) {
        const bool isTrachea = up.dot(p_A_glottis - place) > larynx;
        Vec3 p_A = place;
        p_A += airwayPull<double>(changes.frame(),
                                  isTrachea ? AirwayTissue::Windpipe : AirwayTissue::Larynx, p_A)
                   .d;
        p_A = throat.neck.placed(p_A);
        p_A += shareOfJaw(ways, place) * throatPull(throat, ThroatTissue::Airway, p_A).d;
        return tilted(tissue.frame(), p_A);
    });
}

std::vector<Vec3> measuredTube(const PatientModel& patient, const NeckField& neck,
                               const RigidTransform& X_AE)
{
    std::vector<Vec3> line = centreIn(neck, patient.tube());
    for (Vec3& p : line)
        p = X_AE * p;
    return line;
}

} // namespace carina
