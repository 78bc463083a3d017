#include "engine/registration/probe_pair_watch.h"

#include "engine/geometry/rotation.h"
#include "tests/engine/registration/registration_trials.h"

#include <QTest>

#include <cmath>

namespace carina
{
namespace
{

constexpr double kRate = 60.0; // Hz
constexpr double kNoise = 0.35e-3;
constexpr double kTurnNoise = 8e-4; // rad, along each axis

const RigidTransform kRegistered{rotationFromVector({0.3, -0.2, 0.9}), {0.02, -0.1, 0.25}};

SessionTime at(double seconds) { return SessionTime{fromSeconds(seconds)}; }

/// Where the chin probe is after it was turned about its own origin and shifted, told in B.
RigidTransform slipped(const Vec3& turn_B, const Vec3& shift_B)
{
    return {rotationFromVector(turn_B) * kRegistered.rotation(),
            kRegistered.translation() + shift_B};
}

/// Seconds of a tracker that sees both probes.
struct Watched {
    ProbePairWatch watch{kRegistered, {}};
    test::Hand hand{457};
    int samples = 0;

    void see(double seconds, const RigidTransform& X_BJ, Validity validity = Validity::Tracked)
    {
        for (int i = 0; i < int(std::lround(seconds * kRate)); ++i, ++samples)
            watch.push(at(samples / kRate),
                       {rotationFromVector(kTurnNoise * hand.unit()) * X_BJ.rotation(),
                        X_BJ.translation() + kNoise * hand.unit()},
                       validity);
    }
};

} // namespace

class TestProbePairWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysNothingBeforeItSawASecond()
    {
        Watched pair;
        pair.see(0.9, kRegistered);
        QVERIFY(pair.watch.report().state == WatchState::Unchecked);
        pair.see(0.2, kRegistered);
        QVERIFY(pair.watch.report().state == WatchState::Good);
    }

    void holdsWhileProbesSitWhereTheySat()
    {
        Watched pair;
        for (int second = 0; second < 600; ++second) {
            pair.see(1.0, kRegistered);
            QVERIFY(pair.watch.report().state != WatchState::Drifted);
        }
        QVERIFY(pair.watch.report().shift_B.norm() < 0.3e-3);
    }

    /// A mouth comes back to within the sigmas: falsely called in no more than the limit.
    void allowsForHowAMouthCloses()
    {
        const ProbePairWatch::Settings settings;
        test::Hand hand{461};
        constexpr int kClosings = 20'000;
        int drifted = 0;
        for (int i = 0; i < kClosings; ++i) {
            ProbePairWatch watch{kRegistered, settings};
            const RigidTransform X_BJ =
                slipped(settings.turn.si * hand.unit(), settings.shift.si * hand.unit());
            watch.push(at(0.0), X_BJ, Validity::Tracked);
            watch.push(at(0.2), X_BJ, Validity::Tracked);
            for (const double t : {0.4, 0.6, 0.8, 1.0})
                watch.push(at(t), X_BJ, Validity::Tracked);
            drifted += watch.report().state == WatchState::Drifted ? 1 : 0;
        }
        QVERIFY2(drifted <= 6, qPrintable(QString::number(drifted))); // one is expected
    }

    void noticesAProbeThatSlipped_data()
    {
        QTest::addColumn<Vec3>("turn_deg");
        QTest::addColumn<Vec3>("shift_mm");
        QTest::newRow("shifted") << Vec3{0.0, 0.0, 0.0} << Vec3{3.0, -3.0, 2.0};
        QTest::newRow("turned") << Vec3{0.0, 3.5, 0.0} << Vec3{0.0, 0.0, 0.0};
        QTest::newRow("both") << Vec3{2.0, 0.0, -1.0} << Vec3{0.0, 2.5, 1.0};
    }

    void noticesAProbeThatSlipped()
    {
        QFETCH(Vec3, turn_deg);
        QFETCH(Vec3, shift_mm);
        const Vec3 turn_B = degrees(1.0).si * turn_deg;
        const Vec3 shift_B = 1e-3 * shift_mm;
        Watched pair;
        pair.see(5.0, kRegistered);
        const SessionTime slip = at(pair.samples / kRate);
        pair.see(4.0, slipped(turn_B, shift_B));
        const ProbePairReport& report = pair.watch.report();
        QVERIFY(report.state == WatchState::Drifted);
        QVERIFY(report.chance < 5e-5);
        constexpr double kMean = 0.2e-3; // m and rad, of the noise
        QVERIFY((report.shift_B - shift_B).norm() < kMean);
        QVERIFY(std::abs(report.turn.si - turn_B.norm()) < kMean);
        QVERIFY(std::chrono::abs(*report.since - slip) < std::chrono::milliseconds{1100});
        pair.see(2.5, kRegistered); // put back
        QVERIFY(pair.watch.report().state == WatchState::Good);
        QVERIFY(!pair.watch.report().since);
    }

    void mindsOnlyWhatIsSeenWhileTheMouthIsShut()
    {
        const RigidTransform open = slipped({0.35, 0.0, 0.0}, {0.0, 0.01, -0.02});
        Watched pair;
        pair.see(3.0, open, Validity::Lost);
        QVERIFY(pair.watch.report().state == WatchState::Unchecked);
        pair.see(0.9, open);
        pair.watch.opened();
        pair.see(0.9, kRegistered);
        QVERIFY(pair.watch.report().state == WatchState::Unchecked);
        pair.watch.push(at(pair.samples / kRate + 0.3), kRegistered, Validity::Tracked); // a gap
        QVERIFY(pair.watch.report().state == WatchState::Unchecked);
        pair.watch.push(at(0.0), open, Validity::Tracked); // older
        QVERIFY(pair.watch.report().state == WatchState::Unchecked);
    }
};

} // namespace carina

QTEST_GUILESS_MAIN(carina::TestProbePairWatch)
#include "tst_probe_pair_watch.moc"
