#include "models/vitals/vital_words.h"
#include "models/vitals/vitals_model.h"
#include "tests/engine/audio/gain_of.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>

#include <cmath>

namespace carina::vitals_model_test
{
namespace
{

constexpr double kRate_perMin = 75.0; ///< a beat in 0.8 s
constexpr double kGrown_years = 40.0;
constexpr double kLook_s = 0.02;
const QString kProgram = QStringLiteral("trainee");

/// A patient with a curve for each heartbeat, and a monitor beside them.
struct Bed {
    SessionTime now{std::chrono::seconds{100}};
    std::optional<double> saturation = 0.97;
    bool lives = true;
    std::optional<AuscultationGains> stethoscope{};
    BreathFlows flows{};
    VitalsModel model{sources(), kGrown_years};

    VitalsSources sources()
    {
        return {.now = [this] { return std::optional{now}; },
                .vitals = [this](SessionTime t) { return lives ? vitalsAt(t) : std::nullopt; },
                .breath = [this](SessionTime) { return std::optional{flows}; },
                .stethoscope = [this](SessionTime) { return stethoscope; }};
    }

    [[nodiscard]] std::optional<Vitals> vitalsAt(SessionTime t) const
    {
        const double beat = std::fmod(toSeconds(t.time_since_epoch()), 60.0 / kRate_perMin);
        Vitals vitals;
        vitals.arterialSaturation = 0.97;
        vitals.saturation = saturation;
        vitals.pulseWave = beat > 0.3 && beat < 0.6 ? 1.0 : 0.0;
        vitals.electrocardiogram = beat > 0.1 && beat < 0.14 ? 1.1 : 0.0;
        vitals.exhaledCO2 = mmHg(38.0);
        vitals.endTidalCO2 = mmHg(38.4);
        vitals.capnographRate = perMinute(14.0);
        vitals.heartRate = perMinute(kRate_perMin);
        vitals.systolic = mmHg(121.0);
        vitals.diastolic = mmHg(78.2);
        vitals.mean = mmHg(92.0);
        return vitals;
    }

    void pass(double seconds)
    {
        for (double t = 0.0; t < seconds - 0.5 * kLook_s; t += kLook_s) {
            now += fromSeconds(kLook_s);
            model.look();
        }
    }

    /// Whether anything is heard in the next moment.
    [[nodiscard]] bool sounds(double seconds = 0.05)
    {
        std::vector<float> samples(static_cast<std::size_t>(seconds * kSoundRate));
        model.sounds().render(samples);
        float most = 0.0F;
        for (const float sample : samples)
            most = std::max(most, std::abs(sample));
        return most > 0.001F;
    }
};

bool isMute(VitalsModel& model, SoundKind kind)
{
    return test::gainOf(model.sounds().mixer(), kind) == 0.0;
}

} // namespace

class TestVitalsModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void samplesAtWholeMultiplesOfItsInterval()
    {
        Bed bed;
        bed.now += std::chrono::milliseconds{7};
        std::vector<double> times;
        connect(&bed.model, &VitalsModel::sampled, &bed.model,
                [&](const VitalsModel::Sample& sample) { times.push_back(sample.time_s); });
        bed.pass(1.0);
        QCOMPARE(times.size(), std::size_t{50}); // 100.02 to 101.00
        for (std::size_t i = 1; i < times.size(); ++i)
            QVERIFY(std::abs(times[i] - times[i - 1] - 0.02) < 1e-9);
        QVERIFY(std::abs(std::remainder(times.front(), 0.02)) < 1e-9);
    }

    void givesTheCurvesAsMeasured()
    {
        Bed bed;
        bed.saturation.reset();
        std::optional<VitalsModel::Sample> last;
        connect(&bed.model, &VitalsModel::sampled, &bed.model,
                [&](const VitalsModel::Sample& sample) { last = sample; });
        bed.pass(0.1);
        QVERIFY(last);
        QVERIFY(!last->pulse); // without its probe
        QVERIFY(std::abs(*last->exhaledCO2_mmHg - 38.0) < 1e-9);
        bed.saturation = 0.97;
        bed.pass(0.1);
        QVERIFY(last->pulse);
    }

    void tellsNumbersInWhole()
    {
        Bed bed;
        QCOMPARE(bed.model.numbers(), VitalsModel::Numbers{});
        bed.pass(1.5);
        const VitalsModel::Numbers numbers = bed.model.numbers();
        QCOMPARE(numbers.heartRate_perMin, 75);
        QCOMPARE(numbers.saturation_percent, 97);
        QCOMPARE(numbers.endTidalCO2_mmHg, 38);
        QCOMPARE(numbers.respiratoryRate_perMin, 14);
        QCOMPARE(numbers.pressure, (VitalsModel::BloodPressure{121, 78, 92}));
    }

    void changesNumbersWithWholeSecondsOnly()
    {
        Bed bed;
        bed.pass(1.5);
        bed.saturation = 0.93;
        bed.pass(0.4);
        QCOMPARE(bed.model.numbers().saturation_percent, 97);
        bed.pass(0.2);
        QCOMPARE(bed.model.numbers().saturation_percent, 93);
    }

    void showsAndSoundsOnePulsePerBeat()
    {
        Bed bed;
        int pulses = 0;
        bool was = false;
        for (int i = 0; i < 400; ++i) { // 8 s: ten beats
            bed.pass(kLook_s);
            pulses += bed.model.pulse() && !was ? 1 : 0;
            was = bed.model.pulse();
        }
        QCOMPARE(pulses, 10);
        QVERIFY(bed.sounds());
        bed.saturation.reset();
        (void)bed.sounds(0.5);
        bed.pass(3.0);
        QVERIFY(!bed.sounds());
    }

    void raisesAndSilencesAlarms()
    {
        Bed bed;
        bed.model.setLoudness(SoundKind::Oximeter, {70, true});
        bed.saturation = 0.84;
        bed.pass(VitalAlarms::kDelay_s + 0.5);
        (void)bed.sounds(0.2);
        QCOMPARE(bed.model.alarms().size(), std::size_t{1});
        QCOMPARE(bed.model.alarms().front().priority, AlarmPriority::High);
        QVERIFY(bed.sounds(1.0));
        const QSignalSpy changed{&bed.model, &VitalsModel::changed};
        bed.model.silenceAlarms();
        QVERIFY(bed.model.isSilenced());
        QCOMPARE(changed.count(), 1);
        bed.pass(kLook_s);
        (void)bed.sounds(0.1);
        QVERIFY(!bed.sounds(3.0));
        QCOMPARE(bed.model.alarms().size(), std::size_t{1});
    }

    void isStillWhereNobodyLives()
    {
        Bed bed;
        bed.saturation = 0.84;
        bed.pass(VitalAlarms::kDelay_s + 0.5);
        bed.lives = false;
        bed.pass(0.1);
        (void)bed.sounds(1.0);
        QVERIFY(!bed.sounds(3.0));
        QCOMPARE(bed.model.numbers(), VitalsModel::Numbers{});
        QVERIFY(bed.model.alarms().empty());
    }

    void showsWhatTheStethoscopeHears()
    {
        Bed bed;
        bed.model.setLoudness(SoundKind::Oximeter, {70, true});
        bed.flows.right = litresPerSecond(0.5);
        bed.pass(1.0);
        QCOMPARE(heardText(bed.model.heard()), QString{});
        (void)bed.sounds(0.2); // the tone fades
        QVERIFY(!bed.sounds());
        bed.stethoscope = AuscultationGains{.right = 1.0, .left = 0.06};
        bed.pass(0.1);
        QCOMPARE(heardText(bed.model.heard()), QStringLiteral("right lung"));
        QVERIFY(bed.sounds());
        bed.flows.rightObstruction = 0.8;
        bed.pass(0.1);
        QCOMPARE(heardText(bed.model.heard()), QStringLiteral("right lung, wheezing"));
        bed.flows = {};
        bed.pass(2.0);
        QCOMPARE(heardText(bed.model.heard()), QStringLiteral("nothing is heard here"));
        bed.flows.stomach = litresPerSecond(0.5);
        bed.stethoscope = AuscultationGains{.stomach = 1.0};
        bed.pass(0.1);
        QCOMPARE(heardText(bed.model.heard()), QStringLiteral("gurgling in the stomach"));
    }

    void showsTheHeartInItsBeats()
    {
        Bed bed;
        bed.stethoscope = AuscultationGains{.heart = 1.0};
        bed.pass(1.0);
        QCOMPARE(heardText(bed.model.heard()), QStringLiteral("heart"));
    }

    void skipsWhatIsLongAgo()
    {
        Bed bed;
        bed.pass(0.1);
        int samples = 0;
        connect(&bed.model, &VitalsModel::sampled, &bed.model, [&] { ++samples; });
        bed.now += std::chrono::minutes{5};
        bed.model.look();
        QCOMPARE(samples, 1);
    }

    void beginsAfreshWithAnotherPatient()
    {
        Bed bed;
        bed.saturation = 0.84;
        bed.pass(VitalAlarms::kDelay_s + 0.5);
        const QSignalSpy afresh{&bed.model, &VitalsModel::startedAfresh};
        bed.model.startAfresh(0.5);
        QVERIFY(bed.model.alarms().empty());
        QCOMPARE(bed.model.limits(), alarmLimits(0.5));
        QCOMPARE(bed.model.numbers(), VitalsModel::Numbers{});
    }

    void remembersHowLoudItIs()
    {
        const test::ScratchFolder folder;
        Bed bed;
        VitalsModel model{bed.sources(), kGrown_years, KeptSounds{folder.path(), kProgram}};
        model.setLoudness(SoundKind::Breath, {30, false});
        QCOMPARE(test::gainOf(model.sounds().mixer(), SoundKind::Breath), 0.3);
        model.setLoudness(SoundKind::Breath, {30, true});
        QVERIFY(isMute(model, SoundKind::Breath));
        VitalsModel next{bed.sources(), kGrown_years, KeptSounds{folder.path(), kProgram}};
        QVERIFY(isMute(next, SoundKind::Breath));
        QCOMPARE(next.loudness(SoundKind::Breath), (KeptSounds::Loudness{30, true}));
    }

    void mutesAllAndKeepsWhatEachKindHas()
    {
        const test::ScratchFolder folder;
        Bed bed;
        VitalsModel model{bed.sources(), kGrown_years, KeptSounds{folder.path(), kProgram}};
        model.setLoudness(SoundKind::Alarm, {40, true});
        const QSignalSpy changed{&model, &VitalsModel::changed};
        model.setMuted(true);
        QCOMPARE(changed.count(), 1);
        for (const SoundKind kind : kSoundKinds)
            QVERIFY(isMute(model, kind));
        VitalsModel next{bed.sources(), kGrown_years, KeptSounds{folder.path(), kProgram}};
        QVERIFY(next.isMuted() && isMute(next, SoundKind::Oximeter));
        model.setMuted(false);
        for (const SoundKind kind : kSoundKinds)
            QCOMPARE(isMute(model, kind), kind == SoundKind::Alarm);
        QCOMPARE(model.loudness(SoundKind::Alarm), (KeptSounds::Loudness{40, true}));
    }

    void isHeardOnlyWhileItIsInSight()
    {
        Bed bed;
        bed.pass(2.0);
        QVERIFY(bed.sounds());
        bed.model.setInSight(false);
        (void)bed.sounds(0.5); // the tone fades
        bed.pass(2.0);
        QVERIFY(!bed.sounds());
        bed.model.setInSight(true);
        bed.pass(2.0);
        QVERIFY(bed.sounds());
    }

    void hasWordsForEachAlarm()
    {
        QSet<QString> words;
        for (const VitalAlarm alarm : kVitalAlarms)
            words += alarmText({alarm, AlarmPriority::High}, AlarmLimits{});
        QCOMPARE(words.size(), qsizetype(kVitalAlarms.size()));
        QCOMPARE(alarmText({VitalAlarm::LowSaturation, AlarmPriority::High}, AlarmLimits{}),
                 QStringLiteral("SpO2 below 85\u00a0%"));
        QCOMPARE(alarmText({VitalAlarm::LowSaturation, AlarmPriority::Medium}, AlarmLimits{}),
                 QStringLiteral("SpO2 below 90\u00a0%"));
    }
};

CARINA_TEST(TestVitalsModel)

} // namespace carina::vitals_model_test

#include "tst_vitals_model.moc"
