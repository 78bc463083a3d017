#include "engine/session/station_tracking.h"

#include "engine/geometry/rotation.h"
#include "engine/tracking/reframed.h"
#include "tests/support/test_class.h"

namespace carina::station_tracking_test
{
namespace
{

constexpr double kTolerance_m = 1e-12;
constexpr double kTolerance_rad = 1e-12;

SessionTime at(double seconds) { return SessionTime{fromSeconds(seconds)}; }

const StationRegistration kRegistration{
    .X_AT = {rotationFromVector(Vec3{0.4, -1.1, 0.7}), Vec3{-0.2, 0.5, 1.0}},
    .X_JA = RigidTransform{rotationFromVector(Vec3{-0.3, 0.2, 0.1}), Vec3{0.02, 0.07, -0.04}}};

bool same(const RigidTransform& a, const RigidTransform& b)
{
    return (a.translation() - b.translation()).norm() < kTolerance_m
           && angleBetween(a.rotation(), b.rotation()).si < kTolerance_rad;
}

} // namespace

/// A screw motion with known velocities: turns about z of T through the point c_T while it moves
/// along z.
struct Screw {
    static constexpr double kTurn = 0.8;   ///< rad/s
    static constexpr double kClimb = 0.05; ///< m/s
    Vec3 c_T{0.1, 0.2, 0.0};

    [[nodiscard]] RigidTransform X_TO(double t) const
    {
        const Quat turn = rotationFromVector(Vec3{0.0, 0.0, kTurn * t});
        const Vec3 arm{0.3, 0.0, 0.0};
        return {turn, c_T + turn * arm + Vec3{0.0, 0.0, kClimb * t}};
    }
    [[nodiscard]] Motion motion(double t) const
    {
        const Vec3 w{0.0, 0.0, kTurn};
        return {.v_FO = w.cross(X_TO(t).translation() - c_T) + Vec3{0.0, 0.0, kClimb}, .w_FO = w};
    }
    [[nodiscard]] PoseSample sample(double t) const
    {
        PoseSample sample;
        sample.time = at(t);
        sample.X_FO = X_TO(t);
        sample.motion = motion(t);
        return sample;
    }
};

/// A tracker whose samples a test pushes itself.
class HandFedTracker final : public Tracker
{
public:
    explicit HandFedTracker(bool& runs) : m_runs{runs} {}
    ~HandFedTracker() override { m_runs = false; } // as every tracker stops with its end

    Result<void> start() override
    {
        m_runs = true;
        return {};
    }
    void stop() override { m_runs = false; }
    std::vector<TrackedTool> tools() const override
    {
        return {{"tube", ToolRole::Tube, &tube}, {"jaw", ToolRole::Jaw, &jaw}};
    }

    mutable PoseHistory tube;
    mutable PoseHistory jaw;

private:
    bool& m_runs;
};

class TestStationTracking : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        auto tracker = std::make_unique<HandFedTracker>(m_runs);
        m_tracker = tracker.get();
        m_station = std::make_unique<StationTracking>(std::move(tracker), kRegistration);
    }

    void tellsATubeInTheAnatomy()
    {
        m_tracker->tube.push(m_screw.sample(0.5));
        const auto told = m_station->at(ToolRole::Tube, at(0.5));
        QVERIFY(told.has_value());
        QVERIFY(same(told->X_FO, kRegistration.X_AT * m_screw.X_TO(0.5)));
        QVERIFY(told->validity == Validity::Tracked);
        QVERIFY(told->time == at(0.5));
    }

    /// What others are sent and what is measured stays as the tracker said it.
    void smoothsAndHoldsOnlyWhatIsDrawn()
    {
        m_tracker->tube.treat({.predicts = false, .smooths = true});
        m_tracker->tube.push(m_screw.sample(0.5));
        m_tracker->tube.push(m_screw.sample(0.52));
        const RigidTransform X_AE = kRegistration.X_AT * m_screw.X_TO(0.52);
        const auto held = m_station->shownAt(ToolRole::Tube, at(0.56));
        QVERIFY(!same(held->X_FO, X_AE));
        QVERIFY(same(held->X_FO, m_station->shownAt(ToolRole::Tube, at(0.52))->X_FO));
        QVERIFY(same(m_station->newest(ToolRole::Tube)->X_FO, X_AE));
        QVERIFY(same(m_station->at(ToolRole::Tube, at(0.52))->X_FO, X_AE));
        QVERIFY(!same(m_station->at(ToolRole::Tube, at(0.56))->X_FO, X_AE));
    }

    /// The connector where it is calibrated to be on the markers; its tip moves as a part of both.
    void tellsTheConnectorOfACalibratedTube()
    {
        StationRegistration calibrated = kRegistration;
        calibrated.X_NE = RigidTransform{rotationFromVector({0.3, 0.1, -0.2}), {0.01, -0.05, 0.02}};
        m_station->takeRegistration(calibrated);
        m_tracker->tube.push(m_screw.sample(0.5));
        const auto told = m_station->at(ToolRole::Tube, at(0.5));
        QVERIFY(told.has_value());
        QVERIFY(same(told->X_FO, calibrated.X_AT * m_screw.X_TO(0.5) * *calibrated.X_NE));
        m_station->takeRegistration(kRegistration);
        QVERIFY(same(m_station->at(ToolRole::Tube, at(0.5))->X_FO,
                     kRegistration.X_AT * m_screw.X_TO(0.5)));
    }

    void tellsTheMandibleWithTheMouthClosedAtTheAnatomy()
    {
        // The chin probe stands where it stood when the mouth was closed: X_TJ = X_TA X_AJ.
        PoseSample closed = m_screw.sample(0.0);
        closed.X_FO = kRegistration.X_AT.inverse() * kRegistration.X_JA->inverse();
        m_tracker->jaw.push(closed);
        const auto told = m_station->at(ToolRole::Jaw, at(0.0));
        QVERIFY(told.has_value());
        QVERIFY(same(told->X_FO, RigidTransform{}));
    }

    void velocitiesAreThoseOfTheFramesTold_data()
    {
        QTest::addColumn<ToolRole>("role");
        QTest::newRow("tube, its own frame") << ToolRole::Tube;
        QTest::newRow("jaw, the mandible's frame") << ToolRole::Jaw;
    }

    void velocitiesAreThoseOfTheFramesTold()
    {
        QFETCH(ToolRole, role);
        PoseHistory& history = role == ToolRole::Tube ? m_tracker->tube : m_tracker->jaw;
        constexpr double kStep = 1e-4;
        for (const double t : {1.0 - kStep, 1.0, 1.0 + kStep})
            history.push(m_screw.sample(t));
        const auto before = m_station->at(role, at(1.0 - kStep));
        const auto now = m_station->at(role, at(1.0));
        const auto after = m_station->at(role, at(1.0 + kStep));
        QVERIFY(before && now && after && now->motion);
        // Central differences of the poses told; their error is that of the third derivative.
        const Vec3 v_A = (after->X_FO.translation() - before->X_FO.translation()) / (2.0 * kStep);
        const Vec3 w_A =
            rotationVector(after->X_FO.rotation() * before->X_FO.rotation().conjugate())
            / (2.0 * kStep);
        constexpr double kDifference = 1e-7; // m/s and rad/s
        QVERIFY((now->motion->v_FO - v_A).norm() < kDifference);
        QVERIFY((now->motion->w_FO - w_A).norm() < kDifference);
    }

    /// The manikin is carried about with its chin probe, the tube in it: nothing moves in A.
    void followsAManikinThatIsMoved()
    {
        QVERIFY(m_station->hasChinProbe());
        QVERIFY(m_station->chinMotion() == ChinMotion::OfJaw);
        QVERIFY(m_station->takeChinMotion(ChinMotion::OfManikin));
        QVERIFY(m_station->chinMotion() == ChinMotion::OfManikin);
        const RigidTransform X_AE{rotationFromVector({0.2, 0.1, 0.0}), {0.0, -0.1, 0.2}};
        const RigidTransform X_JE = *kRegistration.X_JA * X_AE;
        for (const double t : {0.0, 0.05, 0.1}) {
            const PoseSample X_TJ = m_screw.sample(t);
            m_tracker->jaw.push(X_TJ);
            m_tracker->tube.push(attached(X_TJ, X_JE));
            const auto tube = m_station->at(ToolRole::Tube, at(t));
            QVERIFY(tube && same(tube->X_FO, X_AE));
            QVERIFY(tube->motion->v_FO.norm() < kTolerance_m);
            QVERIFY(tube->motion->w_FO.norm() < kTolerance_rad);
            const auto jaw = m_station->at(ToolRole::Jaw, at(t));
            QVERIFY(jaw && same(jaw->X_FO, RigidTransform{})); // the mouth is closed
        }
    }

    void seesATubeMoveInAManikinThatIsMoved()
    {
        m_station->takeChinMotion(ChinMotion::OfManikin);
        constexpr double kStep = 1e-4;
        const Screw tube{.c_T = {-0.3, 0.4, 0.1}};
        for (const double t : {1.0 - kStep, 1.0, 1.0 + kStep}) {
            PoseSample turning = m_screw.sample(t);
            turning.X_FO = m_screw.X_TO(2.0 * t); // twice as fast as the tube
            turning.motion = Motion{.v_FO = 2.0 * m_screw.motion(2.0 * t).v_FO,
                                    .w_FO = 2.0 * m_screw.motion(2.0 * t).w_FO};
            m_tracker->jaw.push(turning);
            m_tracker->tube.push(tube.sample(t));
        }
        const auto told = [&](double t) { return *m_station->at(ToolRole::Tube, at(t)); };
        const RigidTransform before = told(1.0 - kStep).X_FO;
        const RigidTransform after = told(1.0 + kStep).X_FO;
        const Vec3 v_A = (after.translation() - before.translation()) / (2.0 * kStep);
        const Vec3 w_A =
            rotationVector(after.rotation() * before.rotation().conjugate()) / (2.0 * kStep);
        constexpr double kDifference = 1e-7; // m/s and rad/s
        QVERIFY((told(1.0).motion->v_FO - v_A).norm() < kDifference);
        QVERIFY((told(1.0).motion->w_FO - w_A).norm() < kDifference);
        QVERIFY(v_A.norm() > 0.1);
    }

    void leavesAManikinWhereItWasMovedTo()
    {
        m_station->takeChinMotion(ChinMotion::OfManikin);
        m_tracker->jaw.push(m_screw.sample(1.0));
        QVERIFY(m_station->takeChinMotion(ChinMotion::OfJaw));
        const RigidTransform X_TA = m_screw.X_TO(1.0) * *kRegistration.X_JA;
        m_tracker->tube.push(m_screw.sample(1.1));
        QVERIFY(
            same(m_station->at(ToolRole::Tube, at(1.1))->X_FO, X_TA.inverse() * m_screw.X_TO(1.1)));
        m_tracker->jaw.push(m_screw.sample(1.1)); // the mouth opens
        QVERIFY(same(m_station->at(ToolRole::Jaw, at(1.1))->X_FO,
                     X_TA.inverse() * m_screw.X_TO(1.1) * *kRegistration.X_JA));
        m_station->takeChinMotion(ChinMotion::OfJaw); // already so: nothing moves
        QVERIFY(
            same(m_station->at(ToolRole::Tube, at(1.1))->X_FO, X_TA.inverse() * m_screw.X_TO(1.1)));
    }

    void losesEverythingWithTheProbeThatCarriesTheManikin()
    {
        m_station->takeChinMotion(ChinMotion::OfManikin);
        m_tracker->tube.push(m_screw.sample(1.0));
        QVERIFY(!m_station->at(ToolRole::Tube, at(1.0)).has_value()); // never seen
        PoseSample hidden = m_screw.sample(1.0);
        hidden.validity = Validity::Lost;
        hidden.error = 3e-4;
        m_tracker->jaw.push(hidden);
        QVERIFY(m_station->at(ToolRole::Tube, at(1.0))->validity == Validity::Lost);
        PoseSample tube = m_screw.sample(1.0);
        tube.error = 4e-4;
        m_tracker->tube.push(tube);
        QVERIFY(std::abs(m_station->at(ToolRole::Tube, at(1.0))->error - 5e-4) < 1e-15);
    }

    void knowsNoJawWithoutAChinProbe()
    {
        auto tracker = std::make_unique<HandFedTracker>(m_runs);
        tracker->jaw.push(m_screw.sample(1.0));
        tracker->tube.push(m_screw.sample(1.0));
        StationTracking station{std::move(tracker), {.X_AT = kRegistration.X_AT}};
        QVERIFY(!station.hasChinProbe());
        QVERIFY(!station.takeChinMotion(ChinMotion::OfManikin));
        QVERIFY(station.chinMotion() == ChinMotion::OfJaw);
        QVERIFY(!station.at(ToolRole::Jaw, at(1.0)).has_value());
        QVERIFY(station.at(ToolRole::Tube, at(1.0)).has_value());
    }

    void newestIsTheLatestSampleWithItsMotion()
    {
        m_tracker->tube.push(m_screw.sample(1.0));
        m_tracker->tube.push(m_screw.sample(1.1));
        const auto newest = m_station->newest(ToolRole::Tube);
        QVERIFY(newest.has_value());
        QVERIFY(newest->time == at(1.1));
        QVERIFY(newest->motion.has_value());
    }

    void saysNothingOfToolsNeverSeenOrNotThere()
    {
        QVERIFY(!m_station->at(ToolRole::Tube, at(0.0)).has_value());
        QVERIFY(!m_station->newest(ToolRole::Tube).has_value());
        QVERIFY(!m_station->at(ToolRole::Stylus, at(0.0)).has_value());
        QVERIFY(!m_station->newest(ToolRole::Stylus).has_value());
    }

    void itsTrackerEndsWithIt()
    {
        QVERIFY(m_station->start().has_value());
        QVERIFY(m_runs);
        m_station.reset();
        QVERIFY(!m_runs);
    }

    void itsTrackerGoesOnForTheNextPatient()
    {
        QVERIFY(m_station->start().has_value());
        m_tracker->tube.push(m_screw.sample(0.5));
        StationRegistration another = kRegistration;
        another.X_AT = RigidTransform::translation({1.0, 0.0, 0.0});
        const StationTracking next{m_station->sharedTracker(), another};
        m_station.reset();
        QVERIFY(m_runs);
        const auto told = next.at(ToolRole::Tube, at(0.5));
        QVERIFY(told.has_value());
        QVERIFY(same(told->X_FO, another.X_AT * m_screw.X_TO(0.5)));
    }

private:
    bool m_runs = false;
    Screw m_screw;
    HandFedTracker* m_tracker = nullptr; ///< owned by the station
    std::unique_ptr<StationTracking> m_station;
};

CARINA_TEST(TestStationTracking)

} // namespace carina::station_tracking_test

#include "tst_station_tracking.moc"
