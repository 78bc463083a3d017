#include "engine/anatomy/patient/builtin_patient.h"

#include "engine/anatomy/airway/airway_shapes.h"
#include "engine/anatomy/airway/jaw_hinge.h"
#include "engine/anatomy/airway/pharynx_shapes.h"
#include "engine/anatomy/chest/diaphragm_shape.h"
#include "engine/anatomy/chest/heart_shape.h"
#include "engine/anatomy/chest/lung_shape.h"
#include "engine/anatomy/chest/segment_shapes.h"
#include "engine/anatomy/detail.h"
#include "engine/anatomy/larynx/larynx_shape.h"
#include "engine/anatomy/mouth/mouth_shapes.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/anatomy/patient/skin_shape.h"
#include "engine/anatomy/shapes/surface_mesher.h"
#include "engine/anatomy/skeleton/cranium_shape.h"
#include "engine/anatomy/skeleton/mandible_shape.h"
#include "engine/anatomy/skeleton/maxilla_shape.h"
#include "engine/anatomy/skeleton/rib_shapes.h"
#include "engine/anatomy/skeleton/spine_shapes.h"
#include "engine/anatomy/skeleton/tooth_shapes.h"
#include "engine/geometry/mesh/mesh_winding.h"
#include "engine/geometry/mesh/surface_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <tbb/parallel_for.h>
#include <utility>

namespace carina
{

namespace
{

constexpr std::array kShares{0.25, 0.0625};

/// Attempts to mesh a part, and the refinement of the grid with each.
constexpr int kAttempts = 6;
constexpr double kFiner = 0.03;

/// Edge of a voxel for the trachea and the jaw of BodyPlan's reference man.
constexpr Length kAirwayVoxel = millimetres(1.0);
constexpr Length kMandibleVoxel = millimetres(1.9);

void add(std::vector<PartPlan>& all, std::vector<PartPlan> more)
{
    all.insert(all.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

std::vector<PartPlan> partPlans(const BodyPlan& plan)
{
    const AirwaySolid airway{plan.dimensions};
    const Length voxel = 1e3 * plan.airway * kAirwayVoxel;
    std::vector<PartPlan> all{{"Trachea", PartRole::Trachea, "FMA7394", airway.trachea(), voxel},
                              {"Right main bronchus", PartRole::RightMainBronchus, "FMA7395",
                               airway.bronchus(Side::Right), voxel},
                              {"Left main bronchus", PartRole::LeftMainBronchus, "FMA7396",
                               airway.bronchus(Side::Left), voxel}};
    add(all, segmentalBronchi(plan, airway));
    add(all, larynx(plan));
    const Implicit mainAirway = [airway](const Vec3& p_A) { return airway.outsideLungs(p_A); };
    add(all, lobes(plan, [mainAirway, heart = heartAndVesselsRegion(plan)](const Vec3& p_A) {
            return std::min(mainAirway(p_A), heart(p_A));
        }));
    add(all, heartAndVessels(plan, mainAirway));
    add(all, mouth(plan));
    add(all, teeth(plan));
    all.push_back(maxilla(plan));
    all.push_back(cranium(plan));
    const ImplicitShape jaw = mandibleShape(plan.inFace(kUpperToLowerIncisors), 1e3 * plan.face);
    all.push_back({"Mandible", PartRole::Mandible, "FMA52748", onJaw(plan, jaw),
                   1e3 * plan.face * kMandibleVoxel});
    add(all, pharynxAndOesophagus(plan));
    all.push_back(diaphragm(plan));
    add(all, ribCage(plan));
    add(all, spine(plan));
    all.push_back(skin(plan));
    return all;
}

bool meetsItself(const std::vector<TriangleMesh>& levels)
{
    return std::ranges::any_of(levels, [](const TriangleMesh& level) {
        return SurfaceTree{level}.selfIntersections() > 0;
    });
}

/// Makes each level of a lung's lobes enclose exactly this volume together, by a uniform scale
/// about a point that stays.
void matchVolume(std::span<AnatomyPart> lobes, const Vec3& p_A_fixed, Volume volume)
{
    const Vec3f fixed = p_A_fixed.cast<float>();
    for (std::size_t level = 0; level <= kShares.size(); ++level) {
        double enclosed = 0.0;
        for (const AnatomyPart& lobe : lobes)
            enclosed += signedVolume(lobe.levels[level]);
        const auto scale = float(std::cbrt(volume.si / enclosed));
        for (AnatomyPart& lobe : lobes)
            for (Vec3f& p : lobe.levels[level].positions)
                p = fixed + scale * (p - fixed);
    }
}

void matchVolumes(const BodyPlan& plan, std::span<AnatomyPart> parts)
{
    const PatientDimensions& d = plan.dimensions;
    for (const Side side : {Side::Right, Side::Left}) {
        const auto isLobe = [side](const AnatomyPart& part) { return lungSide(part.role) == side; };
        const auto first = std::ranges::find_if(parts, isLobe);
        const auto last = std::find_if_not(first, parts.end(), isLobe);
        const double share = side == Side::Right ? d.rightLungShare : 1.0 - d.rightLungShare;
        matchVolume({first, last}, hilum(side, plan), share * d.functionalResidualCapacity);
    }
}

/// A part in all levels of detail. Simplification sometimes makes a surface, mostly a thin one,
/// intersect itself; such a part keeps more triangles.
struct Made {
    AnatomyPart part;
    bool isWrong = false; ///< it still intersects itself
};

Made surfaceOf(const PartPlan& plan, double finer)
{
    const TriangleMesh mesh = meshOf(plan.shape, (1.0 - finer) * plan.voxel, plan.fine);
    Made made{{plan.name, plan.role, plan.conceptId, {}}};
    for (const double more : {1.0, 1.03, 1.06, 1.09, 1.4, 1.9, 2.7, 3.8}) {
        LevelsOfDetail levels =
            levelsOfDetail(mesh, std::array{more * kShares[0], more * kShares[1]});
        made.part.levels = std::move(levels.meshes);
        made.part.deviations = std::move(levels.deviations);
        made.isWrong = meetsItself(made.part.levels);
        if (!made.isWrong)
            break;
    }
    return made;
}

/// Makes parts; those that intersect themselves again with a finer grid.
void makeParts(std::span<const PartPlan> plans, std::span<AnatomyPart> parts)
{
    tbb::parallel_for(std::size_t{0}, plans.size(), [&](std::size_t i) {
        Made made{{}, true};
        for (int attempt = 0; attempt < kAttempts && made.isWrong; ++attempt)
            made = surfaceOf(plans[i], kFiner * attempt);
        parts[i] = std::move(made.part);
    });
}

/// Makes the lobes of both lungs. They are scaled together, so all are made again together.
void makeLobes(const BodyPlan& plan, std::span<const PartPlan> plans, std::span<AnatomyPart> parts)
{
    for (int attempt = 0; attempt < kAttempts; ++attempt) {
        tbb::parallel_for(std::size_t{0}, plans.size(), [&](std::size_t i) {
            parts[i] = surfaceOf(plans[i], kFiner * attempt).part;
        });
        matchVolumes(plan, parts);
        if (std::ranges::none_of(parts,
                                 [](const AnatomyPart& part) { return meetsItself(part.levels); }))
            break;
    }
}

std::vector<AnatomyPart> partsOf(const BodyPlan& plan)
{
    std::vector<PartPlan> plans = partPlans(plan);
    const auto lobes = std::stable_partition(plans.begin(), plans.end(), [](const PartPlan& part) {
        return !lungSide(part.role).has_value();
    });
    const auto others = std::size_t(lobes - plans.begin());
    std::vector<AnatomyPart> parts(plans.size());
    makeParts({plans.data(), others}, {parts.data(), others});
    makeLobes(plan, std::span{plans}.subspan(others), std::span{parts}.subspan(others));
    return parts;
}

} // namespace

RigidTransform heldJaw(std::string_view contentHash)
{
    const auto parameters = parametersOfHash(contentHash);
    if (!parameters)
        return {};
    return heldJaw(bodyPlanOf(dimensionsFor(*parameters).value(), Posture::Laryngoscopy));
}

Result<Anatomy> patientFor(const PatientParameters& parameters, Posture posture)
{
    const auto dimensions = dimensionsFor(parameters);
    if (!dimensions)
        return tl::unexpected(dimensions.error());
    const BodyPlan plan = bodyPlanOf(*dimensions, posture);
    Anatomy anatomy;
    anatomy.name = nameOf(parameters);
    if (posture == Posture::Laryngoscopy)
        anatomy.contentHash = madeHash(parameters);
    anatomy.landmarks = plan.landmarks;
    anatomy.parts = partsOf(plan);
    for (const AnatomyPart& part : anatomy.parts) {
        for (const TriangleMesh& level : part.levels) {
            if (!isClosed(level) || !(signedVolume(level) > 0.0))
                return fail(Errc::MeshNotClosed, part.name);
        }
    }
    return anatomy;
}

Result<Anatomy> builtinPatient(BuiltinPatient patient) { return patientFor(parametersOf(patient)); }

} // namespace carina
