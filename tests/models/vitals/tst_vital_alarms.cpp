#include "models/vitals/vital_alarms.h"

#include "engine/physiology/body_figures.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::vital_alarms_test
{
namespace
{

constexpr double kStep_s = 0.1;

/// A monitor that is watched for some time.
struct Bed {
    VitalAlarms alarms{AlarmLimits{}};
    Vitals vitals = healthy();
    SessionTime now{};

    static Vitals healthy()
    {
        Vitals vitals;
        vitals.arterialSaturation = 0.98;
        vitals.saturation = 0.98;
        vitals.heartRate = perMinute(70.0);
        vitals.systolic = mmHg(120.0);
        return vitals;
    }

    /// @param breathes every four seconds, as the capnograph sees it
    void watch(double seconds, bool breathes = true)
    {
        for (double t = 0.0; t < seconds - 0.5 * kStep_s; t += kStep_s) {
            now += fromSeconds(kStep_s);
            const double phase = std::fmod(toSeconds(now.time_since_epoch()), 4.0);
            vitals.exhaledCO2 = mmHg(breathes && phase > 2.0 ? 38.0 : 0.0);
            alarms.take(vitals, now);
        }
    }

    [[nodiscard]] std::optional<AlarmPriority> of(VitalAlarm alarm) const
    {
        for (const auto& active : alarms.active())
            if (active.alarm == alarm)
                return active.priority;
        return std::nullopt;
    }
};

constexpr double kBeforeDelay_s = VitalAlarms::kDelay_s - 0.5;
constexpr double kAfterDelay_s = VitalAlarms::kDelay_s + 0.5;

} // namespace

class TestVitalAlarms : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areNoneForAHealthyPatient()
    {
        Bed bed;
        bed.watch(60.0);
        QVERIFY(bed.alarms.active().empty());
        QVERIFY(!bed.alarms.audible(bed.now));
    }

    void ofSaturationBecomeMoreUrgentAsItFalls()
    {
        Bed bed;
        bed.watch(10.0);
        bed.vitals.saturation = 0.894;
        bed.watch(kBeforeDelay_s);
        QVERIFY(!bed.of(VitalAlarm::LowSaturation));
        bed.watch(1.0);
        QCOMPARE(bed.of(VitalAlarm::LowSaturation), AlarmPriority::Medium);
        bed.vitals.saturation = 0.844;
        bed.watch(kAfterDelay_s);
        QCOMPARE(bed.of(VitalAlarm::LowSaturation), AlarmPriority::High);
    }

    void stayUntilTheValueIsClearlyBack()
    {
        Bed bed;
        bed.vitals.saturation = 0.84;
        bed.watch(kAfterDelay_s);
        bed.vitals.saturation = 0.854;
        bed.watch(0.2);
        QCOMPARE(bed.of(VitalAlarm::LowSaturation), AlarmPriority::High);
        bed.vitals.saturation = 0.865;
        bed.watch(0.2);
        QCOMPARE(bed.of(VitalAlarm::LowSaturation), AlarmPriority::Medium);
        bed.vitals.saturation = 0.904;
        bed.watch(0.2);
        QCOMPARE(bed.of(VitalAlarm::LowSaturation), AlarmPriority::Medium);
        bed.vitals.saturation = 0.914;
        bed.watch(0.2);
        QVERIFY(!bed.of(VitalAlarm::LowSaturation));
    }

    void doNotComeOfAShortDip()
    {
        Bed bed;
        for (int i = 0; i < 5; ++i) {
            bed.vitals.saturation = 0.8;
            bed.watch(kBeforeDelay_s);
            bed.vitals.saturation = 0.95;
            bed.watch(1.0);
        }
        QVERIFY(bed.alarms.active().empty());
    }

    void ofApnoeaComeTwentySecondsAfterTheLastBreath()
    {
        Bed bed;
        bed.watch(60.0, false); // nobody breathed into it yet
        QVERIFY(!bed.of(VitalAlarm::Apnoea));
        bed.watch(2.5); // the CO2 of a breath rises 2 s after a multiple of 4 s
        bed.watch(19.0, false);
        QVERIFY(!bed.of(VitalAlarm::Apnoea));
        bed.watch(2.0, false);
        QCOMPARE(bed.of(VitalAlarm::Apnoea), AlarmPriority::High);
        bed.watch(4.0);
        QVERIFY(!bed.of(VitalAlarm::Apnoea));
    }

    /// As a program that joins late meets the patient.
    void ofApnoeaKnowTheBreathBeforeTheFirstMoment()
    {
        Bed bed;
        bed.vitals.sinceBreath_s = 15.0;
        bed.watch(4.5, false);
        QVERIFY(!bed.of(VitalAlarm::Apnoea));
        bed.watch(1.0, false);
        QCOMPARE(bed.of(VitalAlarm::Apnoea), AlarmPriority::High);
    }

    // A tube in the oesophagus: some CO2, too little for a breath.
    void takeAWashoutForNoBreath()
    {
        Bed bed;
        bed.watch(8.0);
        for (int i = 0; i < 250; ++i) {
            bed.now += fromSeconds(kStep_s);
            bed.vitals.exhaledCO2 = mmHg(i % 40 > 20 ? 6.0 : 0.0);
            bed.alarms.take(bed.vitals, bed.now);
        }
        QCOMPARE(bed.of(VitalAlarm::Apnoea), AlarmPriority::High);
    }

    void ofTheHeartFollowItsRate_data()
    {
        QTest::addColumn<double>("rate");
        QTest::addColumn<int>("alarm");
        QTest::addColumn<int>("priority");
        QTest::newRow("slow") << 45.0 << int(VitalAlarm::SlowHeart) << int(AlarmPriority::Medium);
        QTest::newRow("very slow")
            << 38.0 << int(VitalAlarm::SlowHeart) << int(AlarmPriority::High);
        QTest::newRow("fast") << 130.0 << int(VitalAlarm::FastHeart) << int(AlarmPriority::Medium);
        QTest::newRow("none") << 0.0 << int(VitalAlarm::NoHeartbeat) << int(AlarmPriority::High);
    }

    void ofTheHeartFollowItsRate()
    {
        QFETCH(double, rate);
        QFETCH(int, alarm);
        QFETCH(int, priority);
        Bed bed;
        bed.vitals.heartRate = perMinute(rate);
        bed.watch(kAfterDelay_s);
        QCOMPARE(bed.alarms.active().size(), std::size_t{1});
        QCOMPARE(int(bed.alarms.active().front().alarm), alarm);
        QCOMPARE(int(bed.alarms.active().front().priority), priority);
    }

    void ofPressureFollowItsSystolicValue()
    {
        Bed bed;
        bed.vitals.systolic = mmHg(85.0);
        bed.watch(kAfterDelay_s);
        QCOMPARE(bed.of(VitalAlarm::LowPressure), AlarmPriority::Medium);
        bed.vitals.systolic = mmHg(65.0);
        bed.watch(kAfterDelay_s);
        QCOMPARE(bed.of(VitalAlarm::LowPressure), AlarmPriority::High);
        bed.vitals.systolic = mmHg(175.0);
        bed.watch(kAfterDelay_s);
        QVERIFY(!bed.of(VitalAlarm::LowPressure));
        QCOMPARE(bed.of(VitalAlarm::HighPressure), AlarmPriority::Medium);
    }

    void sayThatTheProbeIsOff()
    {
        Bed bed;
        bed.vitals.probeIsOn = false;
        bed.vitals.saturation.reset();
        bed.watch(20.0); // it was never on
        QVERIFY(bed.alarms.active().empty());
        bed.vitals.probeIsOn = true;
        bed.vitals.saturation = 0.97;
        bed.watch(1.0);
        bed.vitals.probeIsOn = false;
        bed.vitals.saturation.reset();
        bed.watch(kAfterDelay_s);
        QCOMPARE(bed.of(VitalAlarm::NoProbe), AlarmPriority::Low);
    }

    /// It is on the finger, and finds no pulse there.
    void sayNothingOfTheProbeInAnArrest()
    {
        Bed bed;
        bed.watch(1.0);
        bed.vitals.heartRate = {};
        bed.vitals.saturation.reset();
        bed.watch(kAfterDelay_s);
        QVERIFY(!bed.of(VitalAlarm::NoProbe));
        QCOMPARE(bed.of(VitalAlarm::NoHeartbeat), AlarmPriority::High);
    }

    /// No alarm says that 90 % is below 90 %.
    void ofSaturationGoByTheNumberThatIsShown()
    {
        Bed bed;
        bed.vitals.saturation = 0.896;
        bed.watch(kAfterDelay_s);
        QVERIFY(!bed.of(VitalAlarm::LowSaturation));
        bed.vitals.saturation = 0.894;
        bed.watch(kAfterDelay_s);
        QCOMPARE(bed.of(VitalAlarm::LowSaturation), AlarmPriority::Medium);
    }

    void areOrderedByUrgency()
    {
        Bed bed;
        bed.vitals.saturation = 0.88;
        bed.vitals.heartRate = {};
        bed.vitals.systolic = mmHg(60.0);
        bed.watch(kAfterDelay_s);
        const auto active = bed.alarms.active();
        QCOMPARE(active.size(), std::size_t{3});
        QCOMPARE(active[0].alarm, VitalAlarm::NoHeartbeat);
        QCOMPARE(active[1].alarm, VitalAlarm::LowPressure);
        QCOMPARE(active[2].alarm, VitalAlarm::LowSaturation);
        QCOMPARE(bed.alarms.audible(bed.now), AlarmPriority::High);
    }

    void areSilentForTwoMinutes()
    {
        Bed bed;
        bed.vitals.saturation = 0.88;
        bed.watch(kAfterDelay_s);
        QCOMPARE(bed.alarms.audible(bed.now), AlarmPriority::Medium);
        bed.alarms.silence(bed.now);
        bed.watch(119.0);
        QVERIFY(bed.alarms.isSilenced(bed.now) && !bed.alarms.audible(bed.now));
        QCOMPARE(bed.of(VitalAlarm::LowSaturation), AlarmPriority::Medium); // and still shown
        bed.watch(2.0);
        QCOMPARE(bed.alarms.audible(bed.now), AlarmPriority::Medium);
    }

    void areHeardAgainWhenSomethingNewComes()
    {
        Bed bed;
        bed.vitals.saturation = 0.88;
        bed.watch(kAfterDelay_s);
        bed.alarms.silence(bed.now);
        bed.vitals.saturation = 0.84; // more urgent
        bed.watch(kAfterDelay_s);
        QCOMPARE(bed.alarms.audible(bed.now), AlarmPriority::High);
        bed.alarms.silence(bed.now);
        bed.vitals.heartRate = perMinute(130.0); // another one
        bed.watch(kAfterDelay_s);
        QVERIFY(!bed.alarms.isSilenced(bed.now));
    }

    // A session that pauses for minutes is no apnoea of minutes.
    void doNotCountTimeThatNobodySaw()
    {
        Bed bed;
        bed.watch(8.0);
        bed.watch(15.0, false);
        bed.now += std::chrono::minutes{10};
        bed.watch(0.1, false);
        QVERIFY(!bed.of(VitalAlarm::Apnoea));
    }

    void areNoneForAnyoneHealthyAtRest()
    {
        constexpr double kOneWeek_years = 7.0 / 365.0;
        for (double age = 0.0; age < 20.0; age += kOneWeek_years) {
            const BodyFigures body = bodyFiguresOf({metres(1.0), 15.0, age, Sex::Female});
            const Frequency rate = perMinute(body.heartRate_perMin);
            const Pressure systolic = mmHg(body.mean_mmHg + 2.0 / 3.0 * body.pulse_mmHg);
            const AlarmLimits limits = alarmLimits(age);
            QVERIFY2(rate > limits.slowHeart && rate < limits.fastHeart,
                     qPrintable(QString::number(age)));
            QVERIFY2(systolic > limits.lowSystolic && systolic < limits.highSystolic,
                     qPrintable(QString::number(age)));
        }
    }

    // 2nd to 98th centile of 953 newborns who rested, at 2 to 24 hours: 96 to 162 /min (Tveiten et
    // al. 2021).
    void areNoneForANewbornOfAHealthyRate()
    {
        const AlarmLimits limits = alarmLimits(0.0);
        QVERIFY(inPerMinute(limits.slowHeart) < 96.0);
        QVERIFY(inPerMinute(limits.fastHeart) > 162.0);
        QVERIFY(alarmLimits(0.1).slowHeart > limits.slowHeart);
        QVERIFY(alarmLimits(0.1).fastHeart > limits.fastHeart);
    }

    // American Heart Association: 70 + 2 age; Fleming et al. 2011 at 12 to 15 years: 47 and 108.
    void haveLimitsByAge()
    {
        QCOMPARE(inMmHg(alarmLimits(0.0).lowSystolic), 60.0);
        QCOMPARE(inMmHg(alarmLimits(0.5).lowSystolic), 70.0);
        QVERIFY(std::abs(inMmHg(alarmLimits(6.0).lowSystolic) - 82.0) < 1e-9);
        QVERIFY(std::abs(inMmHg(alarmLimits(12.0).lowSystolic) - 90.0) < 1e-9);
        QVERIFY(std::abs(inPerMinute(alarmLimits(12.0).slowHeart) - 47.0) < 1e-9);
        QVERIFY(std::abs(inPerMinute(alarmLimits(12.0).fastHeart) - 108.0) < 1e-9);
        QCOMPARE(alarmLimits(40.0), AlarmLimits{});
        QCOMPARE(alarmLimits(0.5).apnoea, Duration{std::chrono::seconds{15}});
        for (double age = 0.1; age < 17.0; age += 0.1)
            QVERIFY(alarmLimits(age + 0.1).fastHeart <= alarmLimits(age).fastHeart);
        for (double age = 0.0; age < 17.0; age += 0.1) {
            QVERIFY(alarmLimits(age + 0.1).lowSystolic >= alarmLimits(age).lowSystolic);
            QVERIFY(alarmLimits(age).highSystolic > alarmLimits(age).lowSystolic);
        }
    }
};

CARINA_TEST(TestVitalAlarms)

} // namespace carina::vital_alarms_test

#include "tst_vital_alarms.moc"
