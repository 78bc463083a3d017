#include "apps/program/listening_round.h"

#include "tests/support/test_class.h"

#include <cmath>

namespace carina::program::listening_round_test
{
namespace
{

using namespace std::chrono_literals;

const Vec3 kParked{0.13, 0.0, 0.1};
const Vec3 kFirst{0.0, -0.12, -0.3};
const Vec3 kSecond{0.06, -0.12, -0.1};
constexpr double kExact_m = 1e-12;
constexpr Duration kEach = kListenerReach + kAtEachPlace;

bool isAt(const ListeningRound& round, Duration t, const Vec3& p_A)
{
    return (round.at(t).translation() - p_A).norm() < kExact_m;
}

/// Where its shaft points.
Vec3 ahead(const ListeningRound& round, Duration t)
{
    return round.at(t).rotation() * -Vec3::UnitZ();
}

} // namespace

class TestListeningRound : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isParkedUntilItListens()
    {
        const ListeningRound none{kParked, {kFirst, kSecond}};
        QVERIFY(isAt(none, -5s, kParked));
        QVERIFY(isAt(none, 500s, kParked));
        ListeningRound round{kParked, {kFirst, kSecond}};
        round.listen(20s);
        QVERIFY(isAt(round, 20s, kParked));
        QVERIFY((ahead(round, 20s) + Vec3::UnitZ()).norm() < kExact_m);
    }

    void restsAtEachPlaceAndGoesBack()
    {
        ListeningRound round{kParked, {kFirst, kSecond}};
        round.listen(20s);
        for (const Duration rest : {kListenerReach, kEach}) {
            QVERIFY(isAt(round, 20s + rest, kFirst));
            QVERIFY((ahead(round, 20s + rest) - Vec3::UnitY()).norm() < 1e-9); // to the back
            QVERIFY(isAt(round, 20s + kEach + rest, kSecond));
        }
        QVERIFY(isAt(round, 20s + 2 * kEach + kListenerReach, kParked));
        QVERIFY(isAt(round, 900s, kParked));
    }

    /// Half way of a minimum-jerk movement is at half its time.
    void goesInAnArcOverTheChest()
    {
        ListeningRound round{kParked, {kFirst, kSecond}};
        round.listen(0s);
        const Vec3 p_A = round.at(kEach + kListenerReach / 2).translation();
        const Vec3 middle = 0.5 * (kFirst + kSecond);
        QVERIFY(std::abs(p_A.x() - middle.x()) < 1e-9);
        QVERIFY(std::abs(p_A.z() - middle.z()) < 1e-9);
        QVERIFY(p_A.y() < middle.y() - 0.03);
        for (Duration t = 0s; t < 3 * kEach; t += 10ms) {
            const double step =
                (round.at(t + 10ms).translation() - round.at(t).translation()).norm();
            QVERIFY2(step < 0.012, qPrintable(QString::number(step))); // 1.2 m/s: no jump
        }
    }

    void leavesOutWhatItHasNoTimeFor()
    {
        ListeningRound round{kParked, {kFirst, kSecond}};
        round.listen(20s, 20s + 2 * kEach - 1ms);
        QVERIFY(isAt(round, 20s + kEach, kFirst));
        QVERIFY(isAt(round, 20s + kEach + kListenerReach, kParked));
        round.listen(100s, 100s + kEach - 1ms); // not even for one
        for (Duration t = 100s; t < 104s; t += 100ms)
            QVERIFY(isAt(round, t, kParked));
        round.listen(200s, 200s + 2 * kEach);
        QVERIFY(isAt(round, 200s + 2 * kEach, kSecond));
    }
};

CARINA_TEST(TestListeningRound)

} // namespace carina::program::listening_round_test

#include "tst_listening_round.moc"
