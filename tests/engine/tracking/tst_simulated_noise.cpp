#include "engine/geometry/rotation.h"
#include "engine/tracking/simulated_tracker.h"
#include "tests/support/test_class.h"

#include <Eigen/Geometry>

#include <random>

namespace carina::simulated_noise_test
{
namespace
{

constexpr int kSamples = 6000;
// A standard deviation estimated from 6000 draws is itself good to 0.9 % (1 sigma).
constexpr double kShare = 0.04;
constexpr double kLargestCorrelation = 0.05; // of independent draws: 0.013 (1 sigma)

const RigidTransform kX_TO{rotationFromVector({0.4, -0.3, 1.2}), Vec3{0.15, -0.25, -1.2}};

bool close(double value, double expected) { return std::abs(value / expected - 1.0) < kShare; }

struct Noise {
    std::vector<Vec3> position_T;
    std::vector<Vec3> turn_T;
    std::vector<double> fitError;
};

/// What the tracker adds to a tool at rest.
Noise measure(const SimulatedTrackerSettings& settings)
{
    SimulatedTracker tracker{settings, [](ToolRole, SessionTime) { return kX_TO; },
                             [] { return std::optional<SessionTime>{}; }};
    const PoseHistory& history = *tracker.tools().front().history;
    Noise noise;
    SessionTime now{};
    for (int i = 0; i < kSamples; ++i) {
        now = tracker.advance(now);
        const PoseSample sample = history.newest().value();
        noise.position_T.push_back(sample.X_FO.translation() - kX_TO.translation());
        noise.turn_T.push_back(
            rotationVector(sample.X_FO.rotation() * kX_TO.rotation().conjugate()));
        noise.fitError.push_back(sample.error);
    }
    return noise;
}

Noise measureAtOnce()
{
    SimulatedTrackerSettings settings;
    settings.latency = Duration::zero();
    return measure(settings);
}

double rms(const std::vector<Vec3>& vectors)
{
    double sum = 0.0;
    for (const Vec3& v : vectors)
        sum += v.squaredNorm();
    return std::sqrt(sum / static_cast<double>(vectors.size()));
}

double rmsAlong(const std::vector<Vec3>& vectors, const Vec3& direction)
{
    double sum = 0.0;
    for (const Vec3& v : vectors)
        sum += v.dot(direction) * v.dot(direction);
    return std::sqrt(sum / static_cast<double>(vectors.size()));
}

/// RMS fit error of a tool of four markers over the RMS error of the markers' mean: both from
/// least-squares fits (Eigen::umeyama) to markers with independent noise.
double fitErrorOverMeanError()
{
    constexpr int kTools = 20000;
    Eigen::Matrix<double, 3, 4> p_O; // a flat tool, as probes are, metres
    p_O << 0.0, 0.05, 0.0, -0.06, 0.04, 0.0, -0.05, 0.0, 0.0, 0.0, 0.0, 0.0;
    std::mt19937 random{7};
    std::normal_distribution<double> noise{0.0, 1e-4};
    double residuals = 0.0;
    double means = 0.0;
    for (int i = 0; i < kTools; ++i) {
        const Eigen::Matrix<double, 3, 4> e_T =
            Eigen::Matrix<double, 3, 4>::NullaryExpr([&] { return noise(random); });
        const Eigen::Matrix<double, 3, 4> p_T = p_O + e_T;
        const Eigen::Matrix4d X_TO = Eigen::umeyama(p_O, p_T, false);
        residuals += (p_T - (X_TO * p_O.colwise().homogeneous()).topRows<3>()).squaredNorm() / 4.0;
        means += e_T.rowwise().mean().squaredNorm();
    }
    return std::sqrt(residuals / means);
}

} // namespace

/// The noise of the simulated tracker against the figures it is said to have.
class SimulatedNoiseTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void has035MillimetresRmsInThreeDimensions()
    {
        QVERIFY(close(rms(measureAtOnce().position_T), 0.35e-3));
    }

    void isThreeTimesAsLargeInDepthAsAcross()
    {
        const std::vector<Vec3> noise = measureAtOnce().position_T;
        const Vec3 sight = kX_TO.translation().normalized();
        const Vec3 across = sight.unitOrthogonal();
        const double depth = rmsAlong(noise, sight);
        QVERIFY(close(depth / rmsAlong(noise, across), 3.0));
        QVERIFY(close(depth / rmsAlong(noise, sight.cross(across)), 3.0));
    }

    void hasNoBias()
    {
        const std::vector<Vec3> noise = measureAtOnce().position_T;
        Vec3 sum = Vec3::Zero();
        for (const Vec3& v : noise)
            sum += v;
        constexpr double kBias = 0.02e-3; // m; four standard errors of the mean in depth
        QVERIFY((sum / kSamples).norm() < kBias);
    }

    void turnsTheToolByTheGivenAngleRms()
    {
        const std::vector<Vec3> turns = measureAtOnce().turn_T;
        QVERIFY(close(rms(turns), degrees(0.05).si));
        for (const Vec3& axis : {Vec3{Vec3::UnitX()}, Vec3{Vec3::UnitY()}, Vec3{Vec3::UnitZ()}})
            QVERIFY(close(rmsAlong(turns, axis), degrees(0.05).si / std::sqrt(3.0)));
    }

    void givesAFitErrorOfFourMarkersThatIsIndependentOfTheError()
    {
        const Noise noise = measureAtOnce();
        double sum = 0.0;
        double square = 0.0;
        double error = 0.0;
        double errorSquare = 0.0;
        double product = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const double fit = noise.fitError[static_cast<std::size_t>(i)];
            const double off = noise.position_T[static_cast<std::size_t>(i)].norm();
            sum += fit;
            square += fit * fit;
            error += off;
            errorSquare += off * off;
            product += fit * off;
        }
        QVERIFY(close(std::sqrt(square / kSamples), 0.35e-3 * fitErrorOverMeanError()));
        const double covariance = product * kSamples - sum * error;
        const double spread =
            std::sqrt((square * kSamples - sum * sum) * (errorSquare * kSamples - error * error));
        QVERIFY(std::abs(covariance / spread) < kLargestCorrelation);
    }

    void followsItsSettings()
    {
        SimulatedTrackerSettings settings;
        settings.latency = Duration::zero();
        settings.positionNoise = millimetres(2.0);
        settings.depthRatio = 1.0;
        settings.rotationNoise = degrees(1.0);
        const Noise noise = measure(settings);
        QVERIFY(close(rms(noise.position_T), 2e-3));
        const Vec3 sight = kX_TO.translation().normalized();
        QVERIFY(close(rmsAlong(noise.position_T, sight), 2e-3 / std::sqrt(3.0)));
        QVERIFY(close(rms(noise.turn_T), degrees(1.0).si));
    }
};

CARINA_TEST(SimulatedNoiseTest)

} // namespace carina::simulated_noise_test

#include "tst_simulated_noise.moc"
