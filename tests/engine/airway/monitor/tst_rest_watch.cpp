#include "engine/airway/monitor/rest_watch.h"

#include "tests/support/test_class.h"

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace carina::rest_watch_test
{

namespace
{

constexpr double kSample_s = 0.02;

struct Rest {
    double at_s;
    double depth_mm;
};

struct Place {
    double depth_mm;
    double aboveCarina_mm;
};

IntubationMonitor monitorAt(double seconds, const Place& place, TubeSeat seat,
                            bool areShapesApart = false)
{
    IntubationCourse course;
    course.shapes.isIn = areShapesApart;
    course.seat = seat;
    course.tip = {.at = SessionTime{fromSeconds(seconds)},
                  .depthAtTeeth = millimetres(place.depth_mm),
                  .aboveCarina = millimetres(place.aboveCarina_mm)};
    return IntubationMonitor{{}, course};
}

std::vector<Rest> restsOf(const std::function<Place(double)>& place, double seconds,
                          TubeSeat seat = TubeSeat::Trachea)
{
    RestWatch watch;
    std::vector<Rest> rests;
    for (double t = 0.0; t < seconds; t += kSample_s)
        if (const auto rest = watch.take(monitorAt(t, place(t), seat)))
            rests.push_back({t, inMillimetres(rest->depthAtTeeth)});
    return rests;
}

/// 20 mm/s down to 200 mm from 4 s on, and from 10 to 11 s 15 mm back.
Place insertedAndDrawnBack(double t)
{
    const double depth = std::min(120.0 + 20.0 * t, 200.0) - 15.0 * std::clamp(t - 10.0, 0.0, 1.0);
    return {depth, 230.0 - depth};
}

} // namespace

class TestRestWatch : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Two sightings far apart, with the last place repeated between them, are no rest.
    void doesNotCountATubeThatIsNotSeen()
    {
        RestWatch watch;
        const Place place{200.0, 30.0};
        QVERIFY(!watch.take(monitorAt(1.0, place, TubeSeat::Trachea)));
        for (int i = 0; i < 500; ++i)
            QVERIFY(!watch.take(monitorAt(1.0, place, TubeSeat::Trachea)));
        QVERIFY(!watch.take(monitorAt(11.0, place, TubeSeat::Trachea)));
    }

    void tellsWhereTheTubeComesToRest()
    {
        constexpr double kTime_s = 0.2;
        constexpr double kDepth_mm = 2.0;
        const std::vector<Rest> rests = restsOf(insertedAndDrawnBack, 20.0);
        QCOMPARE(rests.size(), std::size_t{2});
        QVERIFY(std::abs(rests[0].at_s - 5.0) < kTime_s);
        QVERIFY(std::abs(rests[0].depth_mm - 200.0) < kDepth_mm);
        QVERIFY(std::abs(rests[1].at_s - 12.0) < kTime_s);
        QVERIFY(std::abs(rests[1].depth_mm - 185.0) < kDepth_mm);
    }

    void saysNothingAnewOfWhatIsNotedAlready()
    {
        RestWatch watch;
        watch.note({.step = IntubationStep::CuffInflated,
                    .seat = TubeSeat::Trachea,
                    .depthAtTeeth = millimetres(201.0),
                    .tipAboveCarina = millimetres(29.0)});
        for (double t = 0.0; t < 5.0; t += kSample_s)
            QVERIFY(!watch.take(monitorAt(t, {200.0, 30.0}, TubeSeat::Trachea)));
    }

    /// 0.35 mm of a tracker, and a hand that trembles by 0.5 mm ten times a second.
    void isNotDeceivedByNoise()
    {
        std::mt19937 random{4};
        std::normal_distribution<double> noise{0.0, 0.35};
        const auto trembling = [&](double t) {
            const double depth = 200.0 + 0.5 * std::sin(63.0 * t) + noise(random);
            return Place{depth, 230.0 - depth + noise(random)};
        };
        QCOMPARE(restsOf(trembling, 120.0).size(), std::size_t{1});
    }

    /// What is known of a tube that creeps is never far from the truth.
    void followsATubeThatCreeps()
    {
        constexpr double kBehind_mm = 6.0;
        RestWatch watch;
        double known_mm = 180.0;
        for (double t = 0.0; t < 40.0; t += kSample_s) {
            const double depth_mm = 180.0 + t;
            const Place place{depth_mm, 230.0 - depth_mm};
            if (const auto rest = watch.take(monitorAt(t, place, TubeSeat::Trachea)))
                known_mm = inMillimetres(rest->depthAtTeeth);
            QVERIFY(std::abs(depth_mm - known_mm) < kBehind_mm);
        }
    }

    /// The connector stays at the teeth.
    void followsANeckThatIsFlexed()
    {
        const auto flexed = [](double t) {
            return Place{200.0, 30.0 - 8.0 * std::clamp(t - 5.0, 0.0, 1.0)};
        };
        QCOMPARE(restsOf(flexed, 10.0).size(), std::size_t{2});
    }

    void claimsNoDepthOutsideOfTheAirwayNorWhileTheShapesAreApart()
    {
        for (const TubeSeat seat : {TubeSeat::None, TubeSeat::Oesophagus})
            QVERIFY(restsOf(insertedAndDrawnBack, 20.0, seat).empty());
        RestWatch watch;
        for (double t = 0.0; t < 5.0; t += kSample_s)
            QVERIFY(!watch.take(monitorAt(t, {200.0, 30.0}, TubeSeat::Trachea, true)));
    }
};

CARINA_TEST(TestRestWatch)

} // namespace carina::rest_watch_test

#include "tst_rest_watch.moc"
