#include "engine/anatomy/builtin_patient.h"

#include "engine/anatomy/airway_path.h"
#include "engine/anatomy/airway_shapes.h"
#include "engine/anatomy/detail.h"
#include "engine/anatomy/larynx_shape.h"
#include "engine/anatomy/lung_shape.h"
#include "engine/anatomy/mandible_shape.h"
#include "engine/anatomy/surface_mesher.h"
#include "engine/geometry/mesh_winding.h"

#include <array>
#include <cmath>
#include <utility>

namespace carina
{

namespace
{

constexpr std::array kShares{0.25, 0.0625};

/// Edge of a voxel for the adult; it goes with the size of the part.
constexpr Length kAirwayVoxel = millimetres(1.0);
constexpr Length kLarynxVoxel = millimetres(0.8);
constexpr Length kMandibleVoxel = millimetres(1.2);
constexpr Length kLungVoxel = millimetres(2.5);

/// The lower incisors stand this far below and behind the upper ones, in the adult: the mouth is
/// opened.
const Vec3 kUpperToLowerIncisors{0.0, 4e-3, -20e-3};

AnatomyPart partOf(std::string name, PartRole role, std::string conceptId,
                   const ImplicitShape& shape, Length voxel)
{
    return {std::move(name), role, std::move(conceptId),
            levelsOfDetail(meshOf(shape, voxel), kShares)};
}

/// Makes each level enclose exactly this volume, by a uniform scale about a point that stays.
void matchVolume(AnatomyPart& part, const Vec3& p_A_fixed, Volume volume)
{
    const Vec3f fixed = p_A_fixed.cast<float>();
    for (TriangleMesh& level : part.levels) {
        const auto scale = float(std::cbrt(volume.si / signedVolume(level)));
        for (Vec3f& p : level.positions)
            p = fixed + scale * (p - fixed);
    }
}

/// Sizes against the adult of what has no dimension of its own.
struct Growth {
    double airway;
    double lungs;
    double face;
};

Growth growthOf(const PatientDimensions& d)
{
    const PatientDimensions grown = dimensionsOf(BuiltinPatient::Adult);
    return {d.tracheaLength / grown.tracheaLength,
            std::cbrt(d.functionalResidualCapacity / grown.functionalResidualCapacity),
            d.height / grown.height};
}

AirwayLandmarks landmarksOf(const PatientDimensions& d)
{
    const Vec3 up = windpipeInAnatomy().rotation() * Vec3::UnitZ();
    AirwayLandmarks landmarks;
    landmarks.p_A_glottis = d.cordsToCarina.si * up;
    const std::array down{landmarks.p_A_glottis, landmarks.p_A_carina};
    landmarks.p_A_incisors =
        incisorsAtLength(down, metres(d.teethToCarina.si - d.cordsToCarina.si));
    landmarks.path_A = airwayPath(landmarks.p_A_incisors, down);
    return landmarks;
}

AnatomyPart lungOf(Side side, const PatientDimensions& d, const AirwaySolid& airway)
{
    const Growth growth = growthOf(d);
    const auto outside = [airway](const Vec3& p_A) { return airway.outsideLungs(p_A); };
    const bool right = side == Side::Right;
    AnatomyPart lung =
        partOf(right ? "Right lung" : "Left lung", right ? PartRole::RightLung : PartRole::LeftLung,
               right ? "FMA7309" : "FMA7310", lungShape(side, growth.lungs, outside),
               growth.lungs * kLungVoxel);
    const double share = right ? d.rightLungShare : 1.0 - d.rightLungShare;
    matchVolume(lung, hilum(side, growth.lungs), share * d.functionalResidualCapacity);
    return lung;
}

std::vector<AnatomyPart> partsOf(const PatientDimensions& d, const AirwayLandmarks& landmarks)
{
    const Growth growth = growthOf(d);
    const AirwaySolid airway{d};
    const Length airwayVoxel = growth.airway * kAirwayVoxel;
    const Length larynxVoxel = growth.airway * kLarynxVoxel;
    const Vec3 p_A_lowerIncisors = landmarks.p_A_incisors + growth.face * kUpperToLowerIncisors;
    std::vector<AnatomyPart> parts;
    parts.push_back(partOf("Trachea", PartRole::Trachea, "FMA7394", airway.trachea(), airwayVoxel));
    parts.push_back(partOf("Right main bronchus", PartRole::RightMainBronchus, "FMA7395",
                           airway.bronchus(Side::Right), airwayVoxel));
    parts.push_back(partOf("Left main bronchus", PartRole::LeftMainBronchus, "FMA7396",
                           airway.bronchus(Side::Left), airwayVoxel));
    parts.push_back(partOf("Larynx", PartRole::Larynx, "FMA55097", larynxShape(d), larynxVoxel));
    parts.push_back(
        partOf("Epiglottis", PartRole::Epiglottis, "FMA55130", epiglottisShape(d), larynxVoxel));
    parts.push_back(lungOf(Side::Right, d, airway));
    parts.push_back(lungOf(Side::Left, d, airway));
    parts.push_back(partOf("Mandible", PartRole::Mandible, "FMA52748",
                           mandibleShape(p_A_lowerIncisors, growth.face),
                           growth.face * kMandibleVoxel));
    return parts;
}

std::string_view hashOf(BuiltinPatient patient)
{
    return patient == BuiltinPatient::Adult ? "builtin-adult-1" : "builtin-twelve-years-1";
}

} // namespace

std::optional<BuiltinPatient> builtinOfHash(std::string_view contentHash)
{
    for (const BuiltinPatient patient : {BuiltinPatient::Adult, BuiltinPatient::TwelveYears})
        if (contentHash == hashOf(patient))
            return patient;
    return std::nullopt;
}

Result<Anatomy> builtinPatient(BuiltinPatient patient)
{
    const bool adult = patient == BuiltinPatient::Adult;
    const PatientDimensions dimensions = dimensionsOf(patient);
    Anatomy anatomy;
    anatomy.name = adult ? "Adult" : "12 years, 150 cm";
    anatomy.contentHash = hashOf(patient);
    anatomy.landmarks = landmarksOf(dimensions);
    anatomy.parts = partsOf(dimensions, anatomy.landmarks);
    for (const AnatomyPart& part : anatomy.parts) {
        for (const TriangleMesh& level : part.levels) {
            if (!isClosed(level) || !(signedVolume(level) > 0.0))
                return fail(Errc::MeshNotClosed, part.name);
        }
    }
    return anatomy;
}

} // namespace carina
