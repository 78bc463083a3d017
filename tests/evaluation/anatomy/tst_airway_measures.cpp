#include "evaluation/anatomy/airway_measures.h"
#include "evaluation/anatomy/mesh_outline.h"
#include "evaluation/anatomy/surface_distance.h"
#include "tests/evaluation/anatomy/known_airway.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::airway_measures_test
{

class TestAirwayMeasures final : public QObject
{
    Q_OBJECT

    static constexpr double kExact = 1e-7; // metres; positions are single precision
    static constexpr double kExactDegrees = 0.01;

    static bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < kExact; }

private Q_SLOTS:
    void cutsABoxInOneOutline()
    {
        const TriangleMesh box = test::boxOf({0.0, 0.0, 0.0}, {2.0, 4.0, 6.0});
        const auto outlines = outlinesOf(box, {0.0, 0.0, 1.5}, Vec3::UnitZ());
        QCOMPARE(outlines.size(), std::size_t{1});
        QCOMPARE(outlines[0].area, 8.0);
        QVERIFY(near(outlines[0].centroid, {1.0, 2.0, 1.5}));
        QCOMPARE(outlines[0].extentAlong(Vec3::UnitX()), 2.0);
        QCOMPARE(outlines[0].extentAlong(Vec3::UnitY()), 4.0);
        QVERIFY(outlinesOf(box, {0.0, 0.0, 7.0}, Vec3::UnitZ()).empty());
    }

    void cutsTwoBoxesInTwoOutlines()
    {
        TriangleMesh boxes = test::boxOf({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
        append(boxes, test::boxOf({5.0, 0.0, 0.0}, {7.0, 1.0, 1.0}));
        const auto outlines = outlinesOf(boxes, {0.0, 0.0, 0.5}, Vec3::UnitZ());
        QCOMPARE(outlines.size(), std::size_t{2});
        QCOMPARE(outlines[0].area + outlines[1].area, 3.0);
    }

    void leavesOutWhatDoesNotClose()
    {
        TriangleMesh open = test::boxOf({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
        open.triangles.erase(open.triangles.begin() + 4); // of the side at y = 0
        QVERIFY(outlinesOf(open, {0.0, 0.0, 0.5}, Vec3::UnitZ()).empty());
    }

    void findsTheLineOfATubeFromABadGuess()
    {
        const Vec3 axis = Vec3{0.3, -0.2, 1.0}.normalized();
        const TriangleMesh tube = test::tubeOf(-0.02 * axis, 0.12 * axis, 0.01, 0.007);
        const auto line = lineThrough(tube, Vec3::Zero(), {Vec3::Zero(), Vec3::UnitZ()},
                                      metres(0.02), metres(0.1));
        QVERIFY(line.has_value());
        QVERIFY((line->direction - axis).norm() < 1e-5);
        QVERIFY(line->point.cross(axis).norm() < 1e-6);
        QVERIFY(!lineThrough(tube, Vec3::Zero(), {Vec3::Zero(), axis}, metres(0.09), metres(0.2)));
        QVERIFY(lineThrough(tube, Vec3::Zero(), {Vec3::Zero(), axis}, metres(0.09), metres(0.14)));
    }

    void keepsToTheTubeNearestToTheLine()
    {
        TriangleMesh tubes = test::tubeOf({0.0, 0.0, 0.0}, {0.0, 0.0, 0.1}, 0.005, 0.005);
        append(tubes, test::tubeOf({0.03, 0.0, 0.0}, {0.03, 0.0, 0.1}, 0.01, 0.01));
        const auto line = lineThrough(tubes, Vec3::Zero(), {{0.001, 0.0, 0.0}, Vec3::UnitZ()},
                                      metres(0.01), metres(0.09));
        QVERIFY(line.has_value());
        QVERIFY(std::abs(line->point.x()) < kExact);
    }

    void measuresWhatItWasMadeWith_data()
    {
        QTest::addColumn<double>("size");
        QTest::newRow("as it is") << 1.0;
        QTest::newRow("larger") << 1.3;
    }
    void measuresWhatItWasMadeWith()
    {
        QFETCH(double, size);
        const auto m = measureAirway(test::anatomyOf({}, size));
        QVERIFY(m.has_value());
        QVERIFY(std::abs(m->trachea.si - 0.100 * size) < kExact);
        QVERIFY(std::abs(m->coronal.si - 0.020 * size) < kExact);
        QVERIFY(std::abs(m->sagittal.si - 0.016 * size) < kExact);
        QVERIFY(std::abs(inDegrees(m->rightBronchus) - 27.0) < kExactDegrees);
        QVERIFY(std::abs(inDegrees(m->leftBronchus) - 46.0) < kExactDegrees);
        QVERIFY(std::abs(m->cordsToCarina.si - 0.120 * size) < kExact);
        QVERIFY(std::abs(m->teethToCarina.si - 0.230 * size) < kExact);
    }

    void measuresTheOutsideOfATracheaWithAWall()
    {
        Anatomy anatomy = test::anatomyOf({});
        const Vec3 up = anatomy.landmarks.p_A_glottis.normalized();
        TriangleMesh& trachea = anatomy.parts.front().levels.front();
        for (const double share : {0.8, 0.5}) // its lumen, and a tube in it
            append(trachea, test::tubeOf(Vec3::Zero(), 0.108 * up, share * 0.010, share * 0.008));
        const auto m = measureAirway(anatomy);
        QVERIFY(m.has_value());
        QVERIFY(std::abs(m->coronal.si - 0.020) < kExact);
        QVERIFY(std::abs(m->sagittal.si - 0.016) < kExact);
    }

    void takesTheTracheasEndWithoutACricoid()
    {
        Anatomy anatomy = test::anatomyOf({});
        std::erase_if(anatomy.parts,
                      [](const AnatomyPart& part) { return part.role == PartRole::Larynx; });
        QVERIFY(std::abs(measureAirway(anatomy)->trachea.si - 0.108) < kExact);
    }

    void measuresNothingWithoutATracheaABronchusOrLandmarks()
    {
        for (const PartRole role :
             {PartRole::Trachea, PartRole::RightMainBronchus, PartRole::LeftMainBronchus}) {
            Anatomy anatomy = test::anatomyOf({});
            std::erase_if(anatomy.parts,
                          [&](const AnatomyPart& part) { return part.role == role; });
            QVERIFY(!measureAirway(anatomy));
        }
        Anatomy anatomy = test::anatomyOf({});
        anatomy.landmarks.path_A.clear();
        QVERIFY(!measureAirway(anatomy));
    }

    void measuresTheMeanDistanceOfASurface()
    {
        const TriangleMesh wall = test::boxOf({-4.0, -9.0, -9.0}, {0.0, 9.0, 9.0});
        const auto square = [](std::initializer_list<float> at) {
            TriangleMesh mesh; // strips of the unit square from x to x
            for (auto x = at.begin(); x + 1 != at.end(); ++x) {
                const auto k = std::uint32_t(mesh.positions.size());
                mesh.positions.insert(mesh.positions.end(),
                                      {{x[0], 0, 0}, {x[1], 0, 0}, {x[1], 1, 0}, {x[0], 1, 0}});
                mesh.triangles.push_back({k, k + 1, k + 2});
                mesh.triangles.push_back({k, k + 2, k + 3});
            }
            return mesh;
        };
        // From a square that leads away from a wall the distance is x, whose mean is a half.
        const double expected = 0.5;
        const SurfaceTree tree{wall};
        QVERIFY(std::abs(meanDistance(square({0, 1}), tree, metres(9.0)).si - expected) < 1e-12);
        QVERIFY(std::abs(meanDistance(square({0, 1}), tree, metres(0.1)).si - expected) < 1e-12);
        // However unevenly it is cut.
        const auto uneven = square({0, 0.01F, 0.02F, 0.04F, 0.05F, 1});
        QVERIFY(std::abs(meanDistance(uneven, tree, metres(9.0)).si - expected) < 1e-9);
    }

    void samplesWithinTheSpacing()
    {
        // Over a thin rod only close samples see how the distance changes: |x| over -1 to 1.
        const TriangleMesh rod = test::boxOf({-1e-6, -5.0, -1e-6}, {1e-6, 5.0, 1e-6});
        TriangleMesh strip;
        strip.positions = {{-1, 0, 0}, {1, 0, 0}, {1, 1e-3F, 0}, {-1, 1e-3F, 0}};
        strip.triangles = {{0, 1, 2}, {0, 2, 3}};
        QVERIFY(std::abs(meanDistance(strip, SurfaceTree{rod}, metres(0.02)).si - 0.5) < 1e-3);
    }
};

CARINA_TEST(TestAirwayMeasures)

} // namespace carina::airway_measures_test

#include "tst_airway_measures.moc"
