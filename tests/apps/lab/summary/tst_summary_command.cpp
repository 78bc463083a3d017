#include "apps/lab/commands.h"
#include "models/station/frame_log.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QJsonObject>

namespace carina::summary_command_test
{
namespace
{

constexpr std::chrono::milliseconds kEach{20}; ///< of frames
constexpr int kFrames = 100;

/// Frames of a tube that rests, or of one of which no sample came.
std::vector<LoggedFrame> frames(bool isTracked)
{
    std::vector<LoggedFrame> all;
    for (int i = 0; i < kFrames; ++i) {
        LoggedFrame frame;
        frame.local = LocalTime{i * kEach};
        frame.session = SessionTime{i * kEach};
        if (isTracked) {
            frame.X_AE = RigidTransform{};
            frame.sampleAge = std::chrono::milliseconds{5};
        }
        all.push_back(frame);
    }
    return all;
}

/// The summary of a demo, in which the console and the trainee drew these.
QJsonObject summaryOf(const std::vector<LoggedFrame>& console,
                      const std::vector<LoggedFrame>& trainee)
{
    const test::ScratchFolder folder;
    folder.write("instructor.json", "{}");
    folder.write("trainee.json", "{}");
    const bool isWritten =
        writeFrames(folder.filePath("instructor_frames.csv"), console).has_value()
        && writeFrames(folder.filePath("trainee_frames.csv"), trainee).has_value();
    const auto summary = lab::summaryCommand().run({folder.path()});
    if (!summary)
        qWarning("%s", summary.error().detail.c_str());
    return isWritten ? summary.value_or(QJsonObject{}) : QJsonObject{};
}

QJsonObject in(const QJsonObject& object, const char* key)
{
    return object[QLatin1StringView{key}].toObject();
}

constexpr std::array kDrifts{"mean_deg", "p95_deg", "largest_deg",
                             "mean_mm",  "p95_mm",  "largest_mm"};

} // namespace

class TestSummaryCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsWhatWasCompared()
    {
        const QJsonObject summary = summaryOf(frames(true), frames(true));
        const QJsonObject drift = in(summary, "drift");
        QVERIFY(drift[QStringLiteral("instants")].toInt() > kFrames / 2);
        for (const char* figure : kDrifts)
            QCOMPARE(drift[QLatin1StringView{figure}].toDouble(-1.0), 0.0);
        QCOMPARE(in(in(summary, "trainee"), "tracker_sample_age")[QStringLiteral("median_ms")],
                 QJsonValue{5.0});
        QVERIFY(summary[QStringLiteral("warnings")].toArray().isEmpty());
    }

    /// What nobody measured is not 0.
    void hasNoFigureOfATubeThatNeverCame()
    {
        const QJsonObject summary = summaryOf(frames(true), frames(false));
        const QJsonObject drift = in(summary, "drift");
        QCOMPARE(drift[QStringLiteral("instants")].toInt(-1), 0);
        for (const char* figure : kDrifts)
            QVERIFY2(drift[QLatin1StringView{figure}].isNull(), figure);
        QVERIFY(drift[QStringLiteral("clock_mean_ms")].isDouble()); // both drew all the time
        QVERIFY(in(summary, "trainee")[QStringLiteral("tracker_sample_age")].isNull());
        const QJsonArray told = summary[QStringLiteral("warnings")].toArray();
        QCOMPARE(told.size(), 2);
        QVERIFY(told[0].toString().startsWith(QStringLiteral("No sample of the tube came")));
    }

    void hasNoFigureWithoutFrames()
    {
        const QJsonObject summary = summaryOf(frames(true), {});
        QVERIFY(in(summary, "drift")[QStringLiteral("clock_mean_ms")].isNull());
        const QJsonObject volumes = in(in(summary, "lung_volume_difference"), "same_session_time");
        QVERIFY(volumes[QStringLiteral("mean_ml")].isNull());
    }
};

CARINA_TEST(TestSummaryCommand)

} // namespace carina::summary_command_test

#include "tst_summary_command.moc"
