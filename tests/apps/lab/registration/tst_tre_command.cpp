#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

#include <cmath>

namespace carina::lab::tre_command_test
{
namespace
{

constexpr double kExact = 1e-9; // relative

double number(const QJsonValue& value) { return value.toDouble(std::nan("")); }

bool near(const QJsonValue& value, double expected)
{
    return std::abs(number(value) / expected - 1.0) < kExact;
}

/// Corners of a cross of 100 mm: by Fitzpatrick's formula, with f = 100 / root 2 about its arms and
/// 100 mm about its axis, the mean square at (0, 0, z) is FLE^2 / 4 (1 + 2/3 z^2 / 5000), at
/// (x, 0, 0) it is FLE^2 / 4 (1 + 1/3 (x^2 / 5000 + x^2 / 10000)).
constexpr const char* kCross = "name,ax,ay,az\na,100,0,0\nb,0,100,0\nc,-100,0,0\nd,0,-100,0\n";
constexpr const char* kTargets = "name,ax,ay,az\nmiddle,0,0,0\nabove,0,0,150\naside,100,0,0\n";

} // namespace

class TestTreCommand : public QObject
{
    Q_OBJECT

private:
    test::ScratchFolder m_folder;

    /// The command on the cross and its targets.
    Result<QJsonObject> tre(const QString& options) const
    {
        QStringList arguments{m_folder.write("landmarks.csv", kCross),
                              m_folder.write("targets.csv", kTargets)};
        return treCommand().run(arguments + options.split(QLatin1Char(' '), Qt::SkipEmptyParts));
    }
    static Result<QJsonObject> treOfHeight(const QString& options)
    {
        return treCommand().run(options.split(QLatin1Char(' ')));
    }

private Q_SLOTS:
    void predictsAsTheFormulaSays()
    {
        const auto object = tre(QStringLiteral("--fle 2"));
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QCOMPARE(object->value(QStringLiteral("schema")).toString(),
                 QStringLiteral("carina.tre/1"));
        QCOMPARE(object->value(QStringLiteral("landmarks")).toInt(), 4);
        const QJsonArray targets = object->value(QStringLiteral("targets")).toArray();
        QCOMPARE(targets.size(), 3);
        QCOMPARE(targets[1][QStringLiteral("name")].toString(), QStringLiteral("above"));
        QVERIFY(near(targets[0][QStringLiteral("rms_mm")], 1.0));
        QVERIFY(near(targets[1][QStringLiteral("rms_mm")], 2.0));
        QVERIFY(near(targets[2][QStringLiteral("rms_mm")], std::sqrt(2.0)));
        QCOMPARE(object->value(QStringLiteral("worst")).toString(), QStringLiteral("above"));
        // At the middle alike in all directions: the root of a third of chi-squared's 7.8147.
        const double bound = number(targets[0][QStringLiteral("bound95_mm")]);
        QVERIFY(std::abs(bound / std::sqrt(7.8147 / 3.0) - 1.0) < 1e-4);
        QCOMPARE(targets[2][QStringLiteral("weakest")].toString(), QStringLiteral("head-feet"));
        const QJsonArray weakest = targets[2][QStringLiteral("weakest_A")].toArray();
        QCOMPARE(weakest.size(), 3);
        QVERIFY(std::abs(std::abs(number(weakest[2])) - 1.0) < kExact);
        QVERIFY(!object->contains(QStringLiteral("next")));
        QVERIFY(!object->contains(QStringLiteral("within_limit")));
    }

    void assumesOneMillimetre()
    {
        const auto object = tre({});
        QVERIFY(near(object->value(QStringLiteral("targets"))[1][QStringLiteral("rms_mm")], 1.0));
    }

    /// F(3, 6) has its 95 % quantile at 4.7571.
    void widensTheBoundForFewDegrees()
    {
        const auto object = tre(QStringLiteral("--fle 2 --degrees 6"));
        const QJsonValue middle = object->value(QStringLiteral("targets"))[0];
        QVERIFY(std::abs(number(middle[QStringLiteral("bound95_mm")]) / std::sqrt(4.7571) - 1.0)
                < 1e-4);
        QVERIFY(near(middle[QStringLiteral("rms_mm")], 1.0));
    }

    void holdsTheWorstToALimit()
    {
        const QString key = QStringLiteral("within_limit");
        QCOMPARE(tre(QStringLiteral("--fle 2 --limit 2.001"))->value(key), QJsonValue{true});
        QCOMPARE(tre(QStringLiteral("--fle 2 --limit 1.999"))->value(key), QJsonValue{false});
    }

    void offersTheBestCandidate()
    {
        const QString file =
            m_folder.write("candidates.csv", "name,ax,ay,az\nnear,0,10,5\nfar,0,0,150\n");
        const auto object = tre(QStringLiteral("--candidates ") + file);
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        const QJsonValue next = object->value(QStringLiteral("next"));
        QCOMPARE(next[QStringLiteral("name")].toString(), QStringLiteral("far"));
        QVERIFY(number(next[QStringLiteral("worst_rms_mm")]) < 0.9);
        const auto none =
            tre(QStringLiteral("--candidates ") + m_folder.write("empty.csv", "name,ax,ay,az\n"));
        QVERIFY(none->value(QStringLiteral("next")).isNull());
    }

    /// Each landmark with 4 mm^2 along x, y and z is each with an FLE of root 12 mm.
    void takesCovariances()
    {
        std::string text = "name,ax,ay,az,cxx,cyy,czz,cxy,cxz,cyz\n";
        for (const char* corner : {"a,100,0,0", "b,0,100,0", "c,-100,0,0", "d,0,-100,0"})
            text += std::string{corner} + ",4,4,4,0,0,0\n";
        const auto object = treCommand().run({m_folder.write("covariances.csv", text),
                                              m_folder.write("targets.csv", kTargets),
                                              QStringLiteral("--covariance")});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QVERIFY(near(object->value(QStringLiteral("targets"))[1][QStringLiteral("rms_mm")],
                     std::sqrt(12.0)));
    }

    /// More landmarks around the airway, less error at the glottis.
    void knowsABodyByItsHeight()
    {
        double before = 1e9;
        for (const int count : {4, 6, 8}) {
            const auto object =
                treOfHeight(QStringLiteral("--height 1.75 --landmarks %1").arg(count));
            QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
            QCOMPARE(object->value(QStringLiteral("landmarks")).toInt(), count);
            const QJsonArray targets = object->value(QStringLiteral("targets")).toArray();
            QCOMPARE(targets.size(), 5);
            QCOMPARE(targets[0][QStringLiteral("name")].toString(), QStringLiteral("glottis"));
            const double glottis = number(targets[0][QStringLiteral("rms_mm")]);
            QVERIFY(glottis > 0.3 && glottis < 1.5 && glottis < before);
            before = glottis;
        }
        QCOMPARE(*treOfHeight(QStringLiteral("--height 1.75")),
                 *treOfHeight(QStringLiteral("--height 1.75 --landmarks 8 --fle 1")));
    }

    void refusesAnotherCommandLine_data()
    {
        QTest::addColumn<QString>("words");
        QTest::addColumn<QString>("sentence");
        const QString usage = QStringLiteral(" tre needs LANDMARKS.csv TARGETS.csv, or --height M");
        QTest::newRow("nothing") << QString{}
                                 << QStringLiteral("No file and no --height is given.") + usage;
        QTest::newRow("one file") << QStringLiteral(
            "a.csv") << QStringLiteral("The file of targets is missing beside 'a.csv'.") + usage;
        QTest::newRow("files and a height")
            << QStringLiteral("a.csv b.csv --height 1.7")
            << QStringLiteral("--height takes the place of files, such as 'a.csv'.") + usage;
        QTest::newRow("landmarks of files")
            << QStringLiteral("a.csv b.csv --landmarks 4")
            << QStringLiteral("--landmarks goes with --height, not with files.") + usage;
        QTest::newRow("both errors")
            << QStringLiteral("a.csv b.csv --covariance --fle 1")
            << QStringLiteral("--covariance and --fle exclude each other.") + usage;
        QTest::newRow("covariances of a height")
            << QStringLiteral("--height 1.7 --covariance")
            << QStringLiteral("--covariance goes with files, not with --height.") + usage;
        QTest::newRow("an unknown flag") << QStringLiteral("--height 1.7 --tall")
                                         << QStringLiteral("tre has no option --tall.") + usage;
        QTest::newRow("an option without its value")
            << QStringLiteral("--height") << QStringLiteral("tre: Missing value after '--height'.");
        QTest::newRow("a giant") << QStringLiteral(
            "--height 2.2") << QStringLiteral("tre needs --height with a number from 1 to 2.1.");
        QTest::newRow("two landmarks")
            << QStringLiteral("--height 1.7 --landmarks 2")
            << QStringLiteral("tre needs --landmarks with a whole number from 3 to 8.");
        QTest::newRow("four and a half landmarks")
            << QStringLiteral("--height 1.7 --landmarks 4.5")
            << QStringLiteral("tre needs --landmarks with a whole number from 3 to 8.");
        QTest::newRow("no error") << QStringLiteral("--height 1.7 --fle 0")
                                  << QStringLiteral("--fle needs a number of millimetres above 0.");
        QTest::newRow("no limit") << QStringLiteral("--height 1.7 --limit x")
                                  << QStringLiteral("--limit needs a number of millimetres");
        QTest::newRow("no degree") << QStringLiteral("--height 1.7 --degrees 0")
                                   << QStringLiteral("tre needs --degrees with a number from 1 to");
    }

    void refusesAnotherCommandLine()
    {
        QFETCH(QString, words);
        QFETCH(QString, sentence);
        const auto object = treCommand().run(words.split(QLatin1Char(' '), Qt::SkipEmptyParts));
        QVERIFY(!object);
        QCOMPARE(object.error().code, Errc::WrongOption);
        const QString detail = QString::fromStdString(object.error().detail);
        QVERIFY2(detail.startsWith(sentence), qPrintable(detail));
    }

    void refusesPlacesThatDoNotSuffice()
    {
        const auto line = treCommand().run(
            {m_folder.write("line.csv", "name,ax,ay,az\na,0,0,0\nb,50,0,0\nc,100,0,0\n"),
             m_folder.write("targets.csv", kTargets)});
        QVERIFY(!line);
        QCOMPARE(line.error().code, Errc::DegenerateLandmarks);
        QCOMPARE(QString::fromStdString(line.error().detail),
                 QStringLiteral("The error cannot be predicted: the anatomy's landmarks lie on one "
                                "line."));
        const auto file = treCommand().run(
            {QStringLiteral("/nowhere.csv"), m_folder.write("targets.csv", kTargets)});
        QCOMPARE(file.error().code, Errc::FileNotFound);
        const auto bad = tre(QStringLiteral("--candidates ")
                             + m_folder.write("bad.csv", "name,ax,ay,az\nx,nan,0,0\n"));
        QCOMPARE(bad.error().code, Errc::NotFinite);
        QVERIFY(bad.error().detail.starts_with("A candidate cannot be used: "));
    }

    void helpNamesEveryKeyAndFlag()
    {
        for (const char* name :
             {"LANDMARKS.csv", "TARGETS.csv", "--height", "--landmarks", "--fle", "--covariance",
              "--degrees", "--limit", "--candidates", "schema", "targets", "rms_mm", "bound95_mm",
              "weakest", "weakest_A", "worst", "within_limit", "next", "worst_rms_mm"})
            QVERIFY2(pageOf(treCommand()).contains(QLatin1StringView{name}), name);
    }
};

CARINA_TEST(TestTreCommand)

} // namespace carina::lab::tre_command_test

#include "tst_tre_command.moc"
