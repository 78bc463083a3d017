#include "bench/repeated_times.h"

#include "tests/support/test_class.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace carina::repeated_times_test
{

class TestRepeatedTimes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Of three calls of 1 ns and one of 9 ns: a repetition that was delayed counts.
    void theMeanIsThatOfAllCalls()
    {
        const RepeatedTimes times = timesOf({{9.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}});
        QCOMPARE(times.mean_ns, 3.0);
        QCOMPARE(times.median_ns, 1.0);
    }

    void ofOneRepetitionBothAreItsOwn()
    {
        const RepeatedTimes times = timesOf({{5.0, 1000.0}});
        QCOMPARE(times.mean_ns, 5.0);
        QCOMPARE(times.median_ns, 5.0);
    }

    /// A marker pose is to take less than 3 microseconds on the mean.
    void theGoalOfAMarkerPoseIsAboutTheMean()
    {
        QFile file{QStringLiteral(CARINA_SOURCE_DIR "/bench/goals.json")};
        QVERIFY(file.open(QIODevice::ReadOnly));
        int held = 0;
        for (const QJsonValue& each : QJsonDocument::fromJson(file.readAll()).array()) {
            const QJsonObject goal = each.toObject();
            if (goal[QStringLiteral("benchmark")].toString() != QStringLiteral("marker_pose")
                || !goal.contains(QStringLiteral("most")))
                continue;
            QCOMPARE(goal[QStringLiteral("figure")].toString(), QStringLiteral("carina.mean_us"));
            QCOMPARE(goal[QStringLiteral("most")].toDouble(), 3.0);
            ++held;
        }
        QCOMPARE(held, 1);
    }
};

CARINA_TEST(TestRepeatedTimes)

} // namespace carina::repeated_times_test

#include "tst_repeated_times.moc"
