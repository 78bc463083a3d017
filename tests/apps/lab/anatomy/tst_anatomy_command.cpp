#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "tests/engine/io/mesh/surface_files.h"
#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QTemporaryDir>

namespace carina::lab::anatomy_command_test
{

class TestAnatomyCommand final : public QObject
{
    Q_OBJECT

private:
    QTemporaryDir m_temporary;
    QString m_set;

    Result<QJsonObject> run(const char* verb) const
    {
        return anatomyCommand().run({QString::fromLatin1(verb), m_set});
    }

private Q_SLOTS:
    /// Centimetres, y up and z to the front.
    void initTestCase()
    {
        qputenv("XDG_CACHE_HOME", (m_temporary.path() + QStringLiteral("/cache")).toLocal8Bit());
        m_set = m_temporary.path() + QStringLiteral("/Somebody");
        const std::filesystem::path set = m_set.toStdString();
        test::writeFile(set / "Trachea.obj", test::objOf({10.0F, 0.0F, 130.0F, 0.0F}));
        test::writeFile(set / "left_lung.obj", test::objOf({20.0F, 5.0F, 110.0F, 0.0F}));
        test::writeFile(set / "right_lung.obj", test::objOf({20.0F, -25.0F, 110.0F, 0.0F}));
        test::writeFile(set / "Teapot.obj", test::objOf({3.0F, 0.0F, 140.0F, 9.0F}));
        test::writeFile(set / "Skull.obj", "");
    }

    void describesASet()
    {
        const auto object = run("import");
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        const QJsonObject& set = *object;
        QCOMPARE(set[QStringLiteral("schema")].toString(), QStringLiteral("carina.anatomy/1"));
        QCOMPARE(set[QStringLiteral("name")].toString(), QStringLiteral("Somebody"));
        QCOMPARE(set[QStringLiteral("content_hash")].toString().size(), 64);
        QCOMPARE(set[QStringLiteral("unit_mm")].toDouble(), 10.0);
        QCOMPARE(set[QStringLiteral("axes")].toArray(),
                 (QJsonArray{QStringLiteral("left"), QStringLiteral("superior"),
                             QStringLiteral("anterior")}));
        QCOMPARE(set[QStringLiteral("triangles")].toInt(), 16);
        QCOMPARE(set[QStringLiteral("faults")].toArray().size(), 1);
        QCOMPARE(set[QStringLiteral("faults")][0][QStringLiteral("file")].toString(),
                 QStringLiteral("Skull.obj"));
        QVERIFY(set[QStringLiteral("import_s")].toDouble() > 0.0);
        const double lungMl = 8000.0 / 6.0;
        for (const char* side : {"right_ml", "left_ml"}) {
            const double ml = set[QStringLiteral("lungs")][QString::fromLatin1(side)].toDouble();
            QVERIFY(std::abs(ml - lungMl) < 0.01);
        }
        QCOMPARE(set[QStringLiteral("parts")].toArray().size(), 4);
        const QJsonValue trachea = set[QStringLiteral("parts")][1];
        QCOMPARE(trachea[QStringLiteral("name")].toString(), QStringLiteral("Trachea"));
        QCOMPARE(trachea[QStringLiteral("role")].toString(), QStringLiteral("trachea"));
        QCOMPARE(trachea[QStringLiteral("closed")].toBool(), true);
        QVERIFY(std::abs(trachea[QStringLiteral("volume_ml")].toDouble() - 1000.0 / 6.0) < 0.01);
        QCOMPARE(set[QStringLiteral("parts")][0][QStringLiteral("role")].toString(),
                 QStringLiteral("other"));
    }

    void listsFromTheCacheAndImportsAnew()
    {
        QVERIFY(run("import").has_value());
        const auto listed = run("list");
        QCOMPARE((*listed)[QStringLiteral("from_cache")].toBool(), true);
        QVERIFY((*listed)[QStringLiteral("cache")].toString().startsWith(m_temporary.path()));
        QCOMPARE((*run("import"))[QStringLiteral("from_cache")].toBool(), false);
    }

    void saysWhatIsWrong()
    {
        QVERIFY(anatomyCommand().run({}).error().code == Errc::WrongOption);
        QVERIFY(run("show").error().code == Errc::WrongOption);
        const auto missing =
            anatomyCommand().run({QStringLiteral("list"), m_set + QStringLiteral("/none")});
        QVERIFY(missing.error().code == Errc::FileNotFound);
        QVERIFY(missing.error().detail.find("none") != std::string::npos);
    }

    void deformsAPatientInDrawnCombinations()
    {
        const auto object = anatomyCommand().run(
            {QStringLiteral("sweep"), QStringLiteral("--patient"), QStringLiteral("child"),
             QStringLiteral("--seeds"), QStringLiteral("2"), QStringLiteral("--without-limits")});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        const QJsonObject& sweep = *object;
        QCOMPARE(sweep[QStringLiteral("schema")].toString(),
                 QStringLiteral("carina.anatomy-sweep/1"));
        QCOMPARE(sweep[QStringLiteral("combinations")].toInt(), 2);
        QVERIFY(sweep[QStringLiteral("level")].isNull());
        const QJsonValue least = sweep[QStringLiteral("least_determinant")];
        QVERIFY(least[QStringLiteral("determinant")].toDouble() < 1.0);
        const int seed = least[QStringLiteral("parameters")][QStringLiteral("seed")].toInt();
        QVERIFY(seed == 1 || seed == 2);
        const bool isAcceptable = sweep[QStringLiteral("self_intersecting")].toInt() == 0
                                  && sweep[QStringLiteral("folded")].toInt() == 0;
        QCOMPARE(sweep[QStringLiteral("acceptable")].toBool(), isAcceptable);
        QCOMPARE(sweep[QStringLiteral("bad")].toArray().isEmpty(), isAcceptable);
        const QString help = pageOf(anatomyCommand());
        for (const QString& key : sweep.keys())
            QVERIFY2(help.contains(QStringLiteral("\n    %1 ").arg(key)), qPrintable(key));
        for (const QString& key : least[QStringLiteral("parameters")].toObject().keys())
            QVERIFY2(help.contains(QStringLiteral("\n        %1").arg(key)), qPrintable(key));
    }

    void hasTheAgeOfAnInfantInYears()
    {
        const auto object =
            anatomyCommand().run({QStringLiteral("dimensions"), QStringLiteral("--patient"),
                                  QStringLiteral("18 months, 80 cm, boy")});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        const QJsonObject boy = (*object)[QStringLiteral("patients")][0].toObject();
        QCOMPARE(boy[QStringLiteral("age_years")].toDouble(), 1.5);
        const QString help = pageOf(anatomyCommand());
        for (const QString& key : object->keys())
            QVERIFY2(help.contains(QStringLiteral("\n    %1 ").arg(key)), qPrintable(key));
        for (const QString& key : boy.keys())
            QVERIFY2(help.contains(QStringLiteral("\n      %1 ").arg(key)), qPrintable(key));
    }

    void comparesDimensionsWithPublishedOnes()
    {
        const auto object =
            anatomyCommand().run({QStringLiteral("dimensions"), QStringLiteral("--patient"),
                                  QStringLiteral("6 years, 116 cm, girl")});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QCOMPARE((*object)[QStringLiteral("patients")].toArray().size(), 1);
        const QJsonObject girl = (*object)[QStringLiteral("patients")][0].toObject();
        QCOMPARE(girl[QStringLiteral("patient")].toString(),
                 QStringLiteral("6 years, 116 cm, girl"));
        QVERIFY(girl[QStringLiteral("measured")].toObject().size() >= 20);
        const QJsonArray rows = girl[QStringLiteral("dimensions")].toArray();
        QVERIFY(!rows.isEmpty());
        for (const QJsonValue row : rows) {
            QVERIFY(row[QStringLiteral("measured")].toDouble() > 0.0);
            QVERIFY(row[QStringLiteral("published")].toDouble() > 0.0);
            QVERIFY(!row[QStringLiteral("source")].toString().isEmpty());
            QCOMPARE(row[QStringLiteral("z")].isNull(), row[QStringLiteral("sd")].isNull());
        }
    }

    void refusesOptionsOfItsOtherWays()
    {
        const auto code = [](const QStringList& words) {
            return anatomyCommand().run(words).error().code;
        };
        const QString seeds = QStringLiteral("--seeds");
        QVERIFY(code({QStringLiteral("list"), m_set, seeds, QStringLiteral("3")})
                == Errc::WrongOption);
        QVERIFY(code({QStringLiteral("compare"), seeds, QStringLiteral("3")}) == Errc::WrongOption);
        QVERIFY(code({QStringLiteral("sweep"), QStringLiteral("--set"), m_set})
                == Errc::WrongOption);
        QVERIFY(code({QStringLiteral("sweep"), QStringLiteral("--seeds=-1")}) == Errc::WrongOption);
        QVERIFY(code({QStringLiteral("dimensions"), seeds, QStringLiteral("3")})
                == Errc::WrongOption);
    }

    void namesEveryKeyInItsHelp()
    {
        const QString help = pageOf(anatomyCommand());
        const QJsonObject set = *run("list");
        for (const QString& key : set.keys())
            QVERIFY2(help.contains(QStringLiteral("\n    %1 ").arg(key)), qPrintable(key));
        for (const QString& key : set[QStringLiteral("parts")][1].toObject().keys())
            QVERIFY2(help.contains(QStringLiteral("\n      %1 ").arg(key)), qPrintable(key));
    }
};

CARINA_TEST(TestAnatomyCommand)

} // namespace carina::lab::anatomy_command_test

#include "tst_anatomy_command.moc"
