#include "engine/tracking/igtl/igtl_pose.h"

#include "engine/geometry/rotation.h"
#include "tests/engine/tracking/igtl/igtl_samples.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace carina::igtl_pose_test
{
namespace
{

constexpr double kMetre = 1e-7; ///< single precision of millimetres, at 0.3 m
constexpr double kRadian = 1e-6;

bool isNear(const RigidTransform& a, const RigidTransform& b)
{
    return (a.translation() - b.translation()).norm() < kMetre
           && angleBetween(a.rotation(), b.rotation()) < radians(kRadian);
}

} // namespace

class IgtlPoseTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesMillimetresColumnByColumn()
    {
        const auto X = poseOf(test::kQuarterTurn);
        QVERIFY(X);
        const double half = std::sqrt(0.5);
        QVERIFY(isNear(*X, {Quat{half, 0, 0, half}, Vec3{0.010, -0.020, 0.030}}));
    }

    void readsWhatItWrote()
    {
        std::mt19937 random{7};
        std::uniform_real_distribution<double> amount{-0.3, 0.3};
        const auto any = [&] { return Vec3{amount(random), amount(random), amount(random)}; };
        for (int i = 0; i < 1000; ++i) {
            const RigidTransform X{rotationFromVector(9.0 * any()), any()};
            QVERIFY(isNear(poseOf(igtlMatrix(X)).value(), X));
            const auto p = igtlPoint(X.translation());
            const auto q = igtlQuaternion(X);
            QVERIFY(isNear(poseOf(IgtlPosition{p, q, 4}).value(), X));
            QVERIFY(isNear(poseOf(IgtlQuaternionTracked{"", 1, p, q}).value(), X));
        }
    }

    void bringsAQuaternionToUnitLength()
    {
        const auto X = poseOf(IgtlPosition{{}, {0.0F, 0.57735F, 0.57735F, 0.33333F}, 4});
        QVERIFY(X);
        QVERIFY(std::abs(X->rotation().norm() - 1.0) < 1e-12);
        QVERIFY(std::abs(X->rotation().w() - 0.33333 / 0.88192) < 1e-4);
    }

    void completesAQuaternion()
    {
        const auto half = poseOf(IgtlPosition{{}, {0.0F, 0.6F, 0.0F, 0.0F}, 3});
        QVERIFY(half && std::abs(half->rotation().w() - 0.8) < 1e-6);
        const auto none = poseOf(IgtlPosition{{1, 0, 0}, {}, 0});
        QVERIFY(none && isNear(*none, RigidTransform::translation({0.001, 0, 0})));
    }

    void refusesWhatIsNoPose()
    {
        IgtlMatrix mirrored = test::kQuarterTurn;
        mirrored[8] = -1;
        QCOMPARE(poseOf(mirrored).error().code, Errc::NotARotation);
        IgtlMatrix scaled = test::kQuarterTurn;
        scaled[8] = 1.01F;
        QCOMPARE(poseOf(scaled).error().code, Errc::NotARotation);
        IgtlMatrix infinite = test::kQuarterTurn;
        infinite[9] = std::numeric_limits<float>::infinity();
        QCOMPARE(poseOf(infinite).error().code, Errc::NotFinite);
        IgtlMatrix far = test::kQuarterTurn;
        far[9] = 100'001.0F;
        QCOMPARE(poseOf(far).error().code, Errc::OutOfRange);
        QCOMPARE(poseOf(IgtlPosition{{}, {0, 0, 0, 0.4F}, 4}).error().code, Errc::NotARotation);
        const float nan = std::numeric_limits<float>::quiet_NaN();
        QCOMPARE(poseOf(IgtlPosition{{}, {0, 0, 0, nan}, 4}).error().code, Errc::NotFinite);
    }

    void knowsAPlaceholder()
    {
        QVERIFY(isPlaceholder(poseOf(igtlMatrix(RigidTransform{})).value()));
        QVERIFY(!isPlaceholder(RigidTransform::translation({0, 0, 1e-6})));
        QVERIFY(!isPlaceholder({rotationFromVector({1e-5, 0, 0}), Vec3::Zero()}));
    }

    void convertsTimesBothWays()
    {
        // A half is a half, whichever the base.
        const std::uint64_t stamp = (std::uint64_t{1'234'567'890} << 32U) + 0x8000'0000U;
        const Duration since{1'234'567'890'500'000'000};
        QVERIFY(sinceEpoch(stamp) == since);
        QCOMPARE(igtlStamp(since), stamp);
        for (const std::int64_t ns : {1, 999'999'999, 1'000'000'001, 2'000'000'123})
            QVERIFY(sinceEpoch(igtlStamp(since + Duration{ns})) == since + Duration{ns});
    }

    void numbersTheCornersOfASecondSurfaceOn()
    {
        TriangleMesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.triangles = {{0, 1, 2}};
        IgtlPolyData data;
        appendSurface(data, RigidTransform{}, mesh);
        appendSurface(data, RigidTransform{Quat{0, 0, 0, 1}, Vec3::Zero()}, mesh);
        QCOMPARE(data.points.size(), std::size_t{6});
        QCOMPARE(data.points[1][0], 1000.0F);
        QCOMPARE(data.points[4][0], -1000.0F);
        QCOMPARE(data.cells[kIgtlPolygons].count, 2U);
        QVERIFY((data.cells[kIgtlPolygons].numbers
                 == std::vector<std::uint32_t>{3, 0, 1, 2, 3, 3, 4, 5}));
    }
};

CARINA_TEST(IgtlPoseTest)

} // namespace carina::igtl_pose_test

#include "tst_igtl_pose.moc"
