#include "engine/geometry/rotation.h"
#include "engine/session/simulated_station.h"
#include "engine/session/station_tracking.h"
#include "engine/tracking/simulated/simulated_tracker.h"
#include "tests/engine/tracking/airway_walk.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::body_probe_test
{
namespace
{

constexpr double kRate = 60.0; // Hz
constexpr int kSamples = 60 * 15;
constexpr double kRounding = 1e-9; // m, and as a coefficient of a rotation

const RigidTransform kX_AB = RigidTransform::translation({-0.12, -0.06, 0.05});
const RigidTransform kX_AJ = RigidTransform::translation({0.0, -0.10, 0.13});
const RigidTransform kX_AE{rotationFromVector({0.2, 0.1, 0.0}), {0.01, -0.1, 0.2}};

SessionTime at(double seconds) { return SessionTime{fromSeconds(seconds)}; }

/// Where the anatomy, the jaw in it, and the tracker in the room are.
struct Scene {
    using Motion = std::function<RigidTransform(double)>;

    Motion X_TA = [](double) { return RigidTransform::translation({0.0, 0.0, -1.2}); };
    Motion X_AJ = [](double) { return kX_AJ; };

    [[nodiscard]] std::optional<RigidTransform> operator()(ToolRole tool, SessionTime time) const
    {
        const double t = toSeconds(time.time_since_epoch());
        switch (tool) {
        case ToolRole::Manikin:
            return X_TA(t) * kX_AB;
        case ToolRole::Jaw:
            return X_TA(t) * X_AJ(t);
        case ToolRole::Tube:
            return X_TA(t) * kX_AE;
        case ToolRole::Head:
        case ToolRole::Stylus:
        case ToolRole::Chest:
        case ToolRole::Hand:
        case ToolRole::Other:
            break;
        }
        return std::nullopt;
    }
};

/// The manikin is pushed and turned on its table.
RigidTransform pushed(double t)
{
    return {rotationFromVector({0.1 * std::sin(t), 0.0, 0.4 * std::sin(0.7 * t)}),
            Vec3{0.06 * std::sin(1.3 * t), 0.03 * t / 15.0, -1.2}};
}

/// Somebody bumps into the tracker after seven seconds.
RigidTransform seenByABumpedTracker(double t)
{
    const RigidTransform X_TA = RigidTransform::translation({0.0, 0.0, -1.2});
    const RigidTransform X_bumped{rotationFromVector({0.02, -0.05, 0.03}), {0.02, 0.01, -0.01}};
    return t < 7.0 ? X_TA : X_bumped * X_TA;
}

RigidTransform opening(double t)
{
    const Quat turn = rotationFromVector({0.35 * (1.0 - std::cos(t)) / 2.0, 0.0, 0.0});
    return {turn * kX_AJ.rotation(),
            kX_AJ.translation() + Vec3{0.0, 0.0, -0.01 * (1 - std::cos(t))}};
}

StationRegistration registration(bool withBody)
{
    StationRegistration exactly{.X_AT = RigidTransform::translation({0.0, 0.0, -1.2}).inverse(),
                                .X_JA = kX_AJ.inverse()};
    if (withBody)
        exactly.X_BA = kX_AB.inverse();
    return exactly;
}

SimulatedTrackerSettings device(bool bodyProbe)
{
    SimulatedTrackerSettings settings;
    settings.latency = Duration::zero();
    settings.volume = {.height = metres(10.0), .baseRadius = metres(10.0)};
    settings.bodyProbe = bodyProbe;
    return settings;
}

SimulatedTrackerSettings exactDevice()
{
    SimulatedTrackerSettings settings = device(true);
    settings.noise = {};
    settings.noise.rms = metres(0.0);
    return settings;
}

/// A station in virtual time.
class Watched
{
public:
    Watched(const SimulatedTrackerSettings& settings, Scene scene, bool withBody = true)
    {
        auto tracker = std::make_unique<SimulatedTracker>(
            settings, std::move(scene), [] { return std::optional<SessionTime>{}; });
        m_tracker = tracker.get();
        m_station = std::make_unique<StationTracking>(std::move(tracker), registration(withBody));
        m_tracker->advance(at(0.0));
    }

    [[nodiscard]] StationTracking& station() { return *m_station; }

    /// The next tick's pose of a tool.
    PoseSample next(ToolRole role)
    {
        m_tracker->advance(at((++m_ticks + 0.5) / kRate));
        return *m_station->newest(role);
    }

    /// RMS distance of the tube's origin from where it is in the anatomy, metres.
    double overlayError()
    {
        double squares = 0.0;
        for (int i = 0; i < kSamples; ++i)
            squares +=
                (next(ToolRole::Tube).X_FO.translation() - kX_AE.translation()).squaredNorm();
        return std::sqrt(squares / kSamples);
    }

private:
    SimulatedTracker* m_tracker = nullptr; ///< owned by the station
    std::unique_ptr<StationTracking> m_station;
    int m_ticks = 0;
};

/// Mean square error of a point by the pose of a simulated probe, m^2.
double errorOf(ToolRole role, const RigidTransform& X_TO, const Vec3& p_OQ)
{
    const Vec3 d_O = X_TO.rotation().conjugate() * -X_TO.translation().normalized();
    return std::pow(
        poseError(simulatedProbe(role), d_O, SimulatedTrackerSettings{}.noise)->at(p_OQ).si, 2);
}

/// From the noise of the markers of the tube's probe and of the body probe, at the tube.
double expectedError(const Scene& scene)
{
    double squares = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        const SessionTime t = at((i + 1) / kRate);
        squares += errorOf(ToolRole::Tube, *scene(ToolRole::Tube, t), Vec3::Zero())
                   + errorOf(ToolRole::Manikin, *scene(ToolRole::Manikin, t),
                             (kX_AB.inverse() * kX_AE).translation());
    }
    return std::sqrt(squares / kSamples);
}

constexpr double kOfNoise = 0.1; // share by which an RMS of so many samples may differ

} // namespace

class TestBodyProbe : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void overlayStaysWithinNoise_data()
    {
        QTest::addColumn<bool>("isPushed");
        QTest::newRow("manikin pushed about") << true;
        QTest::newRow("tracker bumped into") << false;
    }

    void overlayStaysWithinNoise()
    {
        QFETCH(bool, isPushed);
        Scene scene;
        scene.X_TA = isPushed ? pushed : seenByABumpedTracker;
        Watched watched{device(true), scene};
        QVERIFY(watched.station().hasBodyProbe());
        QVERIFY(watched.station().motionAssumption() == MotionAssumption::BodyProbe);
        const double error = watched.overlayError();
        QVERIFY2(std::abs(error / expectedError(scene) - 1.0) < kOfNoise,
                 qPrintable(QStringLiteral("%1 mm, %2 expected")
                                .arg(1e3 * error)
                                .arg(1e3 * expectedError(scene))));

        Watched without{device(false), scene, false};
        QVERIFY(without.station().motionAssumption() == MotionAssumption::ChinMovesJaw);
        QVERIFY(without.overlayError() > 0.02);
    }

    /// The torso moves and the mouth opens: the mandible is told as it moves in the anatomy.
    void chinMovesTheJawOnly()
    {
        Scene scene;
        scene.X_TA = pushed;
        scene.X_AJ = opening;
        Watched watched{exactDevice(), scene};
        double opened = 0.0;
        for (int i = 0; i < kSamples; ++i) {
            const PoseSample jaw = watched.next(ToolRole::Jaw);
            const RigidTransform X_AJ = opening(toSeconds(jaw.time.time_since_epoch()));
            const RigidTransform expected = X_AJ * kX_AJ.inverse();
            QVERIFY(jaw.X_FO.matrix().isApprox(expected.matrix(), kRounding));
            const auto tube = watched.station().at(ToolRole::Tube, jaw.time);
            QVERIFY(tube->X_FO.matrix().isApprox(kX_AE.matrix(), kRounding));
            opened = std::max(opened, angleBetween(jaw.X_FO.rotation(), Quat::Identity()).si);
        }
        QVERIFY(opened > 0.3);
    }

    void leavesNothingToAssume()
    {
        Watched watched{exactDevice(), {}};
        StationTracking& station = watched.station();
        QVERIFY(station.hasChinProbe());
        QVERIFY(!station.takeChinMotion(ChinMotion::OfManikin));
        QVERIFY(station.chinMotion() == ChinMotion::OfJaw);
    }

    void needsProbeAndRegistration()
    {
        Watched noProbe{device(false), {}, true};
        QVERIFY(!noProbe.station().hasBodyProbe());
        QVERIFY(noProbe.station().motionAssumption() == MotionAssumption::ChinMovesJaw);
        Watched notRegistered{exactDevice(), {}, false};
        QVERIFY(!notRegistered.station().hasBodyProbe());
        QVERIFY(notRegistered.station().takeChinMotion(ChinMotion::OfManikin));
        QVERIFY(notRegistered.station().motionAssumption() == MotionAssumption::ChinMovesManikin);
        const StationTracking nothing{
            std::make_unique<SimulatedTracker>(device(true), Scene{},
                                               [] { return std::optional<SessionTime>{}; }),
            {.X_AT = RigidTransform{}}};
        QVERIFY(nothing.motionAssumption() == MotionAssumption::Static);
    }

    /// A simulated manikin wears what it was registered with.
    void isThereInASimulatedStation()
    {
        const HandScript script = test::scriptOfWalk();
        AirwayLandmarks airway;
        airway.p_A_incisors = script.p_A_incisors;
        airway.path_A = script.path_A;
        TubeShape tube;
        tube.p_E_centre = script.p_E_centre;
        tube.tipAboveCarina = script.restAboveCarina;
        const auto noClock = [] { return std::optional<SessionTime>{}; };
        const auto without = simulatedStation(airway, tube, noClock);
        QVERIFY(without && !without->tracking->hasBodyProbe());
        StationRegistration fitted = without->exactly;
        fitted.X_BA = simulatedBodyProbe().inverse();
        const auto with = simulatedStation(airway, tube, noClock, fitted);
        QVERIFY(with && with->tracking->hasBodyProbe());
        const auto X_TB = with->truth(ToolRole::Manikin, at(3.0));
        QVERIFY(X_TB && (with->X_TA * simulatedBodyProbe()).matrix().isApprox(X_TB->matrix()));
        QVERIFY(WorkingVolume{}.contains(X_TB->translation()));
    }

    void losesEverythingWithTheBodyProbe()
    {
        SimulatedTrackerSettings settings = exactDevice();
        settings.occlusions = {{ToolRole::Manikin, at(1.0), at(2.0)}};
        Watched watched{settings, {}};
        for (int i = 0; i < 150; ++i) {
            const PoseSample tube = watched.next(ToolRole::Tube);
            const bool hidden = tube.time >= at(1.0) && tube.time < at(2.0);
            QVERIFY((tube.validity == Validity::Lost) == hidden);
        }
    }
};

CARINA_TEST(TestBodyProbe)

} // namespace carina::body_probe_test

#include "tst_body_probe.moc"
