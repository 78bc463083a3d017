#include "apps/lab/commands.h"
#include "engine/lungs/mechanics/lung_condition.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QJsonArray>
#include <QTemporaryDir>

namespace carina::condition_sweep_test
{

namespace
{

constexpr double kVolumeTolerance_ml = 0.1;

void verifySwept(const QStringList& patient, int leastLevels)
{
    const Result<QJsonObject> swept =
        lab::breatheCommand().run(QStringList{QStringLiteral("--every-condition")} + patient);
    QVERIFY2(swept.has_value(), swept ? "" : swept.error().detail.c_str());
    QCOMPARE((*swept)[QStringLiteral("schema")].toString(),
             QStringLiteral("carina.breathe.conditions/1"));
    QSet<QString> conditions;
    for (const QJsonValue& condition : (*swept)[QStringLiteral("conditions")].toArray()) {
        conditions.insert(condition[QStringLiteral("condition")].toString());
        const double error_ml = condition[QStringLiteral("max_volume_error_ml")].toDouble(1e9);
        QVERIFY2(error_ml < kVolumeTolerance_ml,
                 qPrintable(condition[QStringLiteral("condition")].toString()));
    }
    QCOMPARE(conditions.size(), qsizetype(kConditionKinds.size()));
    const int trials = (*swept)[QStringLiteral("trials")].toInt();
    QVERIFY(trials > 500);
    const qsizetype levels = (*swept)[QStringLiteral("levels")].toArray().size();
    QVERIFY(levels >= leastLevels);
    QCOMPARE((*swept)[QStringLiteral("frames")].toInt(), int(levels) * trials * 6);
}

} // namespace

class TestConditionSweep : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsTheVolumeOfEveryCondition();
    void drawsThatOfWhoDoesNotLieOnTheBack();
    void drawsThatOfRealLungs();
};

void TestConditionSweep::drawsTheVolumeOfEveryCondition()
{
    verifySwept({QStringLiteral("--patient"), QStringLiteral("adult")}, 3);
}

void TestConditionSweep::drawsThatOfWhoDoesNotLieOnTheBack()
{
    for (const char* position : {"sitting", "prone", "right_lateral", "left_lateral"})
        verifySwept({QStringLiteral("--level"), QStringLiteral("2"), QStringLiteral("--position"),
                     QString::fromLatin1(position)},
                    1);
}

void TestConditionSweep::drawsThatOfRealLungs()
{
    const auto folder = test::testData("anatomy/lungs");
    if (!folder)
        QSKIP("needs ../shared/data/anatomy/lungs");
    const QTemporaryDir cache;
    qputenv("XDG_CACHE_HOME", cache.path().toUtf8());
    verifySwept({QStringLiteral("--anatomy"), QString::fromStdString(folder->string())}, 4);
}

CARINA_SCREEN_TEST(TestConditionSweep)

} // namespace carina::condition_sweep_test

#include "tst_condition_sweep.moc"
