#include "engine/registration/watch/registration_watch.h"

#include "engine/geometry/rotation.h"
#include "engine/registration/error/target_error.h"
#include "tests/engine/geometry/fit/registration_trials.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::registration_watch_test
{
namespace
{

constexpr int kRegistrations = 5000;
constexpr int kChecks = 20;
const Length kFle = millimetres(1.0);

SessionTime at(double seconds) { return SessionTime{fromSeconds(seconds)}; }

Vec3 stray(test::Hand& hand) { return kFle.si / std::sqrt(3.0) * hand.unit(); }

/// A registration by touches of these landmarks, with its error, and checks of it.
struct Session {
    Session(test::Hand& technician, const std::vector<Vec3>& landmarks, const Mat6& covariance)
        : hand{technician}, p_A{landmarks}, watch{landmarks, covariance, {.touch = kFle}}
    {
        std::vector<Vec3> touched;
        for (const Vec3& p : p_A)
            touched.push_back(p + stray(hand));
        X_AM = test::hornFit(p_A, touched);
    }

    /// Touches a landmark of a manikin that was moved since.
    void check(const RigidTransform& moved = {})
    {
        const std::size_t landmark = hand.random()() % p_A.size();
        const Vec3 p_A_tip = X_AM * (moved * p_A[landmark] + stray(hand));
        now += 1.0;
        watch.add({at(now), landmark, p_A_tip - p_A[landmark]});
    }

    test::Hand& hand;
    const std::vector<Vec3>& p_A;
    RigidTransform X_AM;
    RegistrationWatch watch;
    double now = 0.0;
};

RigidTransform turnedAboutZ(Angle angle)
{
    return {rotationFromVector({0.0, 0.0, angle.si}), Vec3::Zero()};
}

} // namespace

class TestRegistrationWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hardlyEverFalselyAlarms_data()
    {
        QTest::addColumn<int>("count");
        QTest::newRow("four landmarks") << 4;
        QTest::newRow("eight landmarks") << 8;
    }

    void hardlyEverFalselyAlarms()
    {
        QFETCH(int, count);
        test::Hand hand{401};
        const auto p_A = test::firstLandmarks(count);
        const Mat6 covariance = *fitCovariance(equalErrors(p_A, kFle));
        int alarms = 0;
        int below = 0; // chances of less than 5 %
        for (int i = 0; i < kRegistrations; ++i) {
            Session session{hand, p_A, covariance};
            bool alarmed = false;
            for (int k = 0; k < kChecks; ++k) {
                session.check();
                alarmed = alarmed || session.watch.report().state == WatchState::Drifted;
                below += k == 0 && session.watch.report().chance < 0.05 ? 1 : 0;
            }
            alarms += alarmed ? 1 : 0;
        }
        qInfo("%d of %d registrations with %d checks; first chance below 5 %%: %d", alarms,
              kRegistrations, kChecks, below);
        QVERIFY(alarms <= kRegistrations / 1000);
        QVERIFY(below <= 0.055 * kRegistrations);
    }

    void findsAShiftOfThreeMillimetres_data()
    {
        QTest::addColumn<int>("count");
        QTest::newRow("four landmarks") << 4;
        QTest::newRow("eight landmarks") << 8;
    }

    void findsAShiftOfThreeMillimetres()
    {
        QFETCH(int, count);
        test::Hand hand{409};
        const auto p_A = test::firstLandmarks(count);
        const Mat6 covariance = *fitCovariance(equalErrors(p_A, kFle));
        constexpr int kSessions = 1000;
        std::array<int, kChecks> found{}; // within so many checks
        double far = 0.0;
        for (int i = 0; i < kSessions; ++i) {
            Session session{hand, p_A, covariance};
            for (int k = 0; k < 10; ++k)
                session.check();
            const Vec3 shift = 3e-3 * hand.unit().normalized();
            bool alarmed = false;
            for (std::size_t k = 0; k < found.size(); ++k) {
                session.check(RigidTransform::translation(shift));
                alarmed = alarmed || session.watch.report().state == WatchState::Drifted;
                found[k] += alarmed ? 1 : 0;
                if (k == 7)
                    far += (session.watch.report().shift_A - shift).squaredNorm() / kSessions;
            }
        }
        for (std::size_t k = 0; k < 8; ++k)
            qInfo("found within %zu checks: %.1f %%", k + 1, 100.0 * found[k] / kSessions);
        qInfo("shift known to %.2f mm after 8", 1e3 * std::sqrt(far));
        QVERIFY(found[3] > 0.95 * kSessions);
        QVERIFY(found[7] > 0.99 * kSessions);
    }

    /// The mean of all stays where it was, and yet it is seen.
    void findsATurn()
    {
        test::Hand hand{419};
        const auto p_A = test::firstLandmarks(8);
        const Mat6 covariance = *fitCovariance(equalErrors(p_A, kFle));
        int found = 0;
        for (int i = 0; i < 200; ++i) {
            Session session{hand, p_A, covariance};
            for (int k = 0; k < 8; ++k)
                session.check(turnedAboutZ(degrees(3.0)));
            found += session.watch.report().state == WatchState::Drifted ? 1 : 0;
        }
        QVERIFY2(found >= 196, qPrintable(QString::number(found)));
    }

    void tellsSinceWhen()
    {
        test::Hand hand{421};
        const auto p_A = test::firstLandmarks(8);
        Session session{hand, p_A, *fitCovariance(equalErrors(p_A, kFle))};
        QVERIFY(session.watch.report().state == WatchState::Unchecked);
        QCOMPARE(session.watch.report().chance, 1.0);
        for (int k = 0; k < 10; ++k)
            session.check();
        QVERIFY(session.watch.report().state == WatchState::Good);
        QVERIFY(!session.watch.report().since);
        const Vec3 shift{0.0, 8e-3, 0.0};
        for (int k = 0; k < 4; ++k)
            session.check(RigidTransform::translation(shift));
        const WatchReport& report = session.watch.report();
        QVERIFY(report.state == WatchState::Drifted);
        QCOMPARE(report.checks, 4U);
        QVERIFY(*report.since == at(11.0));
        QVERIFY((report.shift_A - shift).norm() < 2e-3);
        QCOMPARE(session.watch.latest().size(), 14U);
        for (int k = 0; k < 30; ++k)
            session.check(); // it was put back
        QVERIFY(session.watch.report().state == WatchState::Good);
        QCOMPARE(session.watch.latest().size(), 16U);
    }

    /// By hand: one landmark at the origin, where of (w, v) only v counts.
    void knowsTheChanceOfOneCheck()
    {
        constexpr double kFit = 2.0; // mm along each axis
        const Mat6 covariance = 1e-6 * kFit * kFit * Mat6::Identity();
        RegistrationWatch watch{
            {Vec3::Zero()}, covariance, {.touch = millimetres(std::sqrt(3.0) * 1.5)}};
        watch.add({at(0.0), 0, {10e-3, 0.0, 0.0}});
        // 10^2 / (2^2 + 1.5^2) = 16 with three degrees of freedom: 1.134e-3, times nine tests.
        QVERIFY(std::abs(watch.report().chance / (9.0 * 1.1340e-3) - 1.0) < 1e-3);
        QVERIFY((watch.report().shift_A - Vec3{10e-3, 0.0, 0.0}).norm() < 1e-9);
        QVERIFY(watch.report().state == WatchState::Good);
    }

    void takesAStylusThatRestsOnALandmark()
    {
        const auto p_A = test::firstLandmarks(8);
        RegistrationWatch watch{p_A, *fitCovariance(equalErrors(p_A, kFle)), {.touch = kFle}};
        int tick = 0;
        const auto rest = [&](const Vec3& p_A_tip) {
            std::optional<LandmarkCheck> found;
            for (int i = 0; i < 90; ++i, ++tick) {
                if (const auto check = watch.push(at(tick / 60.0), p_A_tip, Validity::Tracked))
                    found = check;
            }
            return found;
        };
        const Vec3 beside{0.0, 1e-3, -1e-3};
        const auto check = rest(p_A[4] + beside);
        QVERIFY(check.has_value());
        QCOMPARE(check->landmark, 4U);
        QVERIFY((check->d_A - beside).norm() < 1e-9);
        QVERIFY(check->time == at(0.0));
        QVERIFY(!rest(p_A[2] + Vec3{0.0, 15.1e-3, 0.0})); // too far to be meant
        QVERIFY(rest(p_A[3] + Vec3{0.0, 14.9e-3, 0.0}).has_value());
        QCOMPARE(watch.latest().size(), 2U);
        for (int i = 0; i < 90; ++i, ++tick) // on its way
            QVERIFY(
                !watch.push(at(tick / 60.0), p_A[0] + Vec3{0.0, 0.0, 2e-3 * i}, Validity::Tracked));
    }
};

CARINA_TEST(TestRegistrationWatch)

} // namespace carina::registration_watch_test

#include "tst_registration_watch.moc"
