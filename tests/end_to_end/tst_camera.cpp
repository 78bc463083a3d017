#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QJsonArray>
#include <QTemporaryDir>

namespace carina::camera_test
{
namespace
{

constexpr int kPatience_ms = 90'000;

/// Whether a tool of this program is drawn in one of the frames of a line.
bool hasOwnTool(const QJsonObject& line)
{
    for (const QJsonValue& frame : line[QStringLiteral("frames")].toArray())
        for (const QJsonValue& object : frame[QStringLiteral("objects")].toArray())
            if (object[QStringLiteral("own")].toBool())
                return true;
    return false;
}

} // namespace

/// A trainee whose tracker is a video of markers.
class TestCamera : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tracksTheToolsOfAVideo()
    {
        const QTemporaryDir folder;
        QProcess rendering;
        rendering.start(QStringLiteral(CARINA_LAB),
                        {QStringLiteral("camera"), QStringLiteral("video"), folder.path(),
                         QStringLiteral("--seconds"), QStringLiteral("3"), QStringLiteral("--rate"),
                         QStringLiteral("10"), QStringLiteral("--width"), QStringLiteral("640")});
        QVERIFY(rendering.waitForFinished(kPatience_ms) && rendering.exitCode() == 0);

        const QString codes = folder.filePath(QStringLiteral("codes"));
        Program instructor{QStringLiteral(CARINA_INSTRUCTOR),
                           {QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--data"),
                            folder.filePath(QStringLiteral("host")), QStringLiteral("--codes"),
                            codes, QStringLiteral("--start")},
                           folder.filePath(QStringLiteral("instructor.jsonl"))};
        instructor.start();
        QTRY_VERIFY_WITH_TIMEOUT(!instructor.shown().isEmpty(), kPatience_ms);
        Program trainee{QStringLiteral(CARINA_TRAINEE),
                        {QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--as"),
                         QStringLiteral("Trainee"), QStringLiteral("--code-file"), codes,
                         QStringLiteral("--data"), folder.filePath(QStringLiteral("trainee")),
                         QStringLiteral("--site"), folder.filePath(QStringLiteral("site.json")),
                         QStringLiteral("--tracker"),
                         folder.filePath(QStringLiteral("tracker.json"))},
                        folder.filePath(QStringLiteral("trainee.jsonl"))};
        trainee.start();
        QTRY_VERIFY_WITH_TIMEOUT(hasOwnTool(trainee.shown()), kPatience_ms);
    }
};

CARINA_TEST(TestCamera)

} // namespace carina::camera_test

#include "tst_camera.moc"
