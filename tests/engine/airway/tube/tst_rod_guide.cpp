#include "engine/airway/tube/rod_guide.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>

namespace carina::rod_guide_test
{
namespace
{

constexpr double kExact = 1e-12;  // metres
constexpr double kRadius = 0.006; // of the sections, metres
constexpr double kBend = 0.05;    // of the guide, metres

/// A quarter of a circle about (0, 0, -kBend) from the origin towards +y and down, in sections that
/// stand on it.
RodGuide quarter()
{
    constexpr int kPieces = 20;
    RodGuide guide;
    for (int i = 0; i <= kPieces; ++i) {
        const double a = 0.5 * std::numbers::pi * i / kPieces;
        const AcrossWay across = acrossWay({0.0, std::cos(a), -std::sin(a)});
        GuideSection section{.p_A_centre = {0.0, kBend * std::sin(a), kBend * (std::cos(a) - 1.0)},
                             .side = across.side,
                             .back = across.back,
                             .isFree = false};
        section.sides.fill(kRadius);
        guide.add(section);
    }
    return guide;
}

} // namespace

class TestRodGuide : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A polygon of 16 sides that a circle touches: on it, between them, and beyond by how much.
    void tellsTheSidesThatAPlaceIsBeyond()
    {
        GuideSection section{.isFree = false};
        section.sides.fill(kRadius);
        const double half = std::numbers::pi / kLumenDirections;
        for (std::size_t k = 0; k < kLumenDirections; ++k) {
            const double angle = 2.0 * half * double(k);
            const double r = kRadius + 1e-4;
            const auto walls = section.wallsAt(r * std::cos(angle), r * std::sin(angle));
            QCOMPARE(walls.sides, 1U << k);
            QVERIFY(std::abs(walls.byU - 1e-4 * std::cos(angle)) < kExact);
            QVERIFY(std::abs(walls.byV - 1e-4 * std::sin(angle)) < kExact);
            QVERIFY(std::abs(section.share(r * std::cos(angle), r * std::sin(angle)) - r / kRadius)
                    < kExact);
            // A corner lies on two sides.
            const double corner = kRadius / std::cos(half);
            const double between = angle + half;
            QVERIFY(std::abs(section.share(corner * std::cos(between), corner * std::sin(between))
                             - 1.0)
                    < 1e-9);
        }
    }

    void countsASideThatIsKept()
    {
        GuideSection section{.isFree = false};
        section.sides.fill(kRadius);
        QCOMPARE(section.wallsAt(0.0, 0.0).sides, 0U);
        const auto kept = section.wallsAt(0.001, 0.0, 1U);
        QCOMPARE(kept.sides, 1U);
        QVERIFY(std::abs(kept.byU - (0.001 - kRadius)) < kExact);
    }

    void goesStraightOnBeyondItsEnds()
    {
        const RodGuide guide = quarter();
        std::size_t segment = 5;
        const Vec3 before = guide.at(-0.01, segment).p_A_centre;
        QCOMPARE(segment, std::size_t{0});
        const Vec3 begin = guide.at(0.0, segment).p_A_centre;
        QVERIFY(std::abs((before - begin).norm() - 0.01) < kExact);
        const Vec3 end = guide.at(guide.length(), segment).p_A_centre;
        const Vec3 beyond = guide.at(guide.length() + 0.01, segment).p_A_centre;
        QCOMPARE(segment, guide.size() - 2);
        QVERIFY(std::abs((beyond - end).norm() - 0.01) < kExact);
    }

    /// To second order in the way: with a tenth of it a hundredth of the error.
    void findsWhereAPlaceHasGone()
    {
        const RodGuide guide = quarter();
        const auto errorOf = [&](double size) {
            std::size_t segment = 0;
            const GuidedPlace place{.along = 0.0301, .u = 0.002, .v = -0.003};
            const GuideSection section = guide.at(place.along, segment);
            const Vec3 way = size * Vec3{0.3, 0.2, -0.9};
            const GuidedPlace there = moved(section, guide.slope(segment, place), place, way);
            const Vec3 p_A = guide.at(there.along, segment).at(there.u, there.v);
            return (p_A - section.at(place.u, place.v) - way).norm();
        };
        QVERIFY(errorOf(1e-4) < 0.015 * errorOf(1e-3));
    }

    /// On it the same as along its direction: what u and v change by with a way is perpendicular to
    /// the slope.
    void tellsWhatGoesAcrossIt()
    {
        const RodGuide guide = quarter();
        std::size_t segment = 0;
        const GuidedPlace place{.along = 0.0301, .u = 0.002, .v = -0.003};
        const GuideSection section = guide.at(place.along, segment);
        const Vec3 slope = guide.slope(segment, place);
        const AcrossGuide across = acrossGuide(section, slope);
        QVERIFY(std::abs(across.byU.dot(slope)) < kExact);
        QVERIFY(std::abs(across.byV.dot(slope)) < kExact);
        const Vec3 way{1e-4, -2e-4, 3e-4};
        const GuidedPlace there = moved(section, slope, place, way);
        QVERIFY(std::abs(there.u - place.u - across.byU.dot(way)) < 1e-9);
        QVERIFY(std::abs(there.v - place.v - across.byV.dot(way)) < 1e-9);
    }

    void findsAPlaceInFreeSpace()
    {
        RodGuide guide;
        guide.addFree(
            std::vector<Vec3>{{0, 0, 0}, {0, 0.02, 0}, {0, 0.039, -0.006}, {0, 0.055, -0.018}});
        const Vec3 p_A{0.004, 0.03, 0.006};
        std::size_t segment = 0;
        const GuidedPlace place = guide.placeOf(p_A, 0.01, segment);
        QVERIFY((guide.at(place.along, segment).at(place.u, place.v) - p_A).norm() < 1e-6);
    }
};

CARINA_TEST(TestRodGuide)

} // namespace carina::rod_guide_test

#include "tst_rod_guide.moc"
