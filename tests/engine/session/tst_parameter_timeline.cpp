#include "engine/session/parameter_timeline.h"
#include "tests/engine/session/facts/sample_session.h"
#include "tests/support/test_class.h"

#include <random>
#include <utility>

namespace carina::parameter_timeline_test
{

using test::atSeconds;

class TestParameterTimeline : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdsEachValueUntilTheNext();
    void letsTheLaterOfTwoForOneTimeHold();
    void putsLateNewsInItsPlace();
    void tellsWhenTheNextChangeIs();
    void integratesValueOverTime();
    void integratesTruthToTheNanosecond();
    void agreesWithPlainSummationInAnyOrder();
    void forgetsWhatWasBefore();
};

void TestParameterTimeline::holdsEachValueUntilTheNext()
{
    ParameterTimeline<double> timeline{1.0};
    QCOMPARE(timeline.at(atSeconds(-1e6)), 1.0);
    timeline.set(atSeconds(10.0), 2.0);
    timeline.set(atSeconds(20.0), 3.0);
    QCOMPARE(timeline.at(atSeconds(10.0) - Duration{1}), 1.0);
    QCOMPARE(timeline.at(atSeconds(10.0)), 2.0);
    QCOMPARE(timeline.at(atSeconds(20.0) - Duration{1}), 2.0);
    QCOMPARE(timeline.at(atSeconds(20.0)), 3.0);
    QCOMPARE(timeline.at(SessionTime::max()), 3.0);
}

void TestParameterTimeline::letsTheLaterOfTwoForOneTimeHold()
{
    ParameterTimeline<double> timeline{0.0};
    timeline.set(atSeconds(1.0), 2.0);
    timeline.set(atSeconds(3.0), 5.0);
    timeline.set(atSeconds(1.0), 4.0);
    QCOMPARE(timeline.changes().size(), std::size_t{2});
    QCOMPARE(timeline.at(atSeconds(1.0)), 4.0);
    QCOMPARE(std::chrono::duration<double>{timeline.integral(atSeconds(4.0))}.count(), 13.0);
}

void TestParameterTimeline::putsLateNewsInItsPlace()
{
    ParameterTimeline<double> timeline{0.0};
    timeline.set(atSeconds(20.0), 3.0);
    timeline.set(atSeconds(10.0), 2.0);
    QCOMPARE(timeline.at(atSeconds(15.0)), 2.0);
    QCOMPARE(timeline.at(atSeconds(25.0)), 3.0);
    QVERIFY(timeline.changes()[0].from < timeline.changes()[1].from);
}

void TestParameterTimeline::tellsWhenTheNextChangeIs()
{
    ParameterTimeline<SessionPhase> timeline{SessionPhase::Prepared};
    QVERIFY(timeline.changeAfter(atSeconds(0.0)) == SessionTime::max());
    timeline.set(atSeconds(1.0), SessionPhase::Running);
    timeline.set(atSeconds(2.0), SessionPhase::Ended);
    QVERIFY(timeline.changeAfter(atSeconds(1.0) - Duration{1}) == atSeconds(1.0));
    QVERIFY(timeline.changeAfter(atSeconds(1.0)) == atSeconds(2.0));
    QVERIFY(timeline.changeAfter(atSeconds(2.0)) == SessionTime::max());
}

void TestParameterTimeline::integratesValueOverTime()
{
    const auto seconds = [](auto integral) {
        return std::chrono::duration<double>{integral}.count();
    };
    ParameterTimeline<double> timeline{7.0};
    QCOMPARE(seconds(timeline.integral(atSeconds(99.0))), 0.0);
    timeline.set(atSeconds(2.0), 3.0);
    timeline.set(atSeconds(4.0), 0.5);
    QCOMPARE(seconds(timeline.integral(atSeconds(2.0))), 0.0);
    QCOMPARE(seconds(timeline.integral(atSeconds(1.0))), 0.0);
    QCOMPARE(seconds(timeline.integral(atSeconds(3.0))), 3.0);
    QCOMPARE(seconds(timeline.integral(atSeconds(4.0))), 6.0);
    QCOMPARE(seconds(timeline.integral(atSeconds(10.0))), 9.0);
}

void TestParameterTimeline::integratesTruthToTheNanosecond()
{
    ParameterTimeline<bool> timeline{false};
    timeline.set(SessionTime{Duration{100}}, true);
    timeline.set(SessionTime{Duration{250}}, false);
    timeline.set(SessionTime{Duration{1000}}, true);
    QVERIFY(timeline.integral(SessionTime{Duration{101}}) == Duration{1});
    QVERIFY(timeline.integral(SessionTime{Duration{700}}) == Duration{150});
    QVERIFY(timeline.integral(SessionTime{Duration{1001}}) == Duration{151});
}

void TestParameterTimeline::agreesWithPlainSummationInAnyOrder()
{
    constexpr int kChanges = 400;
    std::mt19937 random{11};
    ParameterTimeline<double> timeline{0.0};
    std::vector<std::pair<std::int64_t, double>> plain; // whole values: sums are exact
    for (int i = 0; i < kChanges; ++i) {
        const auto time = std::int64_t(random() % 1000000);
        const double value = double(random() % 100);
        timeline.set(SessionTime{Duration{time}}, value);
        std::erase_if(plain, [time](const auto& change) { return change.first == time; });
        plain.emplace_back(time, value);
    }
    std::ranges::sort(plain);
    plain.emplace_back(2000000, 0.0);
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < plain.size(); ++i) {
        QCOMPARE(timeline.integral(SessionTime{Duration{plain[i].first}}).count(), sum);
        QCOMPARE(timeline.at(SessionTime{Duration{plain[i].first}}), plain[i].second);
        sum += plain[i].second * double(plain[i + 1].first - plain[i].first);
    }
    QCOMPARE(timeline.integral(SessionTime{Duration{2000000}}).count(), sum);
}

void TestParameterTimeline::forgetsWhatWasBefore()
{
    ParameterTimeline<double> whole{1.0};
    for (int i = 1; i <= 10; ++i)
        whole.set(atSeconds(double(i)), double(i * i));
    for (const double from : {0.5, 1.0, 4.0, 4.5, 10.0}) {
        ParameterTimeline<double> timeline = whole;
        timeline.forgetBefore(atSeconds(from));
        QCOMPARE(timeline.changes().size(), std::size_t(10 - std::max(0, int(from) - 1)));
        for (double t = from; t < 12.0; t += 0.25) {
            QCOMPARE(timeline.at(atSeconds(t)), whole.at(atSeconds(t)));
            QVERIFY(timeline.integral(atSeconds(t)) == whole.integral(atSeconds(t)));
            QVERIFY(timeline.changeAfter(atSeconds(t)) == whole.changeAfter(atSeconds(t)));
        }
        timeline.set(atSeconds(20.0), 7.0);
        ParameterTimeline<double> later = whole;
        later.set(atSeconds(20.0), 7.0);
        QVERIFY(timeline.integral(atSeconds(30.0)) == later.integral(atSeconds(30.0)));
    }
}

CARINA_TEST(TestParameterTimeline)

} // namespace carina::parameter_timeline_test

#include "tst_parameter_timeline.moc"
