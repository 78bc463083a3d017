#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "engine/sync/strategies/strategy.h"
#include "evaluation/network/drift_scenario.h"
#include "tests/support/test_class.h"

#include <QJsonDocument>

#include <algorithm>

namespace carina::lab::drift_command_test
{
namespace
{

Result<QJsonObject> drift(const char* words)
{
    return driftCommand().run(QString::fromLatin1(words).split(QLatin1Char{' '}));
}

constexpr const char* kQuick = "--scenario wan --actions 3 --speed-deg-s 97.3 --seed 4";

} // namespace

class DriftCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void reportsEveryFigure()
    {
        const auto object = drift(kQuick);
        QVERIFY(object);
        QCOMPARE(object->value(QLatin1StringView{"schema"}).toString(),
                 QStringLiteral("carina.drift/1"));
        QCOMPARE(object->value(QLatin1StringView{"strategy"}).toString(),
                 QStringLiteral("session-clock"));
        QCOMPARE(object->value(QLatin1StringView{"participants"}).toInt(), 2);
        QVERIFY(std::abs(object->value(QLatin1StringView{"speed_deg_s"}).toDouble() - 97.3)
                < 1e-12);
        QCOMPARE(object->value(QLatin1StringView{"actions"}).toInt(), 3);
        QCOMPARE(object->value(QLatin1StringView{"action_s"}).toDouble(), 1.2);
        QCOMPARE(object->value(QLatin1StringView{"axes"}).toString(), QStringLiteral("cartesian"));
        QCOMPARE(object->value(QLatin1StringView{"scenario"}).toString(), QStringLiteral("wan"));
        QCOMPARE(object->value(QLatin1StringView{"seed"}).toInt(), 4);
        QCOMPARE(object->value(QLatin1StringView{"seeds"}).toInt(), 1);
        const QJsonObject access = object->value(QLatin1StringView{"access_link"}).toObject();
        for (const char* key : {"at_event_mean_deg", "time_average_mean_deg", "p95_deg",
                                "position_mean_mm", "limit_time_average_deg", "ratio_to_limit",
                                "clock_error_ms", "bytes_per_s", "probes_per_s"}) {
            QVERIFY2(object->value(QLatin1StringView{key}).isDouble(), key);
            QVERIFY2(access[QLatin1StringView{key}].isDouble(), key);
        }
        const auto limit = [](const QJsonObject& of) {
            return of[QLatin1StringView{"limit_time_average_deg"}].toDouble();
        };
        QVERIFY(std::abs(limit(access) / limit(*object) - 4.0) < 0.3);
        QVERIFY(std::abs(object->value(QLatin1StringView{"ratio_to_limit"}).toDouble()
                         - object->value(QLatin1StringView{"time_average_mean_deg"}).toDouble()
                               / limit(*object))
                < 1e-12);
    }

    void sameWordsSameBytes()
    {
        QCOMPARE(QJsonDocument{*drift(kQuick)}.toJson(), QJsonDocument{*drift(kQuick)}.toJson());
    }

    void seedsAreAveraged()
    {
        const auto one = [](int seed) {
            const QByteArray words =
                "--scenario wan --actions 2 --seed " + QByteArray::number(seed);
            return drift(words.constData())
                ->value(QLatin1StringView{"time_average_mean_deg"})
                .toDouble();
        };
        const auto two = drift("--scenario wan --actions 2 --seed 1 --seeds 2");
        QVERIFY(std::abs(two->value(QLatin1StringView{"time_average_mean_deg"}).toDouble()
                         - 0.5 * (one(1) + one(2)))
                < 1e-12);
    }

    void hasNoClockErrorWithoutAClock()
    {
        const auto object = drift("--scenario lan --actions 2 --strategy event");
        QVERIFY(object->value(QLatin1StringView{"clock_error_ms"}).isNull());
    }

    void lagIsBounded()
    {
        // The path takes 8.5 ms on average; a lag that does not cover it is used up whole.
        const auto object = drift("--scenario metro --actions 3 --strategy local-lag "
                                  "--local-lag-ms 5");
        QCOMPARE(object->value(QLatin1StringView{"local_lag_ms"}).toDouble(), 5.0);
        const double response_ms = object->value(QLatin1StringView{"response_ms"}).toDouble();
        QVERIFY2(std::abs(response_ms - 5.0) < 0.1, qPrintable(QString::number(response_ms)));
    }

    void lostActionsAreCounted()
    {
        const auto of = [](const char* words, const char* key) {
            return drift(words)->value(QLatin1StringView{key}).toDouble();
        };
        constexpr const char* kEvent = "--strategy event --actions 20 --scenario burst";
        QVERIFY(of(kEvent, "lost_actions") > 0.0);
        QVERIFY(of(kEvent, "time_average_shown_deg") < of(kEvent, "time_average_mean_deg"));
        constexpr const char* kRepeated = "--actions 20 --scenario burst";
        QCOMPARE(of(kRepeated, "lost_actions"), 0.0);
        QCOMPARE(of(kRepeated, "time_average_shown_deg"), of(kRepeated, "time_average_mean_deg"));
    }

    void takesRandomAxes()
    {
        const auto random = drift("--scenario wan --actions 2 --axes random");
        QCOMPARE(random->value(QLatin1StringView{"axes"}).toString(), QStringLiteral("random"));
        QVERIFY(random->value(QLatin1StringView{"limit_time_average_deg"})
                != drift("--scenario wan --actions 2")
                       ->value(QLatin1StringView{"limit_time_average_deg"}));
    }

    void refusesWhatItDoesNotUnderstand_data()
    {
        QTest::addColumn<QByteArray>("words");
        QTest::addColumn<QByteArray>("named");
        QTest::newRow("nothing") << QByteArray{""} << QByteArray{"does not take"};
        QTest::newRow("no scenario") << QByteArray{"--seed 1"} << QByteArray{"--scenario"};
        QTest::newRow("unknown option") << QByteArray{"--walk yes"} << QByteArray{"--walk"};
        QTest::newRow("17 live participants")
            << QByteArray{"--live --scenario lan --participants 17"} << QByteArray{"2 to 16"};
        QTest::newRow("two live seeds")
            << QByteArray{"--scenario lan --live --seeds 2"} << QByteArray{"one seed"};
        QTest::newRow("endless warm-up")
            << QByteArray{"--scenario lan --live --warm-up-s 301"} << QByteArray{"--warm-up-s"};
        QTest::newRow("twice") << QByteArray{"--scenario lan --seed 1 --seed 2"}
                               << QByteArray{"drift has --seed twice."};
        QTest::newRow("an option for a value")
            << QByteArray{"--scenario --seed 1"}
            << QByteArray{"drift needs a value for --scenario, not --seed."};
        QTest::newRow("logs of nothing")
            << QByteArray{"--scenario lan --logs x"} << QByteArray{"--logs goes with --live"};
        QTest::newRow("logs where no folder can be")
            << QByteArray{"--scenario lan --live --logs /dev/null/x"}
            << QByteArray{"--logs /dev/null/x"};
        QTest::newRow("a table in virtual time")
            << QByteArray{"--table"} << QByteArray{"--table goes with --live"};
        QTest::newRow("logs of a table")
            << QByteArray{"--live --table --logs x"} << QByteArray{"without --logs"};
        QTest::newRow("a table of 17 participants")
            << QByteArray{"--live --table --participants 17"} << QByteArray{"2 to 16"};
        QTest::newRow("a table of an unknown scenario")
            << QByteArray{"--live --table --scenario moon"} << QByteArray{"moon is neither"};
        QTest::newRow("lag of more than 100 ms")
            << QByteArray{"--scenario lan --local-lag-ms 100.1"} << QByteArray{"--local-lag-ms"};
        QTest::newRow("no value") << QByteArray{"--scenario"} << QByteArray{"--scenario"};
        QTest::newRow("unknown strategy")
            << QByteArray{"--scenario lan --strategy best"} << QByteArray{"--strategy"};
        QTest::newRow("one participant")
            << QByteArray{"--scenario lan --participants 1"} << QByteArray{"--participants"};
        QTest::newRow("65 participants")
            << QByteArray{"--scenario lan --participants 65"} << QByteArray{"--participants"};
        QTest::newRow("no speed") << QByteArray{"--scenario lan --speed-deg-s 0"}
                                  << QByteArray{"--speed-deg-s"};
        QTest::newRow("no number")
            << QByteArray{"--scenario lan --speed-deg-s nan"} << QByteArray{"--speed-deg-s"};
        QTest::newRow("no actions")
            << QByteArray{"--scenario lan --actions 0"} << QByteArray{"--actions"};
        QTest::newRow("negative seed")
            << QByteArray{"--scenario lan --seed -1"} << QByteArray{"--seed"};
        QTest::newRow("no seeds") << QByteArray{"--scenario lan --seeds 0"}
                                  << QByteArray{"--seeds"};
        QTest::newRow("unknown axes")
            << QByteArray{"--scenario lan --axes polar"} << QByteArray{"--axes"};
        QTest::newRow("unknown scenario")
            << QByteArray{"--scenario moon"} << QByteArray{"moon is neither"};
    }
    void refusesWhatItDoesNotUnderstand()
    {
        QFETCH(QByteArray, words);
        QFETCH(QByteArray, named);
        const auto object = drift(words.constData());
        QVERIFY(!object);
        QVERIFY2(object.error().detail.find(named.toStdString()) != std::string::npos,
                 object.error().detail.c_str());
    }

    void listsTheScenariosForAWrongName_data()
    {
        QTest::addColumn<QByteArray>("words");
        QTest::newRow("one scenario") << QByteArray{"--scenario moon"};
        QTest::newRow("a table") << QByteArray{"--live --table --scenario moon"};
    }
    void listsTheScenariosForAWrongName()
    {
        QFETCH(const QByteArray, words);
        const auto object = drift(words.constData());
        QVERIFY(!object);
        const std::string& told = object.error().detail;
        const std::string list = told.substr(std::min(told.find("scenarios "), told.size()));
        for (const std::string_view name : scenarioNames())
            QVERIFY2(list.find(name) != list.npos, name.data());
    }

    void helpNamesEveryStrategyAndScenario()
    {
        const std::string help = pageOf(driftCommand()).toStdString();
        for (const SyncStrategy& strategy : syncStrategies())
            QVERIFY2(help.find(strategy.name) != help.npos, strategy.name.data());
        for (const std::string_view name : scenarioNames())
            QVERIFY2(help.find(name) != help.npos, name.data());
    }
};

CARINA_TEST(DriftCommandTest)

} // namespace carina::lab::drift_command_test

#include "tst_drift_command.moc"
