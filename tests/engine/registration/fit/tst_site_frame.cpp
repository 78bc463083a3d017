#include "engine/registration/fit/site_frame.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <limits>
#include <random>

namespace carina::site_frame_test
{
namespace
{

constexpr double kExact = 1e-12; // m, and as coefficients of a rotation

/// Notch, xiphoid, left and right rib in a frame F with +x left, +y posterior, +z superior, on a
/// sternum that stands upright: their mean is at (0, -10, -20) mm.
const std::vector<Vec3> kUpright_F{
    {0.0, 0.0, 0.08}, {0.0, 0.0, -0.08}, {0.07, -0.02, -0.04}, {-0.07, -0.02, -0.04}};
const Vec3 kMean_F{0.0, -0.01, -0.02};

std::vector<Vec3> seenBy(const RigidTransform& X_TF, const std::vector<Vec3>& p_FQ)
{
    std::vector<Vec3> p_TQ;
    for (const Vec3& p : p_FQ)
        p_TQ.push_back(X_TF * p);
    return p_TQ;
}

} // namespace

class TestSiteFrame : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void liesAtTheMeanWithItsAxesAlongTheBody()
    {
        // The left rib lies 20 mm before the sternum: +x goes 70 to the left and 20 forward.
        Mat3 R_FM;
        R_FM.col(0) = Vec3{0.07, -0.02, 0.0}.normalized();
        R_FM.col(1) = Vec3{0.02, 0.07, 0.0}.normalized();
        R_FM.col(2) = Vec3::UnitZ();
        std::mt19937 random{7};
        std::normal_distribution<double> part;
        for (int i = 0; i < 50; ++i) {
            const RigidTransform X_TF{Quat{part(random), part(random), part(random), part(random)},
                                      {part(random), part(random), part(random)}};
            const auto X_TM = siteFrame(seenBy(X_TF, kUpright_F));
            QVERIFY(X_TM.has_value());
            const RigidTransform X_FM = X_TF.inverse() * *X_TM;
            QVERIFY((X_FM.translation() - kMean_F).norm() < kExact);
            QVERIFY((X_FM.matrix().topLeftCorner<3, 3>() - R_FM).cwiseAbs().maxCoeff() < kExact);
        }
    }

    void takesThreePoints()
    {
        const auto X_TM = siteFrame(std::vector<Vec3>{{0, 0, 3}, {0, 0, 0}, {6, 0, 0}});
        QVERIFY(X_TM.has_value());
        Mat4 expected = Mat4::Identity();
        expected.topRightCorner<3, 1>() = Vec3{2, 0, 1};
        QVERIFY((X_TM->matrix() - expected).cwiseAbs().maxCoeff() < kExact);
    }

    void refusesPointsThatMakeNoFrame_data()
    {
        QTest::addColumn<std::vector<Vec3>>("p_TQ");
        QTest::addColumn<Errc>("expected");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("none") << std::vector<Vec3>{} << Errc::TooFewLandmarks;
        QTest::newRow("two") << std::vector<Vec3>{{0, 0, 1}, {0, 0, 0}} << Errc::TooFewLandmarks;
        QTest::newRow("no number")
            << std::vector<Vec3>{{0, 0, 1}, {0, 0, 0}, {nan, 0, 0}} << Errc::NotFinite;
        QTest::newRow("out of the room")
            << std::vector<Vec3>{{0, 0, 1}, {0, 0, 0}, {2e3, 0, 0}} << Errc::OutOfRange;
        QTest::newRow("first two together")
            << std::vector<Vec3>{{0, 0, 0.0009}, {0, 0, 0}, {1, 0, 0}} << Errc::DegenerateLandmarks;
        QTest::newRow("third on the first")
            << std::vector<Vec3>{{0, 0, 1}, {0, 0, 0}, {0, 0, 1}} << Errc::DegenerateLandmarks;
        QTest::newRow("nearly on one line, although the fourth is not")
            << std::vector<Vec3>{{0, 0, 1}, {0, 0, 0}, {0.0099, 0, 0.5}, {1, 0, 0}}
            << Errc::DegenerateLandmarks;
    }

    void refusesPointsThatMakeNoFrame()
    {
        QFETCH(std::vector<Vec3>, p_TQ);
        QFETCH(Errc, expected);
        const auto X_TM = siteFrame(p_TQ);
        QVERIFY(!X_TM);
        QCOMPARE(X_TM.error().code, expected);
    }

    void takesPointsJustOffOneLine()
    {
        QVERIFY(siteFrame(std::vector<Vec3>{{0, 0, 1}, {0, 0, 0}, {0.0101, 0, 0.5}}));
        QVERIFY(siteFrame(std::vector<Vec3>{{0, 0, 0.0011}, {0, 0, 0}, {1, 0, 0}}));
        // At the very limits, which these numbers meet to the last digit.
        QVERIFY(siteFrame(std::vector<Vec3>{{0, 0, 1}, {0, 0, 0}, {0.01, 0, 0.5}}));
        QVERIFY(siteFrame(std::vector<Vec3>{{0, 0, 0.001}, {0, 0, 0}, {1, 0, 0}}));
    }
};

CARINA_TEST(TestSiteFrame)

} // namespace carina::site_frame_test

#include "tst_site_frame.moc"
