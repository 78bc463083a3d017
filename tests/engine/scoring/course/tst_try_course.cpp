#include "engine/scoring/course/try_course.h"

#include "engine/scoring/score/metric.h"
#include "tests/engine/scoring/course/hand_written_course.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::try_course_test
{
namespace
{

using namespace carina::test;

const Vec3 kUp = -Vec3::UnitY();

TryCourse follow(const HandWrittenCourse& written)
{
    TryCourse course{kUp};
    for (const IntubationEvent& event : written.events())
        course.add(event);
    return course;
}

PoseSample bladeAt(double seconds, double x)
{
    PoseSample sample;
    sample.time = courseTime(seconds);
    sample.X_FO = RigidTransform::translation({x, 0.0, 0.0});
    return sample;
}

} // namespace

class TestTryCourse : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginsWithBladeOrTube();
    void endsAfterSomeBreaths();
    void endsWhenAllIsOut();
    void goesOnWithATubeInTheOesophagus();
    void goesOnBetweenAttempts();
    void endsAtItsLongest();
    void measuresTheHandWhileTheBladeIsIn();
    void knowsLaterThatTheBladeIsInOrOut();
    void takesWhatIsKnownOfThePatient();
    void leavesOutWhatCameAfterItsEnd();
    void measuresNothingBeyondAnEndThatIsKnownLater();
    void endsAtTheLaterOfBothWhicheverIsKnownFirst();
    void isNotSetBackByWhatIsSaid();
    void keepsNoMoreThanItsMost();
    void believesWhatIsSaidAfterTheEnd();
    void endsByABreathWhereThePersonSaysItWent();
    void tellsTheSameWithAPauseInIt_data();
    void tellsTheSameWithAPauseInIt();
    void endsAsMuchLaterAsItWasPaused();
};

void TestTryCourse::beginsWithBladeOrTube()
{
    TryCourse course{kUp};
    course.add({.step = IntubationStep::TubeOut});
    course.add({.step = IntubationStep::CuffInflated});
    course.addVitals(courseTime(1.0), saturatedBy(0.5));
    QVERIFY(!course.hasBegun());
    QVERIFY(!course.endedBy(courseTime(5000.0)));
    course.add({.step = IntubationStep::TubePastTeeth, .at = courseTime(5.0)});
    QVERIFY(course.hasBegun());
    QVERIFY(!course.metrics(courseTime(6.0), std::nullopt).oxygen);
}

void TestTryCourse::endsAfterSomeBreaths()
{
    const TryCourse course = follow(goodCourse());
    QVERIFY(!course.endedBy(courseTime(49.9)));
    QCOMPARE(course.endedBy(courseTime(50.0)), courseTime(50.0));
    QCOMPARE(course.endedBy(courseTime(70.0)), courseTime(50.0));
}

void TestTryCourse::endsWhenAllIsOut()
{
    HandWrittenCourse written;
    written.at(10.0, IntubationStep::BladeIn)
        .at(20.0, IntubationStep::TubePastTeeth)
        .at(25.0, IntubationStep::BladeOut)
        .at(30.0, IntubationStep::TubeOut);
    const TryCourse course = follow(written);
    QVERIFY(!course.endedBy(courseTime(39.9)));
    QCOMPARE(course.endedBy(courseTime(40.0)), courseTime(30.0));
}

void TestTryCourse::goesOnWithATubeInTheOesophagus()
{
    HandWrittenCourse written;
    written.at(10.0, IntubationStep::BladeIn)
        .at(17.0, IntubationStep::TubePastTeeth)
        .at(20.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus)
        .at(24.0, IntubationStep::BladeOut)
        .at(30.0, IntubationStep::FirstBreath);
    QVERIFY(!follow(written).endedBy(courseTime(300.0)));
}

void TestTryCourse::goesOnBetweenAttempts()
{
    HandWrittenCourse written;
    written.at(10.0, IntubationStep::BladeIn)
        .at(20.0, IntubationStep::BladeOut)
        .at(29.0, IntubationStep::BladeIn);
    QVERIFY(!follow(written).endedBy(courseTime(60.0)));
}

void TestTryCourse::endsAtItsLongest()
{
    HandWrittenCourse written;
    written.at(10.0, IntubationStep::BladeIn);
    QVERIFY(!follow(written).endedBy(courseTime(609.9)));
    for (const double now : {610.0, 611.0})
        QCOMPARE(follow(written).endedBy(courseTime(now)), courseTime(610.0));
}

/// It is still for two seconds, and between blade out and in again far away.
void TestTryCourse::measuresTheHandWhileTheBladeIsIn()
{
    TryCourse course{kUp};
    for (int i = 0; i < 120; ++i)
        course.addBlade(bladeAt(i / 60.0, 1e-3 * i));
    course.add({.step = IntubationStep::BladeIn, .at = courseTime(2.0)});
    for (int i = 120; i <= 240; ++i)
        course.addBlade(bladeAt(i / 60.0, 0.0));
    course.add({.step = IntubationStep::BladeOut, .at = courseTime(4.0)});
    for (int i = 240; i <= 360; ++i)
        course.addBlade(bladeAt(i / 60.0, 1.0));
    const TryMetrics metrics = course.metrics(courseTime(6.0), std::nullopt);
    QCOMPARE(metrics.hand->path.si, 0.0);
    QVERIFY(std::abs(toSeconds(metrics.hand->watched) - 2.0) < 1e-6);
    QVERIFY(std::abs(toSeconds(metrics.plane->measured) - 2.0) < 1e-6);
    QVERIFY(!metrics.head);
}

/// As a monitor notes it: half a second and two seconds late. The hand is moved only outside.
void TestTryCourse::knowsLaterThatTheBladeIsInOrOut()
{
    TryCourse course{kUp};
    course.add({.step = IntubationStep::TubePastTeeth, .at = courseTime(0.0)});
    const auto x = [](double t) { return t < 2.0 ? 2.0 - t : t < 5.0 ? 0.0 : t - 5.0; };
    for (int i = 0; i <= 60 * 12; ++i) {
        const double t = i / 60.0;
        course.addBlade(bladeAt(t, x(t)));
        if (i == 150)
            course.add({.step = IntubationStep::BladeIn, .at = courseTime(2.0)});
        if (i == 420)
            course.add({.step = IntubationStep::BladeOut, .at = courseTime(5.0)});
    }
    const TryMetrics metrics = course.metrics(courseTime(12.0), std::nullopt);
    QCOMPARE(metrics.hand->path.si, 0.0);
    QVERIFY(std::abs(toSeconds(metrics.hand->watched) - 3.0) < 1e-6);
    QVERIFY(std::abs(toSeconds(metrics.plane->measured) - 3.0) < 1e-6);
}

void TestTryCourse::takesWhatIsKnownOfThePatient()
{
    TryCourse course = follow(goodCourse());
    QVERIFY(!course.metrics(courseTime(50.0), std::nullopt).incisors);
    course.addForces(courseTime(12.0), newtons(0.0), newtons(30.0));
    course.addForces(courseTime(12.2), newtons(25.0), newtons(0.0));
    course.addVitals(courseTime(12.0), saturatedBy(0.97));
    course.addHeadExtension(degrees(20.0));
    course.addHeadExtension(degrees(5.0)); // later
    course.check(TryCheck::Auscultated, true);
    const TryMetrics metrics = course.metrics(courseTime(50.0), millimetres(195.0));
    QCOMPARE(inNewtons(metrics.incisors->peak), 25.0);
    QCOMPARE(inNewtons(metrics.tongue->peak), 30.0);
    QCOMPARE(metrics.oxygen->lowest, 0.97);
    QCOMPARE(metrics.headExtension, degrees(20.0));
    QCOMPARE(metrics.check(TryCheck::Auscultated), std::optional{true});
    QVERIFY(!metrics.check(TryCheck::Prepared));
    QCOMPARE(metrics.depthWanted, millimetres(195.0));
}

void TestTryCourse::leavesOutWhatCameAfterItsEnd()
{
    HandWrittenCourse written = goodCourse();
    written.at(55.0, IntubationStep::PastCarina, TubeSeat::RightMain);
    const TryCourse course = follow(written);
    QCOMPARE(course.metrics(courseTime(50.0), std::nullopt).outcome, TryOutcome::Trachea);
    QCOMPARE(course.metrics(courseTime(60.0), std::nullopt).outcome, TryOutcome::RightMain);
}

/// All was out at 20 s, and that it ended then is known ten seconds later.
void TestTryCourse::measuresNothingBeyondAnEndThatIsKnownLater()
{
    HandWrittenCourse written;
    written.at(10.0, IntubationStep::BladeIn).at(20.0, IntubationStep::BladeOut);
    TryCourse course = follow(written);
    for (int i = 0; i <= 20 * 60; ++i) {
        const double t = 10.0 + i / 60.0;
        course.addVitals(courseTime(t), saturatedBy(t > 20.0 ? 0.80 : 0.95));
        course.addHead(bladeAt(t, t > 20.0 ? 0.1 * (t - 20.0) : 0.0));
    }
    const SessionTime ended = course.endedBy(courseTime(30.0)).value();
    QCOMPARE(ended, courseTime(20.0));
    const TryMetrics metrics = course.metrics(ended, std::nullopt);
    QCOMPARE(metrics.oxygen->lowest, 0.95);
    QVERIFY(!metrics.head || metrics.head->path.si < 1e-9);
    const TryMetrics longer = course.metrics(courseTime(30.0), std::nullopt);
    QCOMPARE(longer.oxygen->lowest, 0.80);
    QVERIFY(longer.head->path.si > 0.5);
}

/// That the blade is out is known two seconds later.
void TestTryCourse::endsAtTheLaterOfBothWhicheverIsKnownFirst()
{
    HandWrittenCourse written;
    written.at(10.0, IntubationStep::BladeIn)
        .at(11.0, IntubationStep::TubePastTeeth)
        .at(15.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus)
        .at(19.5, IntubationStep::OutOfOesophagus, TubeSeat::None)
        .at(20.0, IntubationStep::TubeOut)
        .at(19.0, IntubationStep::BladeOut);
    const TryCourse course = follow(written);
    const SessionTime ended = course.endedBy(courseTime(40.0)).value();
    QCOMPARE(ended, courseTime(20.0));
    QCOMPARE(course.metrics(ended, std::nullopt).outcome, TryOutcome::OesophagusRecognised);
}

/// The first breath was at 30 s, as is said at 200 s; the patient has run out of oxygen meanwhile.
void TestTryCourse::isNotSetBackByWhatIsSaid()
{
    HandWrittenCourse written;
    written.at(10.0, IntubationStep::TubePastTeeth)
        .at(20.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus)
        .at(30.0, IntubationStep::FirstBreath);
    TryCourse course = follow(written);
    for (int i = 0; i < 500; ++i)
        course.addVitals(courseTime(10.0 + 0.4 * i), saturatedBy(i <= 100 ? 0.99 : 0.60));
    QVERIFY(!course.endedBy(courseTime(200.0)));
    course.tell(TubeSeat::Trachea, courseTime(200.0));
    QVERIFY(!course.endedBy(courseTime(219.0)));
    const SessionTime ended = course.endedBy(courseTime(220.0)).value();
    QCOMPARE(ended, courseTime(220.0));
    QCOMPARE(course.metrics(ended, std::nullopt).oxygen->lowest, 0.60);
    QCOMPARE(course.metrics(courseTime(50.0), std::nullopt).oxygen->lowest, 0.99);
}

/// It is said of the end; the monitor had the tip above the cords.
void TestTryCourse::believesWhatIsSaidAfterTheEnd()
{
    HandWrittenCourse written;
    written.at(10.0, IntubationStep::TubePastTeeth);
    TryCourse course = follow(written);
    QVERIFY(!course.metrics(courseTime(50.0), std::nullopt).isTold);
    course.tell(TubeSeat::Oesophagus, courseTime(70.0));
    const TryMetrics told = course.metrics(courseTime(50.0), std::nullopt);
    QVERIFY(told.isTold);
    QCOMPARE(told.confidence, 1.0);
    QCOMPARE(told.outcome, TryOutcome::OesophagusUnrecognised);
    QCOMPARE(told.oesophagus.at(0).in, courseTime(50.0));
}

void TestTryCourse::endsByABreathWhereThePersonSaysItWent()
{
    TryCourse course = follow(goodCourse()); // whose first breath is at 30 s
    course.tell(TubeSeat::Oesophagus, courseTime(35.0));
    QVERIFY(!course.endedBy(courseTime(60.0)));
    course.tell(std::nullopt, courseTime(40.0));
    QVERIFY(!course.endedBy(courseTime(59.9))); // it may be said anew
    QCOMPARE(course.endedBy(courseTime(60.0)), courseTime(40.0) + TryCourse::kVentilatedFor);
}

void TestTryCourse::keepsNoMoreThanItsMost()
{
    HandWrittenCourse written;
    for (std::size_t i = 0; i < TryCourse::kMostEvents + 50; ++i)
        written.at(0.1 * double(i), IntubationStep::BladeIn);
    QCOMPARE(follow(written).metrics(courseTime(500.0), std::nullopt).attempts.size(),
             TryCourse::kMostEvents);
}

void TestTryCourse::tellsTheSameWithAPauseInIt_data()
{
    QTest::addColumn<double>("at");
    for (const double at : {12.0, 21.0, 28.0, 33.0})
        QTest::addRow("at %.0f s", at) << at;
}

/// Everything behind it happens as much later: an oesophageal try with too little oxygen, a hand
/// and a head that move, and forces.
void TestTryCourse::tellsTheSameWithAPauseInIt()
{
    constexpr double kPause_s = 100.0;
    constexpr double kStep_s = 1.0 / 60.0;
    QFETCH(const double, at);
    const auto metricsOf = [at](double pause_s) {
        const auto later = [at, pause_s](double seconds) {
            return courseTime(seconds < at ? seconds : seconds + pause_s);
        };
        HandWrittenCourse written;
        written.at(10.0, IntubationStep::BladeIn)
            .at(17.0, IntubationStep::TubePastTeeth)
            .at(20.0, IntubationStep::InOesophagus, TubeSeat::Oesophagus)
            .at(29.0, IntubationStep::BladeOut)
            .at(31.0, IntubationStep::OutOfOesophagus, TubeSeat::None)
            .at(35.0, IntubationStep::TubeOut);
        TryCourse course{kUp};
        Pauses pauses;
        pauses.add(courseTime(at), courseTime(at + pause_s));
        course.setPauses(pauses);
        auto event = written.events().begin();
        for (double t = 10.0; t < 40.0; t += kStep_s) {
            for (; event != written.events().end() && event->at <= courseTime(t); ++event) {
                IntubationEvent happened = *event;
                happened.at = later(toSeconds(event->at.time_since_epoch()));
                course.add(happened);
            }
            PoseSample sample = bladeAt(0.0, 0.05 * std::sin(2.0 * t));
            sample.time = later(t);
            course.addBlade(sample);
            course.addHead(sample);
            course.addForces(later(t), newtons(t < 30.0 ? 25.0 : 0.0), newtons(30.0));
            course.addVitals(later(t), saturatedBy(t > 20.5 ? 0.85 : 0.95));
        }
        return course.metrics(later(36.0), millimetres(200.0));
    };
    const TryMetrics plain = metricsOf(0.0);
    const TryMetrics paused = metricsOf(kPause_s);
    QVERIFY(plain.incisors && plain.hand && plain.head && plain.oxygen->below > Duration{});
    for (std::size_t i = 0; i < kMetricCount; ++i) {
        const auto metric = static_cast<Metric>(i);
        const auto without = valueOf(plain, metric);
        const auto with = valueOf(paused, metric);
        QCOMPARE(with.has_value(), without.has_value());
        // A force that was held for a step less, and a hand that is measured for a window less.
        const double tolerance = metric == Metric::TongueImpulse ? 30.0 * 1.1 * kStep_s
                                 : metric >= Metric::PlaneTilt && metric <= Metric::HeadJerk
                                     ? 0.15 * std::abs(without.value_or(0.0))
                                     : 0.04;
        QVERIFY2(!with || std::abs(*with - *without) <= tolerance,
                 qPrintable(QStringLiteral("%1: %2 and %3")
                                .arg(QLatin1String{entryOf(metric).word})
                                .arg(with.value_or(0.0))
                                .arg(without.value_or(0.0))));
    }
}

void TestTryCourse::endsAsMuchLaterAsItWasPaused()
{
    Pauses pauses;
    pauses.add(courseTime(35.0), courseTime(135.0));
    TryCourse good = follow(goodCourse()); // breathes at 30 s
    good.setPauses(pauses);
    QVERIFY(!good.endedBy(courseTime(149.9)));
    QCOMPARE(good.endedBy(courseTime(150.0)), courseTime(150.0));
    HandWrittenCourse out;
    out.at(10.0, IntubationStep::BladeIn).at(30.0, IntubationStep::BladeOut);
    TryCourse givenUp = follow(out);
    givenUp.setPauses(pauses);
    QVERIFY(!givenUp.endedBy(courseTime(139.9)));
    QCOMPARE(givenUp.endedBy(courseTime(140.0)), courseTime(30.0));
    HandWrittenCourse endless;
    endless.at(10.0, IntubationStep::BladeIn);
    TryCourse longest = follow(endless);
    longest.setPauses(pauses);
    QVERIFY(!longest.endedBy(courseTime(709.9)));
    QCOMPARE(longest.endedBy(courseTime(710.0)), courseTime(710.0));
}

CARINA_TEST(TestTryCourse)

} // namespace carina::try_course_test

#include "tst_try_course.moc"
