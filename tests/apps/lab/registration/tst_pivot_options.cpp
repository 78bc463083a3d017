#include "apps/lab/commands.h"
#include "tests/apps/lab/registration/stylus_poses.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

namespace carina::lab::pivot_options_test
{

using namespace test;

/// What `pivot` tells of the turns, and its flags.
class TestPivotOptions : public QObject
{
    Q_OBJECT

private:
    test::ScratchFolder m_folder;

private Q_SLOTS:
    /// Leaning by half a radian to all sides: unit vectors stray from their mean m by
    /// sqrt(1 - |m|^2), and |m| is the cosine along the stylus, (1 + cosine) / 2 across it.
    void tellsHowFarTheStylusWasTurned()
    {
        const auto object = pivotCommand().run({m_folder.write("turns.csv", tableOf(swung()))});
        QVERIFY(object.has_value());
        const QJsonArray coverage = object->value(QStringLiteral("coverage")).toArray();
        QCOMPARE(coverage.size(), 3);
        const double cosine = std::cos(0.5);
        const double across = std::sqrt(1.0 - std::pow(0.5 * (1.0 + cosine), 2));
        const double degrees = 180.0 / std::numbers::pi;
        const auto turn = [&](int i) {
            return coverage[i].toObject().value(QStringLiteral("turn_deg")).toDouble();
        };
        QVERIFY(std::abs(turn(0) - across * degrees) < 1e-6);
        QVERIFY(std::abs(turn(2) - std::sin(0.5) * degrees) < 1e-6);
        QVERIFY(near(coverage[2].toObject().value(QStringLiteral("direction")), Vec3::UnitZ()));
        QCOMPARE(object->value(QStringLiteral("least_turned")).toArray().size(), 3);
        QVERIFY(object->value(QStringLiteral("uncertainty_mm")).toDouble(1.0) < kTolerance_mm);
    }

    void keepsToTheLimitItIsGiven()
    {
        auto poses = swung();
        poses[7] = RigidTransform::translation({0.0, 0.0, 4.0}) * poses[7];
        const QString path = m_folder.write("limit.csv", tableOf(poses));
        const auto strict = pivotCommand().run({path});
        QVERIFY(strict.has_value());
        QCOMPARE(strict->value(QStringLiteral("outliers")).toInt(-1), 1);
        QVERIFY(strict->value(QStringLiteral("rms_mm")).toDouble(1.0) < kTolerance_mm);
        const auto lenient =
            pivotCommand().run({path, QStringLiteral("--limit-mm"), QStringLiteral("4.5")});
        QVERIFY(lenient.has_value());
        QCOMPARE(lenient->value(QStringLiteral("outliers")).toInt(-1), 0);
        QVERIFY(lenient->value(QStringLiteral("rms_mm")).toDouble() > 0.3);
    }

    /// Two divots 4 mm apart, half of the poses in each: 2 mm RMS, which the registration program
    /// refuses. The figures are there all the same.
    void printsWhatIsNotAcceptable()
    {
        auto poses = swung();
        for (std::size_t i = 0; i < poses.size(); i += 2)
            poses[i] = RigidTransform::translation({4.0, 0.0, 0.0}) * poses[i];
        const QStringList words{m_folder.write("strayed.csv", tableOf(poses)),
                                QStringLiteral("--limit-mm"), QStringLiteral("6")};
        const auto object = pivotCommand().run(words);
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QVERIFY(!object->value(QStringLiteral("acceptable")).toBool(true));
        const QString reason = object->value(QStringLiteral("reason")).toString();
        QVERIFY2(reason.contains(QStringLiteral("1.50 mm are the most")), qPrintable(reason));
        QVERIFY(std::abs(object->value(QStringLiteral("rms_mm")).toDouble() - 2.0) < 0.1);
        const std::array commands{pivotCommand()};
        const QStringList line = QStringList{QStringLiteral("carina-lab"), QStringLiteral("pivot")};
        QCOMPARE(runCommandLine(commands, line + words), 1);
        const QString sound = m_folder.write("sound.csv", tableOf(swung()));
        QCOMPARE(runCommandLine(commands, line + QStringList{sound}), 0);
        const auto good = pivotCommand().run({sound});
        QVERIFY(good->value(QStringLiteral("acceptable")).toBool());
        QVERIFY(good->value(QStringLiteral("reason")).isNull());
    }

    void findsTheAxisThatAToolIsSpunAbout()
    {
        const Vec3 axis = Vec3{0.0, 0.6, -0.8};
        const Vec3 on_mm{10.0, 0.0, 0.0};
        std::vector<RigidTransform> poses;
        for (int i = 0; i < kPoses; ++i) {
            const Quat turn = rotationFromVector(4.0 * i / kPoses * axis);
            poses.push_back(kX_TR * RigidTransform{turn, on_mm - turn * on_mm});
        }
        const QString path = m_folder.write("spin.csv", tableOf(poses));
        const auto spin = [&](const char* ahead) {
            return pivotCommand().run({path, QStringLiteral("--spin"), QString::fromLatin1(ahead)});
        };
        const auto object = spin("0,6,-8");
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QCOMPARE(object->value(QStringLiteral("schema")).toString(),
                 QStringLiteral("carina.spin/1"));
        QVERIFY(near(object->value(QStringLiteral("axis")), axis));
        QVERIFY(near(object->value(QStringLiteral("axis_point_mm")), on_mm));
        QVERIFY(object->value(QStringLiteral("rms_mm")).toDouble(1.0) < kTolerance_mm);
        QVERIFY(object->value(QStringLiteral("wobble_deg")).toDouble(1.0) < 1e-5);
        QVERIFY(object->value(QStringLiteral("uncertainty_deg")).toDouble(1.0) < 1e-5);
        QCOMPARE(object->value(QStringLiteral("poses")).toInt(), kPoses);
        QCOMPARE(object->value(QStringLiteral("outliers")).toInt(-1), 0);
        QVERIFY(near(spin("0,-6,8")->value(QStringLiteral("axis")), -axis));
        const auto swungOnly =
            pivotCommand().run({m_folder.write("swung.csv", tableOf(swung())),
                                QStringLiteral("--spin"), QStringLiteral("0,0,-1")});
        QVERIFY(swungOnly.has_value());
        QVERIFY(!swungOnly->value(QStringLiteral("acceptable")).toBool(true));
        QVERIFY(swungOnly->value(QStringLiteral("reason"))
                    .toString()
                    .contains(QStringLiteral("does not determine the axis: ")));
        QVERIFY(object->value(QStringLiteral("acceptable")).toBool());
    }

    /// Sound poses of which none tells where the tip is: an object that says so, without figures.
    void printsWhyTurnsTellNoTip_data()
    {
        QTest::addColumn<Vec3>("across");
        QTest::addColumn<QString>("reason");
        QTest::newRow("not turned")
            << Vec3{0.0, 0.0, 0.0} << QStringLiteral("the stylus was hardly turned: ");
        QTest::newRow("about one axis only")
            << Vec3{0.5, 0.0, 0.0} << QStringLiteral("the stylus was turned about one axis only: ");
    }
    void printsWhyTurnsTellNoTip()
    {
        QFETCH(Vec3, across);
        QFETCH(QString, reason);
        std::vector<RigidTransform> poses;
        for (int i = 0; i < kPoses; ++i) {
            const Quat turn = rotationFromVector(std::sin(0.2 * i) * across);
            poses.push_back({turn, kDivot_mm - turn * kTip_S_mm});
        }
        const QString path = m_folder.write("turned.csv", tableOf(poses));
        const auto object = pivotCommand().run({path});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QCOMPARE(object->value(QStringLiteral("schema")).toString(),
                 QStringLiteral("carina.pivot/1"));
        QVERIFY(!object->value(QStringLiteral("acceptable")).toBool(true));
        QCOMPARE(object->value(QStringLiteral("poses")).toInt(), kPoses);
        QVERIFY(!object->contains(QStringLiteral("tip_mm")));
        const QString said = object->value(QStringLiteral("reason")).toString();
        QVERIFY2(said.startsWith(path) && said.contains(reason), qPrintable(said));
        const std::array commands{pivotCommand()};
        QCOMPARE(
            runCommandLine(commands, {QStringLiteral("carina-lab"), QStringLiteral("pivot"), path}),
            1);
    }

    void saysWhatIsWrongWithItsWords_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("fault");
        const QString limit = QStringLiteral("--limit-mm needs a number of millimetres above 0.");
        const QString spin = QStringLiteral("--spin needs three numbers with commas between them");
        QTest::newRow("nothing") << QString{} << QStringLiteral("No file and no folder is named.");
        QTest::newRow("no limit") << QStringLiteral("a.csv --limit-mm 0") << limit;
        QTest::newRow("a word for a limit") << QStringLiteral("a.csv --limit-mm three") << limit;
        QTest::newRow("two numbers") << QStringLiteral("a.csv --spin 1,2") << spin;
        QTest::newRow("a letter") << QStringLiteral("a.csv --spin 1,2,z") << spin;
        QTest::newRow("tip and axis") << QStringLiteral("a.csv --spin 1,2,3 --limit-mm 3")
                                      << QStringLiteral("--limit-mm and --spin exclude each other");
        QTest::newRow("an unknown flag")
            << QStringLiteral("a.csv --trim") << QStringLiteral("pivot has no option --trim.");
        QTest::newRow("two files")
            << QStringLiteral("a.csv b.csv") << QStringLiteral("pivot does not take 'b.csv'.");
    }
    void saysWhatIsWrongWithItsWords()
    {
        QFETCH(QString, words);
        QFETCH(QString, fault);
        const auto object = pivotCommand().run(words.split(QLatin1Char(' '), Qt::SkipEmptyParts));
        QVERIFY(!object);
        const QString detail = QString::fromStdString(object.error().detail);
        QVERIFY2(detail.startsWith(fault), qPrintable(detail));
        QVERIFY2(detail.contains(QStringLiteral(" pivot needs one file")), qPrintable(detail));
    }
};

CARINA_TEST(TestPivotOptions)

} // namespace carina::lab::pivot_options_test

#include "tst_pivot_options.moc"
