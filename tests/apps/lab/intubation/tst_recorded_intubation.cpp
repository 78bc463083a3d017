#include "apps/lab/intubation/recorded_intubation.h"

#include "apps/lab/commands.h"
#include "apps/lab/intubation/intubation_trial.h"
#include "apps/lab/intubation/intubation_words.h"
#include "engine/geometry/rotation.h"
#include "engine/net/devices/any_recording.h"
#include "tests/evaluation/intubation/tube_patient.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::lab::recorded_intubation_test
{
namespace
{

constexpr double kRounding_mm = 0.01; ///< of a depth, by that of the poses in a file
/// Of a depth where the tube bends about the incisors: which of its places is nearest to them
/// depends on more than the rounding.
constexpr double kNearest_mm = 0.5;
/// A recording begins with its first exposure, and the motion a little before it: by the jitter.
constexpr Duration kFirstExposure = std::chrono::milliseconds{4};

/// With the tube as it is measured: what the hands move is rigid.
const IntubationSubject& subject()
{
    static const IntubationSubject boy = [] {
        const PatientDimensions dimensions = dimensionsOf(BuiltinPatient::TwelveYears);
        IntubationSubject it =
            intubationSubject(test::tubePatient(dimensions), buildOf(dimensions), {}).value();
        it.lumen = nullptr;
        return it;
    }();
    return boy;
}

RecordingSetup setupOf(const IntubationTrial& trial)
{
    return {.blade = motionBlade(subject().motion->upper), .commands = trial.commands};
}

/// Everything that was noted, at the same times.
void isNotedAlike(const WatchedIntubation& recorded, const WatchedIntubation& script)
{
    QCOMPARE(recorded.noted.size(), script.noted.size());
    for (std::size_t i = 0; i < script.noted.size(); ++i) {
        const IntubationEvent& one = recorded.noted[i].event;
        const IntubationEvent& other = script.noted[i].event;
        QCOMPARE(one.step, other.step);
        QCOMPARE(one.seat, other.seat);
        QVERIFY(std::chrono::abs(one.at - other.at) < kFirstExposure);
        const double apart_mm = std::abs(inMillimetres(one.depthAtTeeth - other.depthAtTeeth));
        QVERIFY2(apart_mm < kNearest_mm, qPrintable(QString::number(apart_mm)));
    }
    QCOMPARE(recorded.course.seat, script.course.seat);
    QCOMPARE(recorded.course.attempts, script.course.attempts);
    QVERIFY(std::abs(recorded.course.confidence - script.course.confidence) < 1e-3);
    QVERIFY(
        std::abs(inMillimetres(recorded.course.tip.depthAtTeeth - script.course.tip.depthAtTeeth))
        < kRounding_mm);
}

/// The same poses as a tracker elsewhere sees markers on the tools.
TrackerSequence seenFrom(TrackerSequence recording, const RigidTransform& X_TA,
                         const std::array<RigidTransform, 3>& X_ON)
{
    for (std::size_t i = 0; i < X_ON.size(); ++i)
        for (PoseSample& sample : recording.tools[i].samples)
            sample.X_FO = X_TA * sample.X_FO * X_ON[i];
    return recording;
}

} // namespace

/// Recordings that the generator wrote, in a patient of tubes.
class TestRecordedIntubation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsOfAFileWhatItTellsOfTheScript_data()
    {
        QTest::addColumn<MotionKind>("kind");
        QTest::addColumn<QString>("file");
        const auto row = [](const char* name, MotionKind kind, const char* file) {
            QTest::newRow(name) << kind << QString::fromLatin1(file);
        };
        row("good", MotionKind::Good, "good.csv");
        row("right_mainstem", MotionKind::RightMainstem, "right.csv");
        row("late_recognition", MotionKind::LateRecognition, "late.csv");
        row("oesophageal, of Plus", MotionKind::Oesophageal, "oesophageal.igs.mha");
    }
    void tellsOfAFileWhatItTellsOfTheScript()
    {
        QFETCH(const MotionKind, kind);
        QFETCH(const QString, file);
        const test::ScratchFolder folder;
        const std::string path = folder.filePath(file.toLatin1().constData()).toStdString();
        const IntubationTrial trial = runTrial(subject(), kind, 2).value();
        QVERIFY(writeAnyRecording(path, recordingOf(trial.seen)));
        const auto recording = readAnyRecording(path);
        QVERIFY2(recording.has_value(), recording ? "" : recording.error().detail.c_str());
        const auto recorded = watchRecording(subject(), *recording, setupOf(trial));
        QVERIFY(recorded);
        isNotedAlike(*recorded, trial);
    }

    void takesRegistrationAndCalibrationsOfASite()
    {
        const IntubationTrial trial = runTrial(subject(), MotionKind::Good, 2).value();
        const RigidTransform X_TA{rotationFromVector({0.3, -1.2, 0.7}), {0.4, -0.2, 1.9}};
        const RigidTransform X_EN{rotationFromVector({1.1, 0.2, -0.4}), {0.01, 0.03, 0.02}};
        const RigidTransform X_LN{rotationFromVector({-0.6, 0.9, 0.1}), {-0.02, 0.10, 0.01}};
        const RigidTransform X_AJ{rotationFromVector({0.2, 0.1, 0.5}), {0.0, -0.05, 0.22}};
        const TrackerSequence recording =
            seenFrom(recordingOf(trial.seen), X_TA, {X_EN, X_LN, X_AJ});
        RecordingSetup setup = setupOf(trial);
        setup.registration = {.X_AT = X_TA.inverse(),
                              .X_JA = X_AJ.inverse(),
                              .X_NE = X_EN.inverse(),
                              .X_NL = X_LN.inverse()};
        const auto recorded = watchRecording(subject(), recording, setup);
        QVERIFY(recorded);
        isNotedAlike(*recorded, trial);
        setup.registration.X_NE.reset();
        const auto without = watchRecording(subject(), recording, setup);
        QVERIFY(without && without->course.seat != trial.course.seat);
    }

    void doesWithoutLaryngoscopeAndJaw()
    {
        const IntubationTrial trial = runTrial(subject(), MotionKind::Good, 2).value();
        TrackerSequence recording = recordingOf(trial.seen);
        recording.tools.resize(1);
        const auto recorded = watchRecording(subject(), recording, setupOf(trial));
        QVERIFY(recorded);
        QCOMPARE(recorded->course.seat, TubeSeat::Trachea);
        QCOMPARE(recorded->course.attempts, 0);
    }

    void refusesARecordingWithoutATube()
    {
        const IntubationTrial trial = runTrial(subject(), MotionKind::Good, 2).value();
        TrackerSequence recording = recordingOf(trial.seen);
        recording.tools.erase(recording.tools.begin());
        const auto refused = watchRecording(subject(), recording, setupOf(trial));
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, Errc::NothingRecognised);
    }

    /// In the help and where another word is refused.
    void namesAllThatCanBeTold()
    {
        const test::ScratchFolder folder;
        const QString file = folder.write("poses.csv", "# carina.poses/1\n");
        const auto told = [&](const QString& word) {
            return QString::fromStdString(
                intubateCommand()
                    .run({file, QStringLiteral("--told"), word + QStringLiteral("=3")})
                    .error()
                    .detail);
        };
        QStringList notes;
        for (const Use& use : intubateCommand().uses)
            for (const Note& note : use.notes)
                notes += QString::fromUtf8(note.help);
        const QString refused = told(QStringLiteral("cough"));
        for (const MotionAct act : kToldActs) {
            const QString word = toldWord(act);
            QVERIFY2(refused.contains(word), qPrintable(refused));
            QVERIFY(!notes.filter(word).isEmpty());
            QVERIFY(!told(word).contains(QStringLiteral("STEP=S"))); // it has no poses
        }
    }

    void refusesBadArguments_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QByteArray>("named");
        const auto row = [](const char* name, const char* words, const char* named) {
            QTest::newRow(name) << QString::fromLatin1(words) << QByteArray{named};
        };
        row("seed", "--seed 3", "--seed with one motion");
        row("saved", "--save a.csv", "--save with one motion");
        row("elastic", "--elastic", "--elastic with motions");
        row("no step", "--told cough=3", "STEP=S");
        row("no time", "--told first_breath=soon", "STEP=S");
        row("no blade", "--blade sharp", "macintosh-3");
        row("no poses", "", "poses.csv");
    }
    void refusesBadArguments()
    {
        QFETCH(QString, words);
        QFETCH(QByteArray, named);
        const test::ScratchFolder folder;
        const QString file = folder.write("poses.csv", "# carina.poses/1\n");
        const auto printed = intubateCommand().run(
            QStringList{file} + words.split(QLatin1Char(' '), Qt::SkipEmptyParts));
        QVERIFY(!printed);
        const QByteArray detail = QByteArray::fromStdString(printed.error().detail);
        QVERIFY2(detail.contains(named), detail.constData());
    }
};

CARINA_TEST(TestRecordedIntubation)

} // namespace carina::lab::recorded_intubation_test

#include "tst_recorded_intubation.moc"
