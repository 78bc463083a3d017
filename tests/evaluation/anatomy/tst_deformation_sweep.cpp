#include "evaluation/anatomy/deformation_sweep.h"

#include "engine/anatomy/chest/chest_region.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "tests/support/test_class.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <set>

namespace carina::deformation_sweep_test
{
namespace
{

constexpr double kDifference_m = 1e-5; ///< of places between which a gradient is taken
constexpr double kTolerance = 1e-4;    ///< of a determinant from differences
/// The surfaces as they are; 8 positions of the head; 4 of the jaw in 5 of the head; 9 blades in 5
/// steps, and 4 ways to lift in 5 positions of the head; 23 events, and all of them, with a blade
/// and without. docs/deformation.md has the number.
constexpr std::size_t kLimits = 1 + 8 + 4 * 5 + 9 * 5 + 4 * 5 + 2 * (24 + 1);

/// The child as if his surfaces had been made with the mouth shut, so that nothing moves while no
/// part of a combination does.
const Anatomy& patient()
{
    static const Anatomy made = [] {
        Anatomy child = builtinPatient(BuiltinPatient::TwelveYears).value();
        child.contentHash.clear();
        return child;
    }();
    return made;
}

DeformationSweep sweepOf(std::optional<std::size_t> level = {})
{
    return DeformationSweep::of(patient(), level).value();
}

const DeformedPart* partNamed(const std::vector<DeformedPart>& parts, const char* name)
{
    const auto found = std::ranges::find(parts, std::string{name}, &DeformedPart::name);
    return found == parts.end() ? nullptr : &*found;
}

/// Of the motion of a neck, by differences.
double determinantAt(const NeckField& neck, const Vec3& p_A)
{
    Mat3 gradient;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 step = kDifference_m * Vec3::Unit(axis);
        gradient.col(axis) =
            (neck.placed(p_A + step) - neck.placed(p_A - step)) / (2.0 * kDifference_m);
    }
    return gradient.determinant();
}

} // namespace

class TestDeformationSweep : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsNothingWhereNothingMoves() { QVERIFY(sweepOf().deformedBy({}).empty()); }

    /// Surfaces that were made with the mouth held open are left so, and the mouth can be shut.
    void leavesTheJawAsItWasMade()
    {
        const Anatomy open = builtinPatient(BuiltinPatient::TwelveYears).value();
        const DeformationSweep sweep = DeformationSweep::of(open, {}).value();
        QVERIFY(sweep.deformedBy({}).empty());
        QVERIFY(partNamed(sweep.deformedBy({.jaw = SweptJaw{}}), "Tongue") != nullptr);
    }

    void leavesOutWhatGoesWithTheHead()
    {
        const auto parts = sweepOf().deformedBy({.head = kSniffing});
        QVERIFY(partNamed(parts, "Skin") != nullptr);
        int upper = 0;
        for (const AnatomyPart& part : patient().parts)
            if (part.role == PartRole::Tooth && !movesWithMandible(part)) {
                QVERIFY2(partNamed(parts, part.name.c_str()) == nullptr, part.name.c_str());
                ++upper;
            }
        QVERIFY(upper > 0);
        // An event deforms them all the same.
        const auto prominent = sweepOf().deformedBy(
            {.head = {kMostFlexion, {}}, .events = {{AirwayEventKind::ProminentIncisors, 1.0}}});
        QVERIFY(std::ranges::any_of(patient().parts, [&](const AnatomyPart& part) {
            return part.role == PartRole::Tooth && partNamed(prominent, part.name.c_str());
        }));
    }

    /// Skin, which the neck alone moves: the determinant is that of differences, and the least.
    void hasTheLeastDeterminantOfEachPart()
    {
        const HeadPosition position{kMostFlexion, {}};
        const auto parts = sweepOf().deformedBy({.head = position});
        const DeformedPart* skin = partNamed(parts, "Skin");
        QVERIFY(skin != nullptr);
        const AirwayLandmarks& marks = patient().landmarks;
        const NeckField neck{marks.p_A_glottis, marks.p_A_incisors, position};
        QVERIFY(skin->leastDeterminant < 0.9);
        QVERIFY(std::abs(determinantAt(neck, skin->p_A_least) - skin->leastDeterminant)
                < kTolerance);
        const auto part =
            std::ranges::find(patient().parts, std::string{"Skin"}, &AnatomyPart::name);
        for (const Vec3f& p : part->levels.back().positions)
            QVERIFY(determinantAt(neck, p.cast<double>()) > skin->leastDeterminant - kTolerance);
    }

    /// A jaw that is 20 cm in front of its place draws the tongue through itself.
    void countsWhatMeetsItself()
    {
        const auto torn = sweepOf().deformedBy({.jaw = SweptJaw{{}, metres(0.2)}});
        const auto worst = std::ranges::max(torn, {}, &DeformedPart::intersections);
        QVERIFY(worst.intersections > 10);
        for (const DeformedPart& part :
             sweepOf().deformedBy({.jaw = SweptJaw{{}, millimetres(0.02)}}))
            QVERIFY2(part.intersections == 0 && part.leastDeterminant > 0.99, part.name.c_str());
    }

    void leavesOutWhatTheJawTakesAlong()
    {
        const auto parts = sweepOf().deformedBy({.jaw = SweptJaw{degrees(10.0), {}}});
        QVERIFY(partNamed(parts, "Tongue") != nullptr);
        for (const char* name : {"Mandible", "Lower lip", "Gingiva of lower jaw"})
            QVERIFY2(partNamed(parts, name) == nullptr, name);
        // An event deforms it all the same.
        const auto swollen =
            sweepOf().deformedBy({.events = {{AirwayEventKind::AngioOedema, 1.0}}});
        QVERIFY(partNamed(swollen, "Lower lip") != nullptr);
    }

    void takesTheLevelThatIsAskedFor()
    {
        const DeformationCombination extended{.head = {{}, kMostExtension}};
        QCOMPARE(partNamed(sweepOf().deformedBy(extended), "Tongue")->level, std::size_t{2});
        QCOMPARE(partNamed(sweepOf(1).deformedBy(extended), "Tongue")->level, std::size_t{1});
        QCOMPARE(partNamed(sweepOf(9).deformedBy(extended), "Tongue")->level, std::size_t{2});
    }

    /// Another place of the blade is another deformation.
    void movesTissueByTheBlade()
    {
        const SweptBlade atTeeth{};
        const SweptBlade lifted{.progress = 4.0, .lift = kUsualLift};
        const auto atFirst = sweepOf().deformedBy({.blade = atTeeth});
        const auto then = sweepOf().deformedBy({.blade = lifted});
        QVERIFY(partNamed(then, "Epiglottis") != nullptr);
        QVERIFY(std::abs(partNamed(atFirst, "Tongue")->leastDeterminant
                         - partNamed(then, "Tongue")->leastDeterminant)
                > kTolerance);
    }

    void hasEachLimit()
    {
        const auto limits = limitsOfDeformation();
        QCOMPARE(limits.size(), kLimits);
        const DeformationCombination& asMade = limits.front();
        QVERIFY(asMade.head == HeadPosition{} && !asMade.jaw && !asMade.blade);
        QVERIFY(asMade.events.empty());
        std::set<AirwayEventKind> events;
        std::set<BladeKind> blades;
        int corners = 0;
        for (const DeformationCombination& limit : limits) {
            QVERIFY(!limit.seed && areProper(limit.events));
            QVERIFY(withinReach(limit.head) == limit.head);
            for (const AirwayEvent& event : limit.events)
                events.insert(event.kind);
            if (limit.blade)
                blades.insert(limit.blade->kind);
            const bool isCorner = limit.head.flexion != Angle{} && limit.head.extension != Angle{};
            corners += isCorner ? 1 : 0;
        }
        QCOMPARE(int(events.size()), kAirwayEventKinds);
        QCOMPARE(blades.size(), kBladeKinds.size());
        QVERIFY(corners >= 4);
        QVERIFY(std::ranges::any_of(limits, [](const DeformationCombination& limit) {
            return limit.jaw && limit.jaw->opening == kMostJawOpening
                   && limit.jaw->forward == kMostJawForward;
        }));
    }

    void drawsWithinTheLimitsAndAlikeForASeed()
    {
        constexpr std::uint32_t kSeeds = 300;
        int withBlade = 0;
        int withEvents = 0;
        for (std::uint32_t seed = 1; seed <= kSeeds; ++seed) {
            const DeformationCombination drawn = randomCombination(seed);
            const DeformationCombination again = randomCombination(seed);
            QCOMPARE(*drawn.seed, seed);
            QVERIFY(drawn.head == again.head && drawn.jaw->opening == again.jaw->opening
                    && drawn.events == again.events);
            QVERIFY(drawn.head != randomCombination(seed + 1).head);
            QVERIFY(withinReach(drawn.head) == drawn.head);
            QVERIFY(drawn.jaw->opening >= Angle{} && drawn.jaw->opening <= kMostJawOpening);
            QVERIFY(drawn.jaw->forward >= Length{} && drawn.jaw->forward <= kMostJawForward);
            QVERIFY(areProper(drawn.events));
            withEvents += drawn.events.empty() ? 0 : 1;
            withBlade += drawn.blade ? 1 : 0;
            if (!drawn.blade)
                continue;
            QVERIFY(drawn.blade->progress >= 0.0 && drawn.blade->progress <= 4.0);
            QVERIFY(drawn.blade->lift <= kMostSweptLift && drawn.blade->levering <= kMostLevering);
        }
        QVERIFY(withBlade > 150 && withBlade < 250); // two of three
        QVERIFY(withEvents > 150 && withEvents < 250);
    }

    void needsALarynx()
    {
        Anatomy without = patient();
        std::erase_if(without.parts,
                      [](const AnatomyPart& part) { return part.role == PartRole::Epiglottis; });
        QVERIFY(DeformationSweep::of(without, {}).error().code == Errc::NoAirway);
    }
};

CARINA_TEST(TestDeformationSweep)

} // namespace carina::deformation_sweep_test

#include "tst_deformation_sweep.moc"
