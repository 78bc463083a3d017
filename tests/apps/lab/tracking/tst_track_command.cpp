#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "tests/engine/tracking/sequence_text.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QFile>
#include <QJsonArray>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <fstream>

namespace carina::lab::track_command_test
{
namespace
{

constexpr double kTolerance_mm = 1e-9;

Result<QJsonObject> track(const QString& path)
{
    return trackCommand().run({QStringLiteral("--recording"), path});
}

double number(const QJsonObject& object, const char* key)
{
    return object[QLatin1StringView{key}].toDouble(std::nan(""));
}

bool isNull(const QJsonObject& object, const char* key)
{
    return object[QLatin1StringView{key}].isNull();
}

QJsonArray corner(const QJsonObject& tool, const char* which)
{
    return tool[QStringLiteral("bounds_mm")][QLatin1StringView{which}].toArray();
}

/// What one tool of a file amounts to, read by regular expression.
struct FileTruth {
    int frames = 0;
    double way_mm = 0.0;
    std::array<double, 3> min{1e9, 1e9, 1e9};
    std::array<double, 3> max{-1e9, -1e9, -1e9};
};

FileTruth truthOf(const QString& text, const QString& tool)
{
    FileTruth truth;
    std::array<double, 3> last{};
    const QRegularExpression pose{QStringLiteral("_%1ToTrackerTransform = ([^\\n]*)").arg(tool)};
    for (auto matches = pose.globalMatch(text); matches.hasNext();) {
        const QStringList words = matches.next().captured(1).simplified().split(QLatin1Char{' '});
        const std::array<double, 3> p{words[3].toDouble(), words[7].toDouble(),
                                      words[11].toDouble()};
        for (std::size_t i = 0; i < 3; ++i) {
            truth.min[i] = std::min(truth.min[i], p[i]);
            truth.max[i] = std::max(truth.max[i], p[i]);
        }
        if (truth.frames++ > 0)
            truth.way_mm += std::hypot(p[0] - last[0], p[1] - last[1], p[2] - last[2]);
        last = p;
    }
    return truth;
}

} // namespace

class TrackCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void describesEachTool()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("take.igs.mha"));
        std::ofstream{path.toStdString()} << test::SequenceText{}
                                                 .frame("9.9")
                                                 .tool("Stylus", "", "MISSING")
                                                 .tool("Reference", "", "MISSING")
                                                 .frame("10")
                                                 .toolAt("Stylus", "0", "0", "-1000")
                                                 .tool("Reference", "", "MISSING")
                                                 .frame("10.1")
                                                 .toolAt("Stylus", "3", "4", "-1000")
                                                 .tool("Reference", "", "MISSING")
                                                 .frame("10.2")
                                                 .tool("Stylus", "", "MISSING")
                                                 .tool("Reference", "", "MISSING")
                                                 .frame("10.4")
                                                 .toolAt("Stylus", "-7", "50", "-1000")
                                                 .tool("Reference", "", "MISSING")
                                                 .frame("10.5")
                                                 .toolAt("Stylus", "-7", "50", "-999")
                                                 .tool("Reference", "", "MISSING")
                                                 .text();
        const Result<QJsonObject> object = track(path);
        QVERIFY(object);
        QCOMPARE((*object)[QStringLiteral("schema")].toString(), QStringLiteral("carina.track/1"));
        QCOMPARE((*object)[QStringLiteral("recording")].toString(), path);
        const QJsonArray tools = (*object)[QStringLiteral("tools")].toArray();
        QCOMPARE(tools.size(), 2);
        const QJsonObject stylus = tools[0].toObject();
        QCOMPARE(stylus[QStringLiteral("name")].toString(), QStringLiteral("Stylus"));
        QCOMPARE(number(stylus, "samples"), 6.0);
        QCOMPARE(number(stylus, "tracked"), 4.0);
        QCOMPARE(number(stylus, "lost"), 2.0);
        QCOMPARE(number(stylus, "duration_s"), 0.5);
        QCOMPARE(number(stylus, "rate_hz"), 8.0);
        QCOMPARE(number(stylus, "mean_step_mm"), 3.0); // 5 mm and 1 mm; not across the loss
        QCOMPARE(number(stylus, "max_gap_ms"), 300.0);
        QCOMPARE(corner(stylus, "min"), (QJsonArray{-7.0, 0.0, -1000.0}));
        QCOMPARE(corner(stylus, "max"), (QJsonArray{3.0, 50.0, -999.0}));
        const QJsonObject reference = tools[1].toObject();
        QCOMPARE(number(reference, "samples"), 6.0);
        QCOMPARE(number(reference, "tracked"), 0.0);
        QCOMPARE(number(reference, "lost"), 6.0);
        for (const char* key : {"rate_hz", "mean_step_mm", "max_gap_ms", "bounds_mm"})
            QVERIFY2(isNull(reference, key), key);
    }

    void describesRealRecordings_data()
    {
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("rateHz"); // of the published description
        QTest::newRow("eight landmarks") << QString::fromLatin1(test::kEightDivots) << 15.0;
    }
    void describesRealRecordings()
    {
        QFETCH(QString, file);
        QFETCH(double, rateHz);
        const auto path = test::testData(file.toStdString());
        if (!path)
            QSKIP(qPrintable(QStringLiteral("absent: ") + file));
        const QString name = QString::fromStdString(path->string());
        QFile bytes{name};
        QVERIFY(bytes.open(QIODevice::ReadOnly));
        const QString text = QString::fromLatin1(bytes.readAll());
        const Result<QJsonObject> object = track(name);
        QVERIFY(object);
        for (const QJsonValue& value : (*object)[QStringLiteral("tools")].toArray()) {
            const QJsonObject tool = value.toObject();
            const FileTruth truth = truthOf(text, tool[QStringLiteral("name")].toString());
            QCOMPARE(number(tool, "samples"), double(truth.frames));
            QCOMPARE(number(tool, "lost"), 0.0);
            QVERIFY(std::abs(number(tool, "rate_hz") / rateHz - 1.0) < 0.01);
            QVERIFY(std::abs(number(tool, "mean_step_mm") - truth.way_mm / (truth.frames - 1))
                    < kTolerance_mm);
            for (int i = 0; i < 3; ++i) {
                const auto axis = static_cast<std::size_t>(i);
                QVERIFY(std::abs(corner(tool, "min")[i].toDouble() - truth.min[axis])
                        < kTolerance_mm);
                QVERIFY(std::abs(corner(tool, "max")[i].toDouble() - truth.max[axis])
                        < kTolerance_mm);
            }
        }
    }

    void writesARecordingInAnotherForm()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("one.tum"));
        std::ofstream{path.toStdString()} << "0 0.1 0 0 0 0 0 1\n0.5 0.3 0 0 0 0 0 1\n";
        for (const char* name : {"one.csv", "one.igs.mha", "again.tum"}) {
            const QString saved = folder.filePath(QLatin1StringView{name});
            QVERIFY(trackCommand().run(
                {QStringLiteral("--recording"), path, QStringLiteral("--save"), saved}));
            const auto object = track(saved);
            QVERIFY2(object, object ? "" : object.error().detail.c_str());
            const QJsonObject tool = (*object)[QStringLiteral("tools")].toArray()[0].toObject();
            QCOMPARE(tool[QStringLiteral("samples")].toInt(), 2);
            QVERIFY(std::abs(number(tool, "mean_step_mm") - 200.0) < 1e-5);
        }
        const auto refused =
            trackCommand().run({QStringLiteral("--recording"), path, QStringLiteral("--save"),
                                folder.filePath(QStringLiteral("one.xyz"))});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, Errc::UnknownFormat);
    }

    void refusesWhatItCannotDo_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<Errc>("code");
        const QString recording = QStringLiteral("--recording");
        QTest::newRow("no flag") << QStringList{} << Errc::WrongOption;
        QTest::newRow("no file named") << QStringList{recording} << Errc::WrongOption;
        QTest::newRow("another flag")
            << QStringList{QStringLiteral("--file"), QStringLiteral("a")} << Errc::WrongOption;
        QTest::newRow("more words")
            << QStringList{recording, QStringLiteral("a"), QStringLiteral("b")}
            << Errc::WrongOption;
        QTest::newRow("no such file")
            << QStringList{recording, QStringLiteral("nowhere.igs.mha")} << Errc::FileNotFound;
    }
    void refusesWhatItCannotDo()
    {
        QFETCH(QStringList, words);
        QFETCH(Errc, code);
        const Result<QJsonObject> object = trackCommand().run(words);
        QVERIFY(!object);
        QCOMPARE(object.error().code, code);
    }

    void namesEveryKeyInItsHelp()
    {
        for (const char* key :
             {"--recording", "--save", "schema", "recording", "tools", "name", "samples", "tracked",
              "lost", "duration_s", "rate_hz", "mean_step_mm", "max_gap_ms", "bounds_mm"})
            QVERIFY2(pageOf(trackCommand()).contains(QLatin1StringView{key}), key);
    }
};

CARINA_TEST(TrackCommandTest)

} // namespace carina::lab::track_command_test

#include "tst_track_command.moc"
