#include "engine/geometry/rotation.h"
#include "engine/tracking/simulated/simulated_tracker.h"
#include "tests/support/test_class.h"

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

/// To the tracker.
const Vec3 kD_O = kX_TO.rotation().conjugate() * -kX_TO.translation().normalized();

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

} // namespace

/// The noise of the simulated tracker against the figures it is said to have.
class SimulatedNoiseTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isWhatTheMarkersAreSaidToGive_data()
    {
        QTest::addColumn<double>("rms_mm");
        QTest::addColumn<double>("depthRatio");
        QTest::addColumn<double>("outward_mm");
        QTest::newRow("as usual") << 0.1 << 3.0 << 0.0;
        QTest::newRow("Polaris, anywhere") << 0.35 << 3.0 << 0.0;
        QTest::newRow("alike in all directions") << 2.0 << 1.0 << 0.0;
        QTest::newRow("with a constant part") << 0.1 << 3.0 << 0.3;
    }

    /// The prediction is held against other code in tst_probe.
    void isWhatTheMarkersAreSaidToGive()
    {
        QFETCH(double, rms_mm);
        QFETCH(double, depthRatio);
        QFETCH(double, outward_mm);
        SimulatedTrackerSettings settings;
        settings.latency = Duration::zero();
        settings.noise = {millimetres(rms_mm), depthRatio, millimetres(outward_mm)};
        const Noise noise = measure(settings);
        const auto expected = poseError(simulatedProbe(ToolRole::Head), kD_O, settings.noise);
        QVERIFY(close(rms(noise.position_T), expected->at(Vec3::Zero()).si));
        QVERIFY(close(rms(noise.turn_T), expected->rotation().si));
    }

    void hasNoBias()
    {
        Vec3 sum = Vec3::Zero();
        const Noise noise = measureAtOnce();
        for (const Vec3& v : noise.position_T)
            sum += v;
        constexpr double kErrors = 4.0; // standard errors of the mean
        QVERIFY((sum / kSamples).norm() < kErrors * rms(noise.position_T) / std::sqrt(kSamples));
    }

    void givesAFitErrorThatIsIndependentOfTheError()
    {
        // Only noise alike in all directions leaves the two independent.
        SimulatedTrackerSettings settings;
        settings.latency = Duration::zero();
        settings.noise.depthRatio = 1.0;
        const Noise noise = measure(settings);
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
        // FRE^2 = (1 - 2/N) FLE^2 (Sibson 1979)
        const auto markers = double(facingMarkers(simulatedProbe(ToolRole::Head), kD_O).size());
        const double fle = settings.noise.rms.si;
        QVERIFY(close(std::sqrt(square / kSamples), fle * std::sqrt(1.0 - 2.0 / markers)));
        const double covariance = product * kSamples - sum * error;
        const double spread =
            std::sqrt((square * kSamples - sum * sum) * (errorSquare * kSamples - error * error));
        QVERIFY(std::abs(covariance / spread) < kLargestCorrelation);
    }

    void isPartlyOccludedWhileSomeMarkersAreHidden_data()
    {
        QTest::addColumn<double>("share");
        QTest::addColumn<int>("validity");
        QTest::newRow("none") << 0.0 << int(Validity::Tracked);
        QTest::newRow("half") << 0.5 << int(Validity::PartlyOccluded);
        QTest::newRow("nearly all") << 0.9 << int(Validity::Lost);
        QTest::newRow("all") << 1.0 << int(Validity::Lost);
    }

    void isPartlyOccludedWhileSomeMarkersAreHidden()
    {
        QFETCH(double, share);
        QFETCH(int, validity);
        SimulatedTrackerSettings settings;
        settings.latency = Duration::zero();
        settings.rate = hertz(10.0);
        settings.occlusions = {{ToolRole::Head, SessionTime{std::chrono::milliseconds{500}},
                                SessionTime{std::chrono::seconds{2}}, share}};
        SimulatedTracker tracker{settings, [](ToolRole, SessionTime) { return kX_TO; },
                                 [] { return std::optional<SessionTime>{}; }};
        tracker.advance(SessionTime{});
        tracker.advance(SessionTime{std::chrono::seconds{1}});
        const PoseSample newest = tracker.tools().front().history->newest().value();
        QCOMPARE(int(newest.validity), validity);
        QCOMPARE(newest.markers.has_value(), newest.validity != Validity::Lost);
    }

    /// Half of those that face the tracker, the first ones, are hidden.
    void tellsTheMarkersThatItSees()
    {
        const auto facing = facingMarkers(simulatedProbe(ToolRole::Head), kD_O);
        const std::size_t hidden = (facing.size() + 1) / 2;
        MarkerSet all;
        MarkerSet half;
        for (std::size_t i = 0; i < facing.size(); ++i) {
            all.set(facing[i]);
            half.set(facing[i], i >= hidden);
        }
        for (const double share : {0.0, 0.5}) {
            SimulatedTrackerSettings settings;
            settings.latency = Duration::zero();
            settings.rate = hertz(10.0);
            settings.occlusions = {{ToolRole::Head, SessionTime{std::chrono::milliseconds{500}},
                                    SessionTime{std::chrono::seconds{2}}, share}};
            SimulatedTracker tracker{settings, [](ToolRole, SessionTime) { return kX_TO; },
                                     [] { return std::optional<SessionTime>{}; }};
            tracker.advance(SessionTime{});
            tracker.advance(SessionTime{std::chrono::seconds{1}});
            const auto seen = tracker.tools().front().history->newest()->markers;
            QVERIFY(seen == (share == 0.0 ? all : half));
        }
    }

    void seesEachProbeFromEverySide()
    {
        for (int role = 0; role <= int(ToolRole::Laryngoscope); ++role) {
            const ProbeSurvey survey =
                surveyProbe(simulatedProbe(ToolRole(role)), kPolarisNoise, Vec3::Zero());
            QCOMPARE(survey.posed, 1.0);
            QVERIFY(survey.rotation < degrees(1.0));
        }
    }
};

CARINA_TEST(SimulatedNoiseTest)

} // namespace carina::simulated_noise_test

#include "tst_simulated_noise.moc"
