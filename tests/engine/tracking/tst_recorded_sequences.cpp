#include "engine/tracking/sequence_file.h"

#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QFile>
#include <QHash>
#include <QRegularExpression>

namespace carina::recorded_sequences_test
{
namespace
{

constexpr double kLengthTolerance = 1e-12; // m: the same decimal digits, divided by 1000
constexpr double kTurnTolerance = 1e-3; // the matrices in the files are up to 5e-4 off a rotation
constexpr double kTimeTolerance = 1e-9; // s

/// What a file holds, by regular expression alone.
struct FileTruth {
    QHash<QString, std::vector<Eigen::Matrix4d>> poses; ///< millimetres, by tool
    std::vector<double> times;                          ///< seconds
};

FileTruth truthOf(const QString& path)
{
    QFile file{path};
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromLatin1(file.readAll());
    FileTruth truth;
    const QRegularExpression pose{QStringLiteral("^Seq_Frame\\d+_(\\w+)ToTrackerTransform = (.*)$"),
                                  QRegularExpression::MultilineOption};
    for (auto matches = pose.globalMatch(text); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        const QStringList words = match.captured(2).simplified().split(QLatin1Char{' '});
        Eigen::Matrix4d matrix;
        for (int i = 0; i < 16; ++i)
            matrix(i / 4, i % 4) = words[i].toDouble();
        truth.poses[match.captured(1)].push_back(matrix);
    }
    const QRegularExpression time{QStringLiteral("^Seq_Frame\\d+_Timestamp = (.*)$"),
                                  QRegularExpression::MultilineOption};
    for (auto matches = time.globalMatch(text); matches.hasNext();)
        truth.times.push_back(matches.next().captured(1).toDouble());
    return truth;
}

} // namespace

/// The reader of .igs.mha on files that others recorded.
class RecordedSequencesTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsEveryPoseOfARecording_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<int>("tools");
        QTest::addColumn<int>("frames");
        QTest::newRow("eight landmarks") << QString::fromLatin1(test::kEightDivots) << 2 << 1000;
        QTest::newRow("water tank")
            << QStringLiteral("tracker/watertank/"
                              "WaterTankBottomTranslationTrackerBuffer-trimmed.igs.mha")
            << 3 << 801;
    }
    void readsEveryPoseOfARecording()
    {
        QFETCH(QString, file);
        QFETCH(int, tools);
        QFETCH(int, frames);
        const auto path = test::testData(file.toStdString());
        if (!path)
            QSKIP(qPrintable(QStringLiteral("absent: ") + file));
        const FileTruth truth = truthOf(QString::fromStdString(path->string()));
        QCOMPARE(truth.poses.size(), qsizetype{tools});
        QCOMPARE(truth.times.size(), static_cast<std::size_t>(frames));

        const Result<TrackerSequence> sequence = readSequenceFile(*path);
        QVERIFY2(sequence, sequence ? "" : sequence.error().detail.c_str());
        QCOMPARE(sequence->tools.size(), static_cast<std::size_t>(tools));
        for (const RecordedTool& tool : sequence->tools) {
            const auto& poses = truth.poses[QString::fromStdString(tool.name)];
            QCOMPARE(tool.samples.size(), poses.size());
            for (std::size_t i = 0; i < poses.size(); ++i) {
                const PoseSample& sample = tool.samples[i];
                const Vec3 p_T = poses[i].topRightCorner<3, 1>() / 1000.0;
                const Mat3 turn = poses[i].topLeftCorner<3, 3>();
                QCOMPARE(sample.validity, Validity::Tracked);
                QVERIFY((sample.X_FO.translation() - p_T).norm() < kLengthTolerance);
                QVERIFY((sample.X_FO.matrix().topLeftCorner<3, 3>() - turn).cwiseAbs().maxCoeff()
                        < kTurnTolerance);
                QVERIFY(std::abs(toSeconds(sample.time.time_since_epoch()) - truth.times[i])
                        < kTimeTolerance);
            }
        }
    }
};

CARINA_TEST(RecordedSequencesTest)

} // namespace carina::recorded_sequences_test

#include "tst_recorded_sequences.moc"
