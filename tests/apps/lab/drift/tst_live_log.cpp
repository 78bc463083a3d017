#include "apps/lab/drift/live_log.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

namespace carina::lab::live_log_test
{
namespace
{

LiveLog logOfAll()
{
    const RigidTransform X_AO{Quat{0.5, 0.5, 0.5, 0.5}, Vec3{1.0, 2.0, 1.0 / 3.0}};
    LiveLog log;
    log.handshake = Duration{17};
    log.strategy = StrategyKind::None;
    log.samples = {{LocalTime{Duration{1}}, {}, {}, {}},
                   {LocalTime{Duration{(std::int64_t{1} << 52) + 1}},
                    SessionTime{Duration{(std::int64_t{1} << 51) + 3}}, X_AO, RigidTransform{}}};
    log.actions = {{LocalTime{Duration{5}}, LocalTime{Duration{6}}, LocalTime{Duration{7}},
                    Quat{0.5, -0.5, 0.5, 0.5}, Vec3{4.0, 5.0, 6.0}}};
    return log;
}

} // namespace

class LiveLogTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void comesBackToTheBit()
    {
        const LiveLog log = logOfAll();
        const auto back = liveLogFrom(toJson(log));
        QVERIFY(back);
        QCOMPARE(back->handshake, log.handshake);
        QCOMPARE(back->strategy, log.strategy);
        QCOMPARE(back->samples.size(), std::size_t{2});
        QVERIFY(back->samples[0].machine == log.samples[0].machine);
        QVERIFY(!back->samples[0].session && !back->samples[0].X_AO_turned
                && !back->samples[0].X_AO_moved);
        QVERIFY(back->samples[1].machine == log.samples[1].machine);
        QVERIFY(back->samples[1].session == log.samples[1].session);
        QVERIFY(back->samples[1].X_AO_turned->matrix() == log.samples[1].X_AO_turned->matrix());
        QVERIFY(back->samples[1].X_AO_moved->matrix() == Mat4::Identity());
        QCOMPARE(back->actions.size(), std::size_t{1});
        const DeclaredAction& action = back->actions[0];
        QVERIFY(action.called == log.actions[0].called);
        QVERIFY(action.turnedSince == log.actions[0].turnedSince);
        QVERIFY(action.movedSince == log.actions[0].movedSince);
        QVERIFY(action.q_AO.coeffs() == log.actions[0].q_AO.coeffs());
        QVERIFY(action.p_AO == log.actions[0].p_AO);
    }

    void damagedOnesAreRefused_data()
    {
        QTest::addColumn<QString>("key");
        QTest::addColumn<QJsonValue>("value");
        const QJsonArray shortRow{QJsonArray{1, 2, 3}};
        QJsonArray word = toJson(logOfAll())[QStringLiteral("samples")].toArray()[1].toArray();
        QJsonArray skewed = word;
        word[4] = QStringLiteral("up");
        skewed[3] = 7.0; // of a rotation
        QTest::newRow("another schema")
            << QStringLiteral("schema") << QJsonValue{QStringLiteral("carina.drift/1")};
        QTest::newRow("no strategy") << QStringLiteral("strategy") << QJsonValue{};
        QTest::newRow("an unknown strategy") << QStringLiteral("strategy") << QJsonValue{8};
        QTest::newRow("a short sample") << QStringLiteral("samples") << QJsonValue{shortRow};
        QTest::newRow("a short action") << QStringLiteral("actions") << QJsonValue{shortRow};
        QTest::newRow("a word") << QStringLiteral("samples") << QJsonValue{QJsonArray{word}};
        QTest::newRow("no rotation") << QStringLiteral("samples") << QJsonValue{QJsonArray{skewed}};
    }
    void damagedOnesAreRefused()
    {
        QFETCH(QString, key);
        QFETCH(QJsonValue, value);
        QJsonObject json = toJson(logOfAll());
        json[key] = value;
        const auto log = liveLogFrom(json);
        QVERIFY(!log);
        QCOMPARE(log.error().code, Errc::FileMalformed);
    }
};

CARINA_TEST(LiveLogTest)

} // namespace carina::lab::live_log_test

#include "tst_live_log.moc"
