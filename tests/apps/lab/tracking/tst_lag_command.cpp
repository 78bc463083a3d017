#include "apps/lab/commands.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QTemporaryDir>

#include <cmath>
#include <fstream>

namespace carina::lab::lag_command_test
{
namespace
{

/// A body that turns to and fro about y, stamped so much later.
QString recordingIn(const QTemporaryDir& folder, const QString& name, double rate_Hz, double late_s,
                    char apart = ' ')
{
    const QString path = folder.filePath(name);
    std::ofstream file{path.toStdString()};
    file.precision(16);
    file << "# seconds x y z qx qy qz qw\n";
    for (int i = 0; i < 20 * rate_Hz; ++i) {
        const double t = i / rate_Hz;
        const double turn = 0.5 * std::sin(3.1 * t) + 0.3 * std::sin(4.7 * t + 1.0);
        for (const double number :
             {1700000000.0 + t + late_s, 0.0, 0.0, 0.0, 0.0, std::sin(turn / 2), 0.0})
            file << number << apart;
        file << std::cos(turn / 2) << '\n';
    }
    return path;
}

double number(const QJsonObject& object, const char* key)
{
    return object[QLatin1StringView{key}].toDouble(std::nan(""));
}

} // namespace

class LagCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsHowMuchLaterTheSecondStamps()
    {
        const QTemporaryDir folder;
        const QString one = recordingIn(folder, QStringLiteral("one.txt"), 60.0, 0.0);
        const QString other = recordingIn(folder, QStringLiteral("other.txt"), 45.0, 0.083, '\t');
        const auto object = lagCommand().run({one, other});
        QVERIFY(object);
        QVERIFY(std::abs(number(*object, "lag_ms") - 83.0) < 1.0);
        QVERIFY(number(*object, "correlation") > 0.99);
    }

    /// A robot that replays a head's motion, by its own account at 30 Hz and by a headset at 71 Hz:
    /// two clocks of one computer, which a person set by hand.
    void findsOneMotionInTwoRealRecordings()
    {
        const auto robot = test::testData("head-motion/traj1_tool1_gt_cut.txt");
        const auto headset = test::testData("head-motion/traj1_quest2_to_tool1_cut.txt");
        if (!robot || !headset)
            QSKIP("head-motion is not there");
        const auto object = lagCommand().run(
            {QString::fromStdString(robot->string()), QString::fromStdString(headset->string())});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QVERIFY(number(*object, "correlation") > 0.9);
        QVERIFY(std::abs(number(*object, "lag_ms")) < 200.0);
    }

    void refusesWhatItCannotCompare()
    {
        const QTemporaryDir folder;
        const QString one = recordingIn(folder, QStringLiteral("one.txt"), 60.0, 0.0);
        const QString later = recordingIn(folder, QStringLiteral("later.txt"), 60.0, 3e6);
        QVERIFY(!lagCommand().run({one}));
        QVERIFY(!lagCommand().run({one, later}));
        QVERIFY(!lagCommand().run({one, folder.filePath(QStringLiteral("none.txt"))}));
        QVERIFY(!lagCommand().run({one, one, QStringLiteral("--most-ms"), QStringLiteral("9000")}));
    }
};

CARINA_TEST(LagCommandTest)

} // namespace carina::lab::lag_command_test

#include "tst_lag_command.moc"
