#include "engine/io/site/devices/tracker_file.h"
#include "engine/net/devices/any_recording.h"
#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QJsonArray>
#include <QTcpServer>
#include <QTemporaryDir>

#include <algorithm>

namespace carina::polaris_test
{
namespace
{

constexpr qint64 kBack_ns = 2'000'000'000;

/// A place registered by a pure shift.
const QByteArray kSite = R"({"schema": "carina.site/2", "step": "overview",
 "catalogue": {"name": "three", "landmarks": [{"name": "a", "p_AQ_mm": [0, 0, 1]},
  {"name": "b", "p_AQ_mm": [0, 1, 0]}, {"name": "c", "p_AQ_mm": [1, 0, 0]}]},
 "registration": {"X_AM_mm": [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]],
  "X_AT_mm": [[1, 0, 0, 10], [0, 1, 0, 20], [0, 0, 1, 30], [0, 0, 0, 1]],
  "rms_mm": 0.1, "residuals_mm": [{"name": "a", "mm": 0.1}]}})";

/// The simulated device, a program of its own at a TCP port. It is ready once it has written its
/// description.
class Device
{
public:
    Device(QString folder, bool isSerial) : m_folder{std::move(folder)}
    {
        if (isSerial)
            return;
        QTcpServer free;
        free.listen(QHostAddress::LocalHost);
        m_port = free.serverPort();
    }
    ~Device() { kill(); }

    void start()
    {
        QFile::remove(description());
        m_process.start(
            QStringLiteral(CARINA_LAB),
            QStringList{QStringLiteral("polaris-sim"), m_folder, QStringLiteral("--seconds"),
                        QStringLiteral("600")}
                + (m_port == 0 ? QStringList{}
                               : QStringList{QStringLiteral("--tcp"), QString::number(m_port)}));
        QVERIFY(m_process.waitForStarted());
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(description()), kPatience_ms);
    }
    void kill()
    {
        m_process.kill();
        m_process.waitForFinished();
    }
    [[nodiscard]] QString description() const
    {
        return QDir{m_folder}.filePath(QStringLiteral("tracker.json"));
    }
    [[nodiscard]] QString address() const
    {
        return m_port == 0 ? QDir{m_folder}.filePath(QStringLiteral("port"))
                           : QStringLiteral("127.0.0.1:%1").arg(m_port);
    }

private:
    QString m_folder;
    quint16 m_port = 0; ///< 0: at a pseudo-terminal
    QProcess m_process;
};

qint64 timeOf(const QJsonObject& shown) { return shown[QStringLiteral("session_ns")].toInteger(); }

/// The time of the first frame after `since` that has a tool of this program; 0 where none has.
qint64 firstTracked(const QJsonObject& line, qint64 since)
{
    for (const QJsonValue& frame : line[QStringLiteral("frames")].toArray())
        for (const QJsonValue& object : frame[QStringLiteral("objects")].toArray())
            if (object[QStringLiteral("own")].toBool() && timeOf(frame.toObject()) > since)
                return timeOf(frame.toObject());
    return 0;
}

/// The names of the tools that a device is described to track.
std::vector<std::string> toolsOf(const Device& device)
{
    std::vector<std::string> names;
    if (const auto described = readTrackerFile(device.description().toStdString()))
        for (const DescribedTool& tool : described->tools)
            names.push_back(tool.name);
    return names;
}

/// The first time after `since` at which a tool is tracked by a record of poses, which may still be
/// written; 0 where it is not.
qint64 firstTracked(const TrackerSequence& record, const std::string& name, qint64 since)
{
    const auto tool = std::ranges::find(record.tools, name, &RecordedTool::name);
    if (tool == record.tools.end())
        return 0;
    const auto isLater = [since](const PoseSample& sample) {
        return sample.validity != Validity::Lost && sample.time.time_since_epoch().count() > since;
    };
    const auto first = std::ranges::find_if(tool->samples, isLater);
    return first == tool->samples.end() ? 0 : first->time.time_since_epoch().count();
}

} // namespace

/// A trainee whose tracker is a Polaris. Each of its tools is looked for by its name in the record
/// of poses, also one that is not drawn; that tools are drawn is looked for in the journal.
class TestPolaris : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tracksAgainSoonAfterTheDeviceIsBack_data()
    {
        QTest::addColumn<bool>("isSerial");
        QTest::newRow("on the network") << false;
        QTest::newRow("at a serial port") << true;
    }

    void tracksAgainSoonAfterTheDeviceIsBack()
    {
        QFETCH(const bool, isSerial);
        const QTemporaryDir folder;
        const QString codes = folder.filePath(QStringLiteral("codes"));
        const QString site = folder.filePath(QStringLiteral("site.json"));
        QFile written{site};
        QVERIFY(written.open(QIODevice::WriteOnly) && written.write(kSite) == kSite.size());
        written.close();
        const QString record = folder.filePath(QStringLiteral("poses.csv"));
        Device device{folder.filePath(QStringLiteral("device")), isSerial};
        device.start();
        const std::vector<std::string> tools = toolsOf(device);
        QCOMPARE(tools, (std::vector<std::string>{"head", "jaw", "tube", "stylus"}));
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
                         QStringLiteral("--site"), site, QStringLiteral("--tracker"),
                         device.description(), QStringLiteral("--record"), record},
                        folder.filePath(QStringLiteral("trainee.jsonl"))};
        trainee.start();
        QTRY_VERIFY_WITH_TIMEOUT(firstTracked(trainee.shown(), 0) != 0, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(notTracked(tools, record, 0), QString{}, kPatience_ms);

        device.kill();
        QTRY_VERIFY_WITH_TIMEOUT(isLost(trainee.shown(), device), kPatience_ms);
        device.start();
        const qint64 back = timeOf(trainee.shown());
        QTRY_VERIFY_WITH_TIMEOUT(trackedSince(trainee, back) != 0, kPatience_ms);
        const qint64 passed = trackedSince(trainee, back) - back;
        QVERIFY2(passed <= kBack_ns, qPrintable(QString::number(1e-9 * double(passed))));
        QTRY_COMPARE_WITH_TIMEOUT(notTracked(tools, record, back), QString{}, kPatience_ms);
        const auto recorded = readAnyRecording(record.toStdString());
        QVERIFY2(recorded, recorded ? "" : recorded.error().detail.c_str());
        for (const std::string& tool : tools) {
            const qint64 toolPassed = firstTracked(*recorded, tool, back) - back;
            QVERIFY2(toolPassed <= kBack_ns,
                     (tool + ": " + std::to_string(1e-9 * double(toolPassed))).c_str());
        }
    }

private:
    /// No tool is drawn, and the picture says why.
    static bool isLost(const QJsonObject& shown, const Device& device)
    {
        return !shown.isEmpty() && firstTracked(shown, 0) == 0
               && shown[QStringLiteral("notice")].toString().contains(device.address());
    }

    /// Which of the tools are not tracked after `since` by the record; "head jaw".
    static QString notTracked(const std::vector<std::string>& tools, const QString& record,
                              qint64 since)
    {
        const auto recorded = readAnyRecording(record.toStdString());
        QStringList missing;
        for (const std::string& tool : tools)
            if (!recorded || firstTracked(*recorded, tool, since) == 0)
                missing << QString::fromStdString(tool);
        return missing.join(QLatin1Char{' '});
    }

    /// By the trainee's journal, all lines.
    static qint64 trackedSince(const Program& trainee, qint64 since)
    {
        for (const QJsonObject& line : trainee.allShown())
            if (const qint64 tracked = firstTracked(line, since); tracked != 0)
                return tracked;
        return 0;
    }
};

CARINA_TEST(TestPolaris)

} // namespace carina::polaris_test

#include "tst_polaris.moc"
