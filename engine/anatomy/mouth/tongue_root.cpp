#include "engine/anatomy/mouth/tongue_root.h"

#include "engine/anatomy/airway/jaw_hinge.h"
#include "engine/anatomy/mouth/throat_air.h"
#include "engine/anatomy/skeleton/mandible_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace carina
{
namespace
{

/// All lengths are reference millimetres (BodyPlan).

constexpr Length kRootVoxel = millimetres(1.6);

/// Its top below the floor of the mouth, whose lining lies between; its height in grown people, and
/// what remains of that in children, whose throat is drawn out by kLongThroat.
constexpr double kBelowFloor = 3.2;
constexpr double kHigh = 18.0;
constexpr double kLeastHeight = 0.3;
constexpr double kLongThroat = 1.6;

/// In front it ends at the mandible, whose halves part behind it, as far as it is wide; farther
/// back it is narrower, before the wall of the pharynx. With the mouth closed.
constexpr double kFront = 19.0;
constexpr double kHalvesMeet = 3.0;
constexpr double kHalvesPart = 0.82;
constexpr double kRootHalfWidth = 27.5;
constexpr double kPharynx = 49.0;
constexpr double kNarrows = 1.2;
constexpr double kEdge = 7.0; ///< by which its edges are rounded

/// Its top slopes down beside the tongue, below the roots of the molars.
constexpr double kBesideTongue = 17.0;
constexpr double kSlope = 0.5;

constexpr double kBesideMandible = 0.6;
constexpr double kBelowTongue = 0.7;
constexpr double kBeforeEpiglottis = 11.0; ///< millimetres of LarynxFrame

/// Its foot seen from the side: y, and how much of its height lies above.
using Foot = std::array<std::array<double, 2>, 7>;
constexpr Foot kRest{
    {{12.0, -0.4}, {12.0, 0.5}, {25.0, 0.8}, {36.0, 1.0}, {50.0, 1.0}, {58.0, 0.7}, {60.0, -0.4}}};
/// The mandible has gone down and back.
constexpr Foot kHeld{
    {{28.0, -0.4}, {28.0, 0.5}, {38.0, 0.9}, {46.0, 1.15}, {54.0, 1.1}, {60.0, 0.7}, {62.0, -0.4}}};

double heightOf(const BodyPlan& plan)
{
    const double grown = std::clamp((kLongThroat - plan.throat) / (kLongThroat - 1.0), 0.0, 1.0);
    return kHigh * (kLeastHeight + (1.0 - kLeastHeight) * grown);
}

struct Root {
    BodyPlan plan;
    LarynxFrame larynx;
    Epiglottis epiglottis;
    Tongue tongue;
    ImplicitShape mandible; ///< with the mouth closed
    RigidTransform X_JA;    ///< to where a place of the jaw is with the mouth closed
    std::vector<Vec2> foot;
    double top;

    [[nodiscard]] double distance(const Vec3& p_A) const
    {
        const Vec3 p = plan.fromThroat(p_A);
        const Vec3 inJaw = plan.fromThroat(X_JA * p_A);
        const double half = std::min({kRootHalfWidth, kHalvesPart * (inJaw.y() - kHalvesMeet),
                                      kRootHalfWidth - kNarrows * (p.y() - kPharynx)});
        const double between = std::max(std::abs(p.x()) - half, kFront - inJaw.y());
        const double solid = roundedMax(polygonDistance({p.y(), p.z()}, foot), between, kEdge);
        const double tongueAbove = kBelowTongue - tongue.distance(p_A) / plan.face;
        const Vec3 inLarynx = larynx.local(p_A);
        const double behind = (inLarynx.y() - epiglottis.middleAt(inLarynx.z()) + kBeforeEpiglottis)
                              * larynx.unit() / plan.face;
        const double beside = kSlope * std::max(std::abs(p.x()) - kBesideTongue, 0.0);
        const double above = p.z() - top + beside;
        const double bone = kBesideMandible - mandible.distance(X_JA * p_A) / plan.face;
        return 0.8 * plan.face
               * roundedMax(solid, std::max({above, tongueAbove, behind, bone}), 1.5);
    }
};

} // namespace

PartPlan tongueRoot(const BodyPlan& plan, const LarynxFrame& larynx, const Epiglottis& epiglottis,
                    const Tongue& tongue)
{
    const bool rest = plan.posture == Posture::Rest;
    const double top = floorOfMouth_mm(plan.posture) - kBelowFloor;
    const double high = heightOf(plan);
    std::vector<Vec2> foot;
    for (const auto& [y, share] : rest ? kRest : kHeld)
        foot.emplace_back(y, top - share * high);
    const Root root{plan,
                    larynx,
                    epiglottis,
                    tongue,
                    mandibleShape(plan.inFace(kUpperToLowerIncisors), 1e3 * plan.face),
                    heldJaw(plan).inverse(),
                    cornersCut(std::move(foot), 2),
                    top};
    const Box bounds{plan.inThroat({-30.0, 10.0, top - 1.2 * high - 3.0}),
                     plan.inThroat({30.0, 66.0, top + 3.0})};
    const ImplicitShape shape{bounds, [root](const Vec3& p_A) { return root.distance(p_A); }};
    return {"Genioglossus and hyoglossus", PartRole::Tongue, "", shape,
            1e3 * plan.face * kRootVoxel};
}

} // namespace carina
