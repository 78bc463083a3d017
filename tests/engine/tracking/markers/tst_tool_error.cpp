#include "engine/tracking/markers/tool_error.h"

#include "engine/geometry/rotation.h"
#include "tests/support/test_class.h"

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>
#include <vector>

namespace carina::tool_error_test
{
namespace
{

constexpr double kFle = 0.35e-3; // m
constexpr double kAgree = 1e-6;  // of an RMS error; a least variance is added to each marker

/// Upright before the tracker, its markers facing it.
const PoseSample kSeen{.X_FO = {rotationFromVector({0.1, -0.2, 0.7}), Vec3{0.05, -0.1, -1.2}}};

const std::array kTips{Vec3{0.0, 0.0, -0.15}, Vec3{0.03, -0.2, 0.0}, Vec3{0.0, 0.0, 0.0}};

/// Four markers, no two distances alike, that are seen from everywhere.
TrackedTool stylus()
{
    Probe probe{.markers = {{.p_OQ = {0.0, 0.0, 0.0}},
                            {.p_OQ = {0.050, 0.004, 0.0}},
                            {.p_OQ = {-0.008, 0.080, 0.010}},
                            {.p_OQ = {-0.040, -0.045, -0.012}}}};
    return {.name = "Stylus",
            .role = ToolRole::Stylus,
            .probe = std::move(probe),
            .noise = {metres(kFle), 1.0}};
}

MarkerSet setOf(const std::vector<std::size_t>& markers)
{
    MarkerSet set;
    for (const std::size_t i : markers)
        set.set(i);
    return set;
}

/// RMS error at a point of a pose from these markers (Fitzpatrick, West and Maurer 1998):
///
///     TRE^2 = FLE^2 / N (1 + 1/3 sum_k d_k^2 / f_k^2)
///
/// with the distances d_k of the point from the markers' principal axes, and f_k those of the
/// markers (RMS).
double publishedError(const Probe& probe, const std::vector<std::size_t>& markers, const Vec3& p_OQ)
{
    const auto count = double(markers.size());
    Vec3 mean = Vec3::Zero();
    for (const std::size_t i : markers)
        mean += probe.markers[i].p_OQ / count;
    Mat3 scatter = Mat3::Zero();
    for (const std::size_t i : markers) {
        const Vec3 off = probe.markers[i].p_OQ - mean;
        scatter += off * off.transpose();
    }
    const Mat3 axes = Eigen::SelfAdjointEigenSolver<Mat3>{scatter}.eigenvectors();
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
        double f2 = 0.0;
        for (const std::size_t i : markers)
            f2 += axes.col(k).cross(probe.markers[i].p_OQ - mean).squaredNorm() / count;
        sum += axes.col(k).cross(p_OQ - mean).squaredNorm() / f2;
    }
    return kFle * std::sqrt((1.0 + sum / 3.0) / count);
}

} // namespace

class TestToolError : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isThatOfTheMarkersThatAreSeen()
    {
        const TrackedTool tool = stylus();
        for (const Vec3& p_OQ : kTips) {
            PoseSample pose = kSeen;
            pose.markers = setOf({0, 1, 2, 3});
            const double all = predictedError(tool, pose)->at(p_OQ).si;
            QVERIFY(std::abs(all / publishedError(*tool.probe, {0, 1, 2, 3}, p_OQ) - 1.0) < kAgree);
            pose.validity = Validity::PartlyOccluded;
            for (std::size_t hidden = 0; hidden < 4; ++hidden) {
                std::vector<std::size_t> three{0, 1, 2, 3};
                std::erase(three, hidden);
                pose.markers = setOf(three);
                const auto error = predictedError(tool, pose);
                QCOMPARE(error->markers, std::size_t{3});
                QVERIFY(error->at(p_OQ).si > all);
                const double published = publishedError(*tool.probe, three, p_OQ);
                QVERIFY(std::abs(error->at(p_OQ).si / published - 1.0) < kAgree);
            }
        }
    }

    void isThatOfAllWhereTheTrackerTellsNone()
    {
        const TrackedTool tool = stylus();
        const double published = publishedError(*tool.probe, {0, 1, 2, 3}, kTips[0]);
        QVERIFY(std::abs(predictedError(tool, kSeen)->at(kTips[0]).si / published - 1.0) < kAgree);
    }

    /// It would be told too small.
    void isNotToldOfAToolThatIsHiddenNobodyKnowsWhere()
    {
        PoseSample pose = kSeen;
        pose.validity = Validity::PartlyOccluded;
        QVERIFY(!predictedError(stylus(), pose));
    }

    void isNotToldOfAToolThatIsNotSeen()
    {
        PoseSample pose = kSeen;
        pose.markers = setOf({0, 1}); // too few
        QVERIFY(!predictedError(stylus(), pose));
        pose.markers = setOf({0, 1, 2, 3});
        pose.validity = Validity::Lost;
        QVERIFY(!predictedError(stylus(), pose));
    }

    /// As a camera does, also of a tool that it sees badly.
    void isTheCovarianceThatCameWithThePose()
    {
        const Vec6 variances{1e-6, 1e-6, 1e-6, 0.09e-6, 0.09e-6, 0.09e-6};
        PoseSample pose = kSeen;
        TrackedTool tool = stylus();
        tool.probe.reset();
        QVERIFY(!predictedError(tool, pose));
        pose.covariance_O = Mat6{variances.asDiagonal()};
        for (const Validity validity : {Validity::Tracked, Validity::PartlyOccluded}) {
            pose.validity = validity;
            // 1 mrad about the two axes across an arm of 100 mm
            const double at = predictedError(tool, pose)->at({0.0, 0.0, 0.1}).si;
            QVERIFY(std::abs(at - std::sqrt(3.0 * 0.09e-6 + 2.0 * 0.01e-6)) < 1e-12);
        }
        pose.validity = Validity::Lost;
        QVERIFY(!predictedError(tool, pose));
    }
};

CARINA_TEST(TestToolError)

} // namespace carina::tool_error_test

#include "tst_tool_error.moc"
