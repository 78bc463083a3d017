#include "engine/registration/fit/surface_refinement.h"

#include "tests/engine/registration/fit/swabbed_shapes.h"
#include "tests/support/test_class.h"

#include <limits>

namespace carina::refinement_refusals_test
{
namespace
{

const Vec3 kHalf{0.10, 0.06, 0.15}; // of a box, metres
const RigidTransform kX_AM{rotationFromVector({0.3, -0.8, 0.5}), {0.04, -0.11, 0.06}};

std::vector<Vec3> inManikin(const std::vector<Vec3>& p_A, double noise, std::mt19937& random)
{
    std::vector<Vec3> p_M;
    for (const Vec3& p : p_A)
        p_M.push_back(kX_AM.inverse() * (p + test::anyStep(noise, random)));
    return p_M;
}

} // namespace

/// Which swabs are not fitted to a surface, and why.
class TestRefinementRefusals : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void refuses_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<double>("shift_mm");
        QTest::addColumn<double>("noise_mm");
        QTest::addColumn<double>("spoilt");
        QTest::addColumn<Errc>("code");
        QTest::addColumn<QString>("why");
        QTest::newRow("19 points") << 19 << 1.0 << 0.0 << 0.0 << Errc::TooFewPoints
                                   << QStringLiteral("19 points, and 20 are the fewest");
        QTest::newRow("far from the surface") << 100 << 25.0 << 0.0 << 0.0 << Errc::NoSurfaceFit
                                              << QStringLiteral("15.00 mm are the most");
        QTest::newRow("no swab of this surface") << 100 << 1.0 << 8.0 << 0.0 << Errc::NoSurfaceFit
                                                 << QStringLiteral("(RMS) off the surface");
        QTest::newRow("no number") << 100 << 1.0 << 0.0 << std::numeric_limits<double>::quiet_NaN()
                                   << Errc::NotFinite << QStringLiteral("a point of the swab");
        QTest::newRow("a kilometre away") << 100 << 1.0 << 0.0 << 1000.0 << Errc::OutOfRange
                                          << QStringLiteral("a point of the swab");
    }

    void refuses()
    {
        QFETCH(int, points);
        QFETCH(double, shift_mm);
        QFETCH(double, noise_mm);
        QFETCH(double, spoilt);
        QFETCH(Errc, code);
        QFETCH(QString, why);
        const TriangleMesh box = test::box(kHalf);
        std::mt19937 random{9};
        auto p_MQ = inManikin(test::swabbed(box, points, random), noise_mm * 1e-3, random);
        p_MQ[7].y() += spoilt;
        const auto fit =
            refineOnSurface(SurfaceTree{box}, p_MQ,
                            RigidTransform::translation({0.0, 0.0, shift_mm * 1e-3}) * kX_AM,
                            {.farthestMove = millimetres(15.0)});
        QVERIFY(!fit);
        const QString detail = QString::fromStdString(fit.error().detail);
        QVERIFY2(fit.error().code == code && detail.contains(why), qPrintable(detail));
    }

    /// 150 points on the box, the others 5 cm off one of its sides.
    void refusesASwabOfWhichTooMuchLiesElsewhere()
    {
        const TriangleMesh box = test::box(kHalf);
        std::mt19937 random{13};
        auto p_AQ = test::swabbed(box, 150, random);
        for (int i = 0; i < 26; ++i)
            p_AQ.push_back({0.0, kHalf.y() + 0.05, 0.001 * i});
        const auto most = refineOnSurface(SurfaceTree{box}, inManikin(p_AQ, 0.0, random), kX_AM);
        QVERIFY2(most.has_value(), most ? "" : most.error().detail.c_str());
        QCOMPARE(most->outliers, 26);
        p_AQ.push_back(p_AQ.back());
        const auto more = refineOnSurface(SurfaceTree{box}, inManikin(p_AQ, 0.0, random), kX_AM);
        QVERIFY(!more);
        QCOMPARE(more.error().code, Errc::NoSurfaceFit);
        QCOMPARE(more.error().detail, std::string{"27 of 177 points do not lie on the surface"});
    }

    void refusesASwabOutOfReach()
    {
        std::mt19937 random{17};
        const TriangleMesh egg = test::ellipsoid({0.060, 0.045, 0.030});
        const auto p_MQ = inManikin(test::swabbed(egg, 100, random), 0.0, random);
        for (const double shift : {0.1, 0.4, 5.0}) {
            const RigidTransform start = RigidTransform::translation(Vec3::Constant(shift)) * kX_AM;
            const auto fit = refineOnSurface(SurfaceTree{egg}, p_MQ, start);
            QVERIFY(!fit);
            QCOMPARE(fit.error(),
                     (Error{Errc::NoSurfaceFit,
                            "no point of the swab lies within 30.00 mm of the surface"}));
        }
    }

    void takesTwentyPoints()
    {
        std::mt19937 random{10};
        const auto p_MQ = inManikin(test::swabbed(test::box(kHalf), 20, random), 0.0, random);
        QVERIFY(refineOnSurface(SurfaceTree{test::box(kHalf)}, p_MQ, kX_AM));
    }

    /// It tells how far the surface is, and nothing else.
    void takesASwabOfOnePlace()
    {
        const std::vector<Vec3> p_MQ(32, Vec3{0.03125, 0.0625, 0.0}); // of exact sums
        const auto fit = refineOnSurface(SurfaceTree{test::box(kHalf)}, p_MQ, {});
        QVERIFY2(fit.has_value(), fit ? "" : fit.error().detail.c_str());
        QCOMPARE(fit->loose.size(), std::size_t{5});
        QVERIFY(std::abs(fit->moved - 2.5e-3) < 1e-6);
    }

    void refusesAnEmptySurface()
    {
        std::mt19937 random{11};
        const auto fit =
            refineOnSurface(SurfaceTree{{}}, test::swabbed(test::box(kHalf), 30, random), {});
        QVERIFY(!fit);
        QCOMPARE(fit.error().code, Errc::NoSurfaceFit);
    }

    void refusesASwabThatStillMoves()
    {
        std::mt19937 random{15};
        const TriangleMesh egg = test::ellipsoid({0.09, 0.06, 0.13});
        const auto p_MQ = inManikin(test::swabbed(egg, 100, random), 0.2e-3, random);
        const RigidTransform start = RigidTransform::translation({4e-3, -3e-3, 5e-3}) * kX_AM;
        const auto fit = refineOnSurface(SurfaceTree{egg}, p_MQ, start, {.mostSteps = 2});
        QVERIFY(!fit);
        QCOMPARE(fit.error().code, Errc::NoSurfaceFit);
        QCOMPARE(fit.error().detail, std::string{"the swab still moves after 2 steps"});
        QVERIFY(refineOnSurface(SurfaceTree{egg}, p_MQ, start));
    }
};

CARINA_TEST(TestRefinementRefusals)

} // namespace carina::refinement_refusals_test

#include "tst_refinement_refusals.moc"
