#include "evaluation/anatomy/deformation_sweep.h"

#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/events/airway_changes.h"
#include "engine/anatomy/events/mouth_opening.h"
#include "engine/anatomy/events/neck_motion.h"
#include "engine/anatomy/laryngoscopy/blade_levering.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/geometry/mesh/surface_tree.h"
#include "engine/tracking/simulated/scripted_hands.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <random>

namespace carina
{
namespace
{

constexpr double kMoved_m = 1e-6; ///< a vertex that is less far from a place is there
constexpr double kSteps = 4.0;    ///< of laryngoscopyPose: the last one's number

/// In a neck that is flexed wholly a head is extended as far as in the sniffing position.
constexpr std::array kCornersOfHead{HeadPosition{kLeastFlexion, kLeastExtension},
                                    HeadPosition{kLeastFlexion, kMostExtension},
                                    HeadPosition{kMostFlexion, kLeastExtension}, kSniffing};

SweptBlade lifted(Length lift, Angle levering = {})
{
    return {.progress = kSteps, .lift = lift, .levering = levering};
}

void addHeads(std::vector<DeformationCombination>& all)
{
    for (const HeadPosition& head : kCornersOfHead)
        all.push_back({.head = head});
    for (const HeadPosition& head :
         {HeadPosition{kLeastFlexion, {}}, HeadPosition{kMostFlexion, {}},
          HeadPosition{{}, kLeastExtension}, HeadPosition{{}, kMostExtension}})
        all.push_back({.head = head});
}

void addJaws(std::vector<DeformationCombination>& all)
{
    for (const Angle opening : {Angle{}, kMostJawOpening})
        for (const Length forward : {Length{}, kMostJawForward}) {
            const SweptJaw jaw{opening, forward};
            all.push_back({.jaw = jaw});
            for (const HeadPosition& head : kCornersOfHead)
                all.push_back({.head = head, .jaw = jaw});
        }
}

void addBlades(std::vector<DeformationCombination>& all)
{
    for (const BladeKind kind : kBladeKinds)
        for (double progress = 0.0; progress <= kSteps; ++progress)
            all.push_back({.blade = SweptBlade{kind, progress, kUsualLift, {}}});
    for (const SweptBlade& blade : {lifted({}), lifted(kMostSweptLift), lifted({}, kMostLevering),
                                    lifted(kMostSweptLift, kMostLevering)}) {
        all.push_back({.blade = blade});
        for (const HeadPosition& head : kCornersOfHead)
            all.push_back({.head = head, .blade = blade});
    }
}

void addEvents(std::vector<DeformationCombination>& all)
{
    AirwayEvents together;
    for (int kind = 0; kind < kAirwayEventKinds; ++kind) {
        const AirwayEvent worst{static_cast<AirwayEventKind>(kind), 1.0};
        together.push_back(worst);
        all.push_back({.events = {worst}});
        all.push_back({.blade = lifted(kUsualLift), .events = {worst}});
    }
    all.push_back({.events = together});
    all.push_back({.blade = lifted(kUsualLift), .events = together});
}

/// Evenly from 0 to 1: the distributions of the library are not the same on every machine.
class Draw
{
public:
    explicit Draw(std::uint32_t seed) : m_random{seed} {}

    double share() { return double(m_random()) / double(std::mt19937::max()); }
    template <class Quantity> Quantity between(Quantity least, Quantity most)
    {
        return least + share() * (most - least);
    }
    std::uint32_t below(std::uint32_t count) { return std::uint32_t(m_random() % count); }

private:
    std::mt19937 m_random;
};

AirwayEvents drawnEvents(Draw& draw)
{
    AirwayEvents events;
    const std::uint32_t count = draw.below(3); // none in one of three
    for (std::uint32_t i = 0; i < count; ++i) {
        const AirwayEvent event{
            static_cast<AirwayEventKind>(draw.below(std::uint32_t(kAirwayEventKinds))),
            draw.share()};
        if (std::ranges::find(events, event.kind, &AirwayEvent::kind) == events.end())
            events.push_back(event);
    }
    std::ranges::sort(events, {}, &AirwayEvent::kind);
    return events;
}

/// The fields of one combination, as the programs draw it.
struct Fields {
    AirwayField airway;
    FollowingThroat throat;
    BladeField blade;
};

/// A surface, and the determinant of the gradient of what has deformed it, vertex by vertex.
struct DeformedSurface {
    TriangleMesh mesh;
    std::vector<Vec3> places;         ///< in double precision
    std::vector<double> determinants; ///< of all so far: a product
};

template <class PullAt> void displace(DeformedSurface& surface, const PullAt& pullAt)
{
    for (std::size_t i = 0; i < surface.places.size(); ++i) {
        const DisplacementAt<double> pull = pullAt(surface.places[i]);
        surface.places[i] += pull.d;
        surface.determinants[i] *= (Mat3::Identity() + pull.gradient).determinant();
    }
}

/// @param goesWithJaw what the mandible takes along as a rigid body, which events alone deform
DeformedSurface deformedSurface(const Fields& fields, const TriangleMesh& mesh_A,
                                ChestRegion region, bool goesWithJaw)
{
    DeformedSurface surface{.mesh = mesh_A, .places = {}, .determinants = {}};
    for (const Vec3f& p : mesh_A.positions)
        surface.places.emplace_back(p.cast<double>());
    surface.determinants.assign(surface.places.size(), 1.0);
    const auto moved = airwayTissueOf(region);
    if (moved && fields.airway.isThere())
        displace(surface,
                 [&](const Vec3& p) { return airwayPull(fields.airway.frame(), *moved, p); });
    if (!goesWithJaw) {
        if (fields.throat.neck.isBent())
            displace(surface, [&](const Vec3& p) {
                return neckPull<double>(fields.throat.neck.frame(), p);
            });
        if (const auto tissue = tissueOf(region))
            displace(surface, [&](const Vec3& p) { return throatPull(fields.throat, *tissue, p); });
        if (moved && fields.blade.isThere())
            displace(surface,
                     [&](const Vec3& p) { return bladePull(fields.blade.frame(), *moved, p); });
    }
    for (std::size_t i = 0; i < surface.places.size(); ++i)
        surface.mesh.positions[i] = surface.places[i].cast<float>();
    return surface;
}

bool isTakenBy(const RigidTransform& X, const TriangleMesh& from, const TriangleMesh& to)
{
    return std::ranges::equal(from.positions, to.positions, [&X](const Vec3f& a, const Vec3f& b) {
        return (b.cast<double>() - X * a.cast<double>()).norm() < kMoved_m;
    });
}

/// Otherwise it stays, or goes with the head.
bool isDeformed(const TriangleMesh& from, const TriangleMesh& to, const NeckField& neck)
{
    return !isTakenBy({}, from, to) && !isTakenBy(neck.X_AU(), from, to);
}

DeformedPart measured(const AnatomyPart& part, std::size_t level, const DeformedSurface& surface)
{
    DeformedPart found{.name = part.name, .level = level};
    found.intersections = SurfaceTree{surface.mesh}.selfIntersections();
    const auto least = std::ranges::min_element(surface.determinants);
    if (least != surface.determinants.end()) {
        found.leastDeterminant = *least;
        const auto vertex = std::size_t(least - surface.determinants.begin());
        found.p_A_least = part.levels[level].positions[vertex].cast<double>();
    }
    return found;
}

} // namespace

std::vector<DeformationCombination> limitsOfDeformation()
{
    std::vector all{DeformationCombination{}};
    addHeads(all);
    addJaws(all);
    addBlades(all);
    addEvents(all);
    return all;
}

DeformationCombination randomCombination(std::uint32_t seed)
{
    Draw draw{seed};
    DeformationCombination drawn;
    drawn.seed = seed;
    const Angle flexion = draw.between(kLeastFlexion, kMostFlexion);
    drawn.head = withinReach({flexion, draw.between(kLeastExtension, kMostExtension)});
    drawn.jaw = {.opening = draw.between(Angle{}, kMostJawOpening),
                 .forward = draw.between(Length{}, kMostJawForward)};
    if (draw.below(3) != 0)
        drawn.blade = {.kind = kBladeKinds.at(draw.below(std::uint32_t(kBladeKinds.size()))),
                       .progress = draw.between(0.0, kSteps),
                       .lift = draw.between(Length{}, kMostSweptLift),
                       .levering = draw.between(Angle{}, kMostLevering)};
    drawn.events = drawnEvents(draw);
    return drawn;
}

Result<DeformationSweep> DeformationSweep::of(const Anatomy& patient,
                                              std::optional<std::size_t> level)
{
    return upperAirwayOf(patient.parts, patient.landmarks).map([&](UpperAirway&& airway) {
        const AirwayLandmarks& marks = patient.landmarks;
        DeformationSweep sweep;
        sweep.m_patient = &patient;
        sweep.m_level = level;
        sweep.m_airway = std::move(airway);
        sweep.m_throat = {marks.p_A_carina, marks.p_A_glottis, marks.p_A_incisors};
        sweep.m_held = heldJaw(patient.contentHash);
        return sweep;
    });
}

std::vector<DeformedPart>
DeformationSweep::deformedBy(const DeformationCombination& combination) const
{
    const AirwayLandmarks& marks = m_patient->landmarks;
    Fields fields;
    fields.airway = airwayChanges(m_airway, combination.events);
    UpperAirway airway = changed(m_airway, fields.airway);
    airway.mostOpening = mostMouthOpening(combination.events, m_airway.size());
    const NeckField neck{marks.p_A_glottis, marks.p_A_incisors,
                         withinMotion(combination.head, combination.events)};
    const auto throatWith = [&](const RigidTransform& X_AJ) {
        const RigidTransform within =
            airway.mostOpening ? withinOpening(X_AJ, marks.p_A_incisors, *airway.mostOpening)
                               : X_AJ;
        return FollowingThroat{m_throat, within * m_held.inverse(), neck};
    };
    if (const auto& swept = combination.blade) {
        const Blade& blade = bladeOf(swept->kind);
        const LaryngoscopyPose pose =
            laryngoscopyPose(airway, m_throat, blade, swept->progress, swept->lift, m_held, neck);
        fields.throat = throatWith(pose.X_AJ);
        const RigidTransform X_AL =
            levered(blade.form, pose.X_AL, neck.placed(airway.p_A_edge()), swept->levering);
        fields.blade = bladeInTissue(followed(airway, fields.throat), blade, X_AL);
    } else {
        const auto& jaw = combination.jaw;
        const double size = std::min(m_airway.size(), 1.0);
        fields.throat = throatWith(
            jaw ? movedJaw(marks.p_A_incisors, jaw->opening, jaw->forward, size) : m_held);
    }
    std::vector<DeformedPart> parts;
    for (const AnatomyPart& part : m_patient->parts) {
        const std::size_t coarsest = part.levels.size() - 1;
        const std::size_t level = std::min(m_level.value_or(coarsest), coarsest);
        const DeformedSurface surface =
            deformedSurface(fields, part.levels[level], regionOf(part), movesWithMandible(part));
        if (isDeformed(part.levels[level], surface.mesh, neck))
            parts.push_back(measured(part, level, surface));
    }
    return parts;
}

} // namespace carina
