#include "engine/tracking/markers/probe.h"

#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <numbers>

namespace carina::probe_test
{
namespace
{

constexpr int kTrials = 40'000;
constexpr double kAgree = 0.03; // of an RMS error

/// Four markers of a pointer, and one that faces away.
Probe pointer()
{
    const Vec3 ahead = Vec3::UnitZ();
    return {.markers = {{{0.0, 0.0, 0.0}, ahead},
                        {{0.050, 0.004, 0.0}, ahead},
                        {{-0.008, 0.080, 0.010}, ahead},
                        {{-0.040, -0.045, -0.012}, Vec3{0.3, 0.2, 1.0}.normalized()},
                        {{0.010, 0.010, -0.030}, -ahead}}};
}

const Vec3 kD_O = Vec3{0.2, -0.3, 1.0}.normalized();
const std::array kPoints{Vec3{0.0, 0.0, 0.0}, Vec3{0.0, 0.0, -0.150}, Vec3{0.3, 0.1, 0.0}};

/// The errors of poses that another fit (Horn's) makes of markers drawn with this noise: RMS turn,
/// and RMS way of each point.
std::array<double, 4> drawnErrors(const Probe& probe, const MarkerNoise& noise)
{
    test::Hand hand{11};
    const double ratio = noise.depthRatio;
    const double across = noise.rms.si / std::sqrt(2.0 + ratio * ratio);
    const Vec3 side = kD_O.unitOrthogonal();
    std::array<double, 4> squares{};
    std::vector<Vec3> p_O;
    for (std::size_t i = 0; i < 4; ++i)
        p_O.push_back(probe.markers[i].p_OQ);
    for (int trial = 0; trial < kTrials; ++trial) {
        std::vector<Vec3> seen;
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3 unit = hand.unit();
            seen.push_back(
                p_O[i] + noise.outward.si * probe.markers[i].normal_O
                + across
                      * (unit.x() * side + unit.y() * kD_O.cross(side) + ratio * unit.z() * kD_O));
        }
        const RigidTransform X_OO = test::hornFit(seen, p_O);
        squares[0] += std::pow(angleOf(X_OO.rotation()).si, 2) / kTrials;
        for (std::size_t k = 0; k < kPoints.size(); ++k)
            squares[k + 1] += (X_OO * kPoints[k] - kPoints[k]).squaredNorm() / kTrials;
    }
    for (double& each : squares)
        each = std::sqrt(each);
    return squares;
}

} // namespace

class TestProbe : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void predictsTheErrorThatManyPosesHave_data()
    {
        QTest::addColumn<double>("rms_mm");
        QTest::addColumn<double>("depthRatio");
        QTest::addColumn<double>("outward_mm");
        QTest::newRow("alike in all directions") << 0.1 << 1.0 << 0.0;
        QTest::newRow("three times in depth") << 0.35 << 3.0 << 0.0;
        QTest::newRow("with a constant part") << 0.1 << 1.0 << 0.2;
        QTest::newRow("both") << 0.2 << 3.0 << -0.4;
    }

    void predictsTheErrorThatManyPosesHave()
    {
        QFETCH(double, rms_mm);
        QFETCH(double, depthRatio);
        QFETCH(double, outward_mm);
        const MarkerNoise noise{millimetres(rms_mm), depthRatio, millimetres(outward_mm)};
        const auto predicted = poseError(pointer(), kD_O, noise);
        QVERIFY(predicted.has_value());
        QCOMPARE(predicted->markers, std::size_t{4});
        const auto drawn = drawnErrors(pointer(), noise);
        QVERIFY(std::abs(predicted->rotation().si / drawn[0] - 1.0) < kAgree);
        for (std::size_t k = 0; k < kPoints.size(); ++k)
            QVERIFY(std::abs(predicted->at(kPoints[k]).si / drawn[k + 1] - 1.0) < kAgree);
    }

    void seesTheMarkersThatFaceTheTracker()
    {
        Probe probe = pointer();
        QCOMPARE(facingMarkers(probe, Vec3::UnitZ()).size(), std::size_t{4});
        QCOMPARE(facingMarkers(probe, -Vec3::UnitZ()), std::vector<std::size_t>{4});
        probe.largestAngle = degrees(10.0);
        QCOMPARE(facingMarkers(probe, Vec3::UnitZ()), (std::vector<std::size_t>{0, 1, 2}));
        for (ToolMarker& marker : probe.markers)
            marker.normal_O.setZero();
        QCOMPARE(facingMarkers(probe, Vec3::UnitX()).size(), std::size_t{5});
        QCOMPARE(poseError(pointer(), -Vec3::UnitZ(), {}).error().code, Errc::TooFewLandmarks);
    }

    void countsDirectionsByTheirArea()
    {
        // Three markers that face up within 60 degrees: a quarter of the sphere.
        Probe probe{.markers = {{{0.0, 0.0, 0.0}, Vec3::UnitZ()},
                                {{0.05, 0.0, 0.0}, Vec3::UnitZ()},
                                {{0.0, 0.05, 0.0}, Vec3::UnitZ()}},
                    .largestAngle = degrees(60.0)};
        const ProbeSurvey survey = surveyProbe(probe, {}, Vec3::Zero(), 4000);
        constexpr double kOfTheSphere = 1e-3;
        QVERIFY(std::abs(survey.share[3] - 0.25) < kOfTheSphere);
        QVERIFY(std::abs(survey.posed - 0.25) < kOfTheSphere);
        QCOMPARE(survey.fewest, std::size_t{0});
        // Where all are seen, the error is that of one direction.
        const auto one = poseError(probe, Vec3::UnitZ(), {});
        QVERIFY(std::abs(survey.rotation / one->rotation() - 1.0) < 1e-9);
        QVERIFY(std::abs(survey.position / one->at(Vec3::Zero()) - 1.0) < 1e-9);
    }

    void spreadsDirectionsEvenly()
    {
        const auto directions = directionsAllRound(1000);
        Vec3 mean = Vec3::Zero();
        Mat3 scatter = Mat3::Zero();
        for (const Vec3& d : directions) {
            QVERIFY(std::abs(d.norm() - 1.0) < 1e-12);
            mean += d / 1000.0;
            scatter += d * d.transpose() / 1000.0;
        }
        QVERIFY(mean.norm() < 2e-3);
        QVERIFY((scatter - Mat3::Identity() / 3.0).norm() < 2e-3);
    }
};

CARINA_TEST(TestProbe)

} // namespace carina::probe_test

#include "tst_probe.moc"
