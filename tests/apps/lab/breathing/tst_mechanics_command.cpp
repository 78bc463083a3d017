#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace carina::lab::mechanics_command_test
{

class TestMechanicsCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void describesThePatientAndEveryCondition();
    void tellsWhatItWasGivenFromWhatFollows();
    void givesEachConditionARangeOrSaysThatThereIsNone();
    void listsWhatIsOutside();
    void saysWhichPatientsItTakes();
    void trapsMoreGasTheFasterItBreathes();
    void tellsTheCourseOfATension();
    void describesAWaveform();
    void describesAPosition();
    void refusesBadArguments_data();
    void refusesBadArguments();
};

namespace
{

Result<QJsonObject> mechanics(const QStringList& arguments)
{
    return mechanicsCommand().run(arguments);
}

/// What is printed of a patient, which takes half a minute, once for all tests.
QJsonObject everyConditionOf(const char* patient)
{
    static std::map<std::string, QJsonObject> printed;
    QJsonObject& all = printed[patient];
    if (all.isEmpty())
        all = mechanics({QStringLiteral("--patient"), QString::fromLatin1(patient)}).value();
    return all;
}

} // namespace

void TestMechanicsCommand::describesThePatientAndEveryCondition()
{
    const QJsonObject printed = everyConditionOf("child");
    QCOMPARE(printed[QStringLiteral("schema")].toString(), QStringLiteral("carina.mechanics/2"));
    const QJsonObject patient = printed[QStringLiteral("patient")].toObject();
    QCOMPARE(patient[QStringLiteral("frc_ml")].toDouble(), 1200.0);
    QCOMPARE(patient[QStringLiteral("tlc_ml")].toDouble(), 3200.0);
    const double compliance = patient[QStringLiteral("compliance_ml_per_cmh2o")].toDouble();
    QVERIFY(std::abs(compliance - 52.0) < 0.1);

    const QJsonArray conditions = printed[QStringLiteral("conditions")].toArray();
    QCOMPARE(conditions.size(), 1 + 9 * 3);
    QStringList names;
    for (const QJsonValue& value : conditions) {
        const QJsonObject condition = value.toObject();
        names += condition[QStringLiteral("condition")].toString();
        const QJsonObject ventilated = condition[QStringLiteral("volume_control")].toObject();
        QCOMPARE(ventilated.size(), 16);
        QVERIFY(ventilated[QStringLiteral("peak_cmh2o")].toDouble()
                >= ventilated[QStringLiteral("plateau_cmh2o")].toDouble());
        QCOMPARE(condition[QStringLiteral("spontaneous")].toObject().size(), 16);
    }
    names.removeDuplicates();
    QCOMPARE(names.size(), 10);
    for (const QString& name : names)
        QVERIFY2(pageOf(mechanicsCommand()).contains(name), qPrintable(name));
}

/// A range has a source, and is an outcome only where more than one parameter goes into it; what no
/// publication says is a target.
void TestMechanicsCommand::tellsWhatItWasGivenFromWhatFollows()
{
    QStringList outcomes;
    QStringList targets;
    for (const char* name : {"ards", "copd"}) {
        const auto printed = mechanics({QStringLiteral("--condition"), QLatin1StringView{name}});
        QVERIFY(printed.has_value());
        for (const QJsonValue& condition : (*printed)[QStringLiteral("conditions")].toArray()) {
            for (const QJsonValue& range : condition[QStringLiteral("ranges")].toArray()) {
                QVERIFY(!range[QStringLiteral("source")].toString().isEmpty());
                QVERIFY(range[QStringLiteral("by_construction")].isBool());
                if (!range[QStringLiteral("by_construction")].toBool())
                    outcomes += range[QStringLiteral("figure")].toString();
                else
                    QVERIFY(range[QStringLiteral("within")].toBool());
            }
            for (const QJsonValue& target : condition[QStringLiteral("targets")].toArray()) {
                QVERIFY(!target.toObject().contains(QStringLiteral("source")));
                targets += target[QStringLiteral("figure")].toString();
            }
        }
    }
    QCOMPARE(outcomes, QStringList{QStringLiteral("ventilated_compliance_ml_per_cmh2o")});
    QCOMPARE(targets, QStringList{QStringLiteral("auto_peep_at_20_per_min_cmh2o")});
}

void TestMechanicsCommand::givesEachConditionARangeOrSaysThatThereIsNone()
{
    for (const char* patient : {"adult", "child"}) {
        const QJsonObject printed = everyConditionOf(patient);
        for (const QJsonValue& condition : printed[QStringLiteral("conditions")].toArray()) {
            const bool hasRange = !condition[QStringLiteral("ranges")].toArray().isEmpty();
            const QString sentence = condition[QStringLiteral("no_range")].toString();
            QCOMPARE(sentence.isEmpty(), hasRange);
            QVERIFY(hasRange || qstrcmp(patient, "child") == 0);
        }
    }
}

/// Severe ARDS of the adult, and the auto-PEEP of an obese man's severe COPD.
void TestMechanicsCommand::listsWhatIsOutside()
{
    const auto outside = [](const char* patient, const char* condition) {
        const auto printed =
            mechanics({QStringLiteral("--patient"), QString::fromLatin1(patient),
                       QStringLiteral("--condition"), QString::fromLatin1(condition)});
        return printed.value()[QStringLiteral("outside")].toArray();
    };
    const QJsonArray ards = outside("adult", "ards");
    QCOMPARE(ards.size(), 1);
    QVERIFY(ards[0].toString().startsWith(
        QStringLiteral("ards 0.9: ventilated_compliance_ml_per_cmh2o is 3")));
    QVERIFY(ards[0].toString().endsWith(QStringLiteral("expected 0 to 30")));
    const QJsonArray copd = outside("45 years, 175 cm, man, obese", "copd");
    QCOMPARE(copd.size(), 1);
    QVERIFY(copd[0].toString().endsWith(QStringLiteral("expected 5 to 10")));
    QVERIFY(outside("child", "asthma").isEmpty());
    QVERIFY(outside("adult", "normal").isEmpty());
}

void TestMechanicsCommand::saysWhichPatientsItTakes()
{
    const QString page = pageOf(mechanicsCommand()).simplified();
    for (const char* word : {"adult, child", "newborn to 90 years", "slim or obese"})
        QVERIFY2(page.contains(QLatin1StringView{word}), word);
    const auto refused = mechanics({QStringLiteral("--patient"), QStringLiteral("slim")});
    QVERIFY(!refused);
    QVERIFY(refused.error().detail.find("\"adult, slim\"") != std::string::npos);
}

void TestMechanicsCommand::trapsMoreGasTheFasterItBreathes()
{
    const auto autoPeep_cmH2O = [](const char* rate_perMin) {
        const auto printed =
            mechanics({QStringLiteral("--rate-per-min"), QString::fromLatin1(rate_perMin),
                       QStringLiteral("--condition"), QStringLiteral("copd")});
        const auto conditions = printed.value()[QStringLiteral("conditions")].toArray();
        const auto severeCopd = std::ranges::find_if(conditions, [](const QJsonValue& condition) {
            return condition[QStringLiteral("condition")] == QStringLiteral("copd")
                   && condition[QStringLiteral("severity")] == 0.9;
        });
        return (*severeCopd)[QStringLiteral("volume_control")][QStringLiteral("auto_peep_cmh2o")]
            .toDouble();
    };
    QVERIFY(autoPeep_cmH2O("12") > 0.5);
    QVERIFY(autoPeep_cmH2O("24") > 2.0 * autoPeep_cmH2O("12"));
}

/// Of no other condition. Gas only comes in, and what it does to the pressure grows with it; it is
/// below that of the room in inspiration, where more comes in.
void TestMechanicsCommand::tellsTheCourseOfATension()
{
    const QJsonObject printed = everyConditionOf("child");
    for (const QJsonValue& condition : printed[QStringLiteral("conditions")].toArray()) {
        const QJsonArray course = condition[QStringLiteral("course")].toArray();
        const bool isTension =
            condition[QStringLiteral("condition")] == QStringLiteral("tension_pneumothorax");
        QCOMPARE(course.size(), isTension ? 4 : 0);
        QJsonObject before;
        for (const QJsonValue& point : course) {
            for (const char* key : {"minutes", "pleural_gas_ml", "right_pleura_greatest_cmh2o",
                                    "mediastinal_shift_greatest_mm"})
                QVERIFY2(before.isEmpty()
                             || point[QLatin1StringView{key}].toDouble()
                                    > before[QLatin1StringView{key}].toDouble(),
                         key);
            QVERIFY(point[QStringLiteral("right_pleura_least_cmh2o")].toDouble() < 0.0);
            QVERIFY(point[QStringLiteral("mediastinal_shift_least_mm")].toDouble()
                    < point[QStringLiteral("mediastinal_shift_greatest_mm")].toDouble());
            before = point.toObject();
        }
    }
}

void TestMechanicsCommand::describesAWaveform()
{
    const QTemporaryDir folder;
    const QString name = folder.filePath(QStringLiteral("lung.csv"));
    QFile file{name};
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("#samplerate,100\npressure,flow\n");
    // 10 cmH2O s/L and 20 ml/cmH2O: 5 and 25 cmH2O after 1 s of 30 L/min, then out at once.
    for (int breath = 0; breath < 4; ++breath) {
        for (int i = 0; i < 20; ++i)
            file.write("10,\n");
        for (int i = 0; i < 100; ++i)
            file.write(QByteArray::number(15.0 + 0.25 * (i + 0.5)) + ",\n");
    }
    for (int i = 0; i < 20; ++i)
        file.write("10,\n");
    file.close();
    const auto printed = mechanics({QStringLiteral("--waveform"), name});
    QVERIFY2(printed.has_value(), printed ? "" : printed.error().detail.c_str());
    QCOMPARE((*printed)[QStringLiteral("schema")].toString(),
             QStringLiteral("carina.mechanics.waveform/1"));
    QCOMPARE((*printed)[QStringLiteral("flow")].toString(), QStringLiteral("assumed"));
    QCOMPARE((*printed)[QStringLiteral("breaths")].toInt(), 4);
    QCOMPARE((*printed)[QStringLiteral("samples")].toInt(), 500);
    const auto median = [&](const char* key) {
        return (*printed)[QLatin1StringView{key}].toArray()[1].toDouble();
    };
    QVERIFY(std::abs(median("resistance_cmh2o_s_per_l") - 10.0) < 1e-3);
    QVERIFY(std::abs(median("compliance_ml_per_cmh2o") - 20.0) < 1e-3);
    QVERIFY(std::abs((*printed)[QStringLiteral("time_constant_s")].toDouble() - 0.2) < 1e-4);
    QCOMPARE((*printed)[QStringLiteral("disconnected_s")].toDouble(), 0.0);
}

/// 806 ml more of 2310 than on the back.
void TestMechanicsCommand::describesAPosition()
{
    const auto printed = mechanics({QStringLiteral("--position"), QStringLiteral("sitting"),
                                    QStringLiteral("--condition"), QStringLiteral("normal")});
    QVERIFY(printed.has_value());
    QCOMPARE((*printed)[QStringLiteral("position")].toString(), QStringLiteral("sitting"));
    QCOMPARE((*printed)[QStringLiteral("conditions")].toArray().size(), 1);
    const QJsonObject healthy = (*printed)[QStringLiteral("conditions")].toArray()[0].toObject();
    QVERIFY(std::abs(healthy[QStringLiteral("rest_volume_ml")].toDouble() - 3116.0) < 0.1);
}

void TestMechanicsCommand::refusesBadArguments_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QByteArray>("named");
    const auto row = [](const char* name, const char* words, const char* named) {
        QTest::newRow(name) << QString::fromLatin1(words).split(QLatin1Char(' '))
                            << QByteArray{named};
    };
    row("unknown flag", "--speed 3", "--speed");
    row("a word", "adult", "adult");
    row("unknown patient", "--patient horse", "a patient is adult");
    row("unknown position", "--position upside_down", "upside_down");
    row("unknown condition", "--condition cold", "has no --condition cold; choose one of normal");
    row("patient and waveform", "--patient adult --waveform x", "alone, or --waveform");
    row("rate and waveform", "--rate-per-min 12 --waveform x", "alone, or --waveform");
    row("flow without waveform", "--inspiratory-flow-l-per-min 30", "alone, or --waveform");
    row("no rate", "--rate-per-min 0", "from 4 to 60");
    row("no flow", "--waveform x --inspiratory-flow-l-per-min 0.9", "from 1 to 200");
    row("too much flow", "--waveform x --inspiratory-flow-l-per-min 201", "from 1 to 200");
    row("flow no number", "--waveform x --inspiratory-flow-l-per-min much", "from 1 to 200");
    row("no such file", "--waveform /nowhere/x.csv", "/nowhere/x.csv");
}

void TestMechanicsCommand::refusesBadArguments()
{
    QFETCH(const QStringList, arguments);
    QFETCH(const QByteArray, named);
    const auto printed = mechanics(arguments);
    QVERIFY(!printed);
    const QByteArray detail = QByteArray::fromStdString(printed.error().detail);
    QVERIFY2(detail.contains(named), detail.constData());
}

CARINA_TEST(TestMechanicsCommand)

} // namespace carina::lab::mechanics_command_test

#include "tst_mechanics_command.moc"
