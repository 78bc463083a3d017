#include "evaluation/anatomy/anatomy_comparison.h"

#include "evaluation/anatomy/organ_groups.h"
#include "evaluation/anatomy/surface_distance.h"

#include <algorithm>
#include <cmath>

namespace carina
{
namespace
{

constexpr Length kSpacing = millimetres(10.0);

constexpr std::array kLobes{PartRole::RightUpperLobe, PartRole::RightMiddleLobe,
                            PartRole::RightLowerLobe, PartRole::LeftUpperLobe,
                            PartRole::LeftLowerLobe};

double volumeOf(const Anatomy& anatomy, PartRole role)
{
    double volume = 0.0;
    for (const AnatomyPart& part : anatomy.parts)
        if (part.role == role)
            volume += signedVolume(part.levels.front());
    return volume;
}

double lungVolume(const Anatomy& anatomy)
{
    double volume = volumeOf(anatomy, PartRole::RightLung) + volumeOf(anatomy, PartRole::LeftLung);
    for (const PartRole lobe : kLobes)
        volume += volumeOf(anatomy, lobe);
    return volume;
}

std::vector<Deviation> airwayFigures(const AirwayMeasures& made, const AirwayMeasures& real,
                                     double scale)
{
    const auto length = [&](const char* name, Length AirwayMeasures::*of) {
        return Deviation{name, inMillimetres(made.*of), scale * inMillimetres(real.*of), 0.10,
                         true};
    };
    const auto angle = [&](const char* name, Angle AirwayMeasures::*of) {
        return Deviation{name, inDegrees(made.*of), inDegrees(real.*of), 5.0};
    };
    Deviation teeth = length("teeth_to_carina_mm", &AirwayMeasures::teethToCarina);
    teeth.limit = 5.0;
    teeth.relative = false;
    // It follows the breath: 178 (40) mm2 of section after a forced expiration and 280 (51) after
    // a full inspiration in the same ten men (Stern et al. 1993), and of a set that is not known.
    Deviation sagittal = length("trachea_sagittal_mm", &AirwayMeasures::sagittal);
    sagittal.limit.reset();
    return {length("trachea_length_mm", &AirwayMeasures::trachea),
            length("trachea_coronal_mm", &AirwayMeasures::coronal),
            sagittal,
            angle("right_bronchus_deg", &AirwayMeasures::rightBronchus),
            angle("left_bronchus_deg", &AirwayMeasures::leftBronchus),
            teeth};
}

TriangleMesh scaled(TriangleMesh mesh, double scale)
{
    for (Vec3f& p : mesh.positions)
        p *= float(scale);
    return mesh;
}

OrganDistance distanceOf(const std::string& name, const Organ& made, const TriangleMesh& real)
{
    OrganDistance distance;
    distance.organ = name;
    distance.toReal_mm = inMillimetres(meanDistance(made.mesh, SurfaceTree{real}, kSpacing));
    distance.fromReal_mm = inMillimetres(meanDistance(real, SurfaceTree{made.mesh}, kSpacing));
    distance.oneWay = name == roleName(PartRole::BronchialTree);
    return distance;
}

void addLobeShares(const Anatomy& generated, const Anatomy& real, std::vector<Deviation>& figures)
{
    const auto made = lobeShares(generated);
    const auto found = lobeShares(real);
    if (!made || !found)
        return;
    for (std::size_t i = 0; i < kLobes.size(); ++i)
        figures.push_back(
            {std::string{roleName(kLobes[i])} + "_percent", (*made)[i], (*found)[i], 3.0});
}

} // namespace

double Deviation::deviation() const { return relative ? generated / real - 1.0 : generated - real; }

bool Deviation::met() const { return !limit || std::abs(deviation()) <= *limit; }

double OrganDistance::mean_mm() const
{
    return oneWay ? toReal_mm : 0.5 * (toReal_mm + fromReal_mm);
}

bool OrganDistance::met() const { return mean_mm() <= kLargestMeanDistance_mm; }

bool AnatomyComparison::met() const
{
    return std::ranges::all_of(figures, &Deviation::met)
           && std::ranges::all_of(organs, &OrganDistance::met) && selfIntersections.empty();
}

std::vector<SelfIntersection> selfIntersectionsOf(const Anatomy& anatomy)
{
    std::vector<SelfIntersection> found;
    for (const AnatomyPart& part : anatomy.parts) {
        for (std::size_t level = 0; level < part.levels.size(); ++level) {
            const std::size_t pairs = SurfaceTree{part.levels[level]}.selfIntersections();
            if (pairs > 0)
                found.push_back({part.name, level, pairs});
        }
    }
    return found;
}

std::optional<std::array<double, 5>> lobeShares(const Anatomy& anatomy)
{
    std::array<double, 5> shares{};
    double whole = 0.0;
    for (std::size_t i = 0; i < kLobes.size(); ++i) {
        shares[i] = volumeOf(anatomy, kLobes[i]);
        if (!(shares[i] > 0.0))
            return std::nullopt;
        whole += shares[i];
    }
    for (double& share : shares)
        share *= 100.0 / whole;
    return shares;
}

Result<AnatomyComparison> compareAnatomy(const Anatomy& generated, const Anatomy& real)
{
    const auto made = measureAirway(generated);
    const auto found = measureAirway(real);
    if (!made || !found)
        return fail(Errc::NothingRecognised, "the airway of " + (made ? real : generated).name);
    AnatomyComparison result;
    result.airwayScale = made->cordsToCarina / found->cordsToCarina;
    const double lungs = lungVolume(generated) / lungVolume(real);
    result.chestScale = std::isfinite(lungs) && lungs > 0.0 ? std::cbrt(lungs) : result.airwayScale;
    result.figures = airwayFigures(*made, *found, result.airwayScale);
    addLobeShares(generated, real, result.figures);
    const auto patient = organsOf(generated);
    const auto set = organsOf(real);
    for (const auto& [name, organ] : patient) {
        const auto other = set.find(name);
        if (other == set.end()) {
            result.notInSet.push_back(name);
            continue;
        }
        const bool chest = organ.scale == OrganScale::Chest;
        const double scale = chest ? result.chestScale : result.airwayScale;
        result.organs.push_back(distanceOf(name, organ, scaled(other->second.mesh, scale)));
    }
    for (const auto& [name, organ] : set)
        if (!patient.contains(name))
            result.notInPatient.push_back(name);
    result.selfIntersections = selfIntersectionsOf(generated);
    return result;
}

} // namespace carina
