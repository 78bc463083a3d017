#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "engine/geometry/rigid_transform.h"
#include "engine/geometry/rotation.h"
#include "tests/engine/tracking/sequence_text.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"
#include "tests/support/test_data.h"

#include <QJsonArray>

namespace carina::lab::fit_command_test
{
namespace
{

constexpr double kExact_mm = 1e-9;
constexpr double kKnownRms_mm = 0.200; // of the recording of eight landmarks
constexpr double kRecordedTolerance_mm = 0.005;

const RigidTransform kX_AM{rotationFromVector({0.5, -0.2, 1.1}), {0.3, -0.1, 0.7}};
const std::vector<Vec3> kLandmarks_A{
    {0.0, -0.06, 0.04}, {0.0, -0.13, -0.13}, {0.08, -0.12, -0.11}, {-0.08, -0.12, -0.11}};

/// Coordinates in millimetres, each after a separator.
std::string words(const Vec3& p, char before)
{
    QByteArray text;
    for (int axis = 0; axis < 3; ++axis)
        text += before + QByteArray::number(1e3 * p[axis], 'g', 17);
    return text.toStdString();
}

double number(const QJsonValue& value) { return value.toDouble(std::nan("")); }

Mat4 matrixOf(const QJsonValue& rows)
{
    Mat4 matrix;
    for (int i = 0; i < 16; ++i)
        matrix(i / 4, i % 4) = number(rows[i / 4][i % 4]);
    return matrix;
}

/// A tip held for two seconds of 15 Hz at each point in turn.
test::SequenceText held(const std::vector<Vec3>& points)
{
    test::SequenceText text;
    int frames = 0;
    const auto at = [&](const Vec3& p) {
        text.frame(std::to_string(frames++ / 15.0));
        const auto mm = [](double metres) { return std::to_string(1e3 * metres); };
        text.toolAt("Stylus", mm(p.x()), mm(p.y()), mm(p.z()));
    };
    for (const Vec3& point : points) {
        for (int i = 0; i < 3; ++i)
            at(point + Vec3{0.0, 0.0, 0.1 * (3 - i)});
        for (int i = 0; i < 30; ++i)
            at(point);
    }
    return text;
}

} // namespace

class TestFitCommand : public QObject
{
    Q_OBJECT

private:
    test::ScratchFolder m_folder;

    static Result<QJsonObject> fit(const QStringList& arguments)
    {
        return fitCommand().run(arguments);
    }
    static Result<QJsonObject> fit(const QString& recording, const QString& config)
    {
        return fit(
            {QStringLiteral("--recording"), recording, QStringLiteral("--plus-config"), config});
    }
    QString config(const std::vector<Vec3>& landmarks) const
    {
        std::string text = R"(<Plus><CoordinateDefinitions><Transform From="StylusTip" To="Stylus"
 Matrix="1 0 0 10 0 1 0 -20 0 0 1 30 0 0 0 1"/></CoordinateDefinitions><Landmarks>)";
        for (const Vec3& p : landmarks)
            text.append("<Landmark Name='#' Position='").append(words(p, ' ')).append("'/>");
        return m_folder.write("config.xml", text + "</Landmarks></Plus>");
    }

private Q_SLOTS:
    void fitsPairs()
    {
        std::string text = "\xEF\xBB\xBFname,mx,my,mz, ax,ay,az,note\r\n";
        char name = 'P';
        for (const Vec3& p : kLandmarks_A) {
            text += ++name;
            text += words(kX_AM.inverse() * p, ',') + words(p, ',') + ",\r\n";
        }
        const auto object = fit({m_folder.write("pairs.csv", text + "\r\n")});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QCOMPARE(object->value(QStringLiteral("schema")).toString(),
                 QStringLiteral("carina.fit/1"));
        QVERIFY(number(object->value(QStringLiteral("rms_mm"))) < kExact_mm);
        const QJsonArray residuals = object->value(QStringLiteral("residuals_mm")).toArray();
        QCOMPARE(residuals.size(), 4);
        QCOMPARE(residuals[2][QStringLiteral("name")].toString(), QStringLiteral("S"));
        QVERIFY(number(residuals[2][QStringLiteral("mm")]) < kExact_mm);
        Mat4 expected = kX_AM.matrix();
        expected.topRightCorner<3, 1>() *= 1e3;
        const Mat4 found = matrixOf(object->value(QStringLiteral("X_AM_mm")));
        QVERIFY((found - expected).cwiseAbs().maxCoeff() < kExact_mm);
    }

    /// The corners of a square of 100 mm and of one 4 mm smaller along each diagonal.
    void givesMillimetres()
    {
        const auto object =
            fit({m_folder.write("square.csv", "name,ax,ay,az,mx,my,mz\n"
                                              "a,100,0,0,96,0,0\nb,0,100,0,0,96,0\n"
                                              "c,-100,0,0,-96,0,0\nd,0,-100,0,0,-96,0\n")});
        QVERIFY(object.has_value());
        QVERIFY(std::abs(number(object->value(QStringLiteral("rms_mm"))) - 4.0) < kExact_mm);
        QVERIFY(
            std::abs(number(object->value(QStringLiteral("residuals_mm"))[1][QStringLiteral("mm")])
                     - 4.0)
            < kExact_mm);
    }

    void refusesPairsThatCannotBeFitted_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<Errc>("code");
        QTest::addColumn<QString>("sentence");
        const QString head = QStringLiteral("name,ax,ay,az,mx,my,mz\n");
        QTest::newRow("empty") << QString{} << Errc::FileEmpty << QStringLiteral("is empty");
        QTest::newRow("no landmark")
            << head << Errc::TooFewLandmarks << QStringLiteral("cannot be fitted: 0 landmarks");
        QTest::newRow("a column missing")
            << QStringLiteral("name,ax,ay,az,mx,my\n") << Errc::FileMalformed
            << QStringLiteral("has no column \"mz\".");
        QTest::newRow("a field missing")
            << head + QStringLiteral("a,1,2,3,4,5\n") << Errc::FileMalformed
            << QStringLiteral("line 2 has 6 fields, not 7.");
        QTest::newRow("a word") << head + QStringLiteral("\na,1,2,3,4,x,6\n") << Errc::FileMalformed
                                << QStringLiteral("line 3: \"x\" is not a number.");
        QTest::newRow("no number")
            << head
                   + QStringLiteral("a,1,2,3,4,5,6\nb,1,nan,3,4,5,6\n"
                                    "c,7,8,9,1,2,3\n")
            << Errc::NotFinite << QStringLiteral("a landmark of the anatomy");
        QTest::newRow("on one line")
            << head + QStringLiteral("a,0,0,0,0,0,0\nb,50,0,0,50,0,0\nc,100,0,0,100,0,0\n")
            << Errc::DegenerateLandmarks << QStringLiteral("lie on one line.");
    }

    void refusesPairsThatCannotBeFitted()
    {
        QFETCH(QString, text);
        QFETCH(Errc, code);
        QFETCH(QString, sentence);
        const QString path = m_folder.write("bad.csv", text.toStdString());
        const auto object = fit({path});
        QVERIFY(!object);
        const QString detail = QString::fromStdString(object.error().detail);
        QVERIFY2(object.error().code == code, qPrintable(detail));
        QVERIFY2(detail.startsWith(path) && detail.contains(sentence), qPrintable(detail));
    }

    void fitsARecordingWhoseStylusRestedMoreOften_data()
    {
        QTest::addColumn<std::vector<Vec3>>("before");
        QTest::addColumn<std::vector<Vec3>>("after");
        QTest::addColumn<bool>("fits");
        const Vec3 rest{0.5, 0.6, 0.1};
        QTest::newRow("no more") << std::vector<Vec3>{} << std::vector<Vec3>{} << true;
        QTest::newRow("before") << std::vector<Vec3>{rest} << std::vector<Vec3>{} << true;
        QTest::newRow("before and after")
            << std::vector<Vec3>{rest, -rest} << std::vector<Vec3>{rest, -rest} << true;
        QTest::newRow("too often")
            << std::vector<Vec3>{rest, -rest, rest} << std::vector<Vec3>{rest, -rest} << false;
    }

    void fitsARecordingWhoseStylusRestedMoreOften()
    {
        QFETCH(std::vector<Vec3>, before);
        QFETCH(std::vector<Vec3>, after);
        QFETCH(bool, fits);
        const Vec3 tip_S{0.010, -0.020, 0.030};
        std::vector<Vec3> points = before;
        for (const Vec3& p_A : kLandmarks_A)
            points.push_back(kX_AM.inverse() * p_A - tip_S);
        points.insert(points.end(), after.begin(), after.end());
        const auto object =
            fit(m_folder.write("rest.igs.mha", held(points).text()), config(kLandmarks_A));
        QCOMPARE(object.has_value(), fits);
        if (!fits) {
            QCOMPARE(object.error().code, Errc::TooFewLandmarks);
            return;
        }
        constexpr double kWritten_mm = 1e-3; // six digits of each number
        QVERIFY(number(object->value(QStringLiteral("rms_mm"))) < kWritten_mm);
        QCOMPARE(object->value(QStringLiteral("dwells")).toInt(), int(points.size()));
        QCOMPARE(
            object->value(QStringLiteral("residuals_mm"))[3][QStringLiteral("name")].toString(),
            QStringLiteral("#"));
    }

    void refusesARecordingWithTooFewTouches()
    {
        const auto object = fit(m_folder.write("few.igs.mha", held({kLandmarks_A[0]}).text()),
                                config(kLandmarks_A));
        QVERIFY(!object);
        QCOMPARE(object.error().code, Errc::TooFewLandmarks);
        QVERIFY(object.error().detail.ends_with("held still 1 times for 4 landmarks."));
    }

    void refusesAConfigurationThatLacksSomething_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("sentence");
        const QString tip = QStringLiteral("<Transform From='StylusTip' To='Stylus' Matrix='%1'/>");
        const QString pose = QStringLiteral("1 0 0 1 0 1 0 2 0 0 1 3 0 0 0 1");
        QTest::newRow("no XML") << QStringLiteral("tip 1 2 3") << QStringLiteral("line 1: ");
        QTest::newRow("cut off") << QStringLiteral("<Plus><Landmarks>")
                                 << QStringLiteral("line 1: ");
        QTest::newRow("no tip") << QStringLiteral("<a><Landmark Name='1' Position='1 2 3'/></a>")
                                << QStringLiteral("no transform of 16 numbers");
        QTest::newRow("a tip of 12 numbers") << tip.arg(QStringLiteral("1 0 0 1 0 1 0 2 0 0 1 3"))
                                             << QStringLiteral("no transform of 16 numbers");
        QTest::newRow("no landmark") << tip.arg(pose) << QStringLiteral("has no landmark.");
        QTest::newRow("a landmark without a place")
            << QStringLiteral("<a><Landmark Name='1' Position='1 2'/></a>")
            << QStringLiteral("Position has not three numbers.");
    }

    void refusesAConfigurationThatLacksSomething()
    {
        QFETCH(QString, text);
        QFETCH(QString, sentence);
        const QString path = m_folder.write("bad.xml", text.toStdString());
        const auto object = fit(m_folder.write("some.igs.mha", held(kLandmarks_A).text()), path);
        QVERIFY(!object);
        const QString detail = QString::fromStdString(object.error().detail);
        QVERIFY2(object.error().code == Errc::FileMalformed, qPrintable(detail));
        QVERIFY2(detail.startsWith(path) && detail.contains(sentence), qPrintable(detail));
    }

    void refusesAnotherCommandLine_data()
    {
        QTest::addColumn<QStringList>("arguments");
        const QString recording = QStringLiteral("--recording");
        QTest::newRow("nothing") << QStringList{};
        QTest::newRow("twice the recording")
            << QStringList{recording, QStringLiteral("b"), recording, QStringLiteral("c")};
        QTest::newRow("a flag alone") << QStringList{recording};
    }

    void refusesAnotherCommandLine()
    {
        QFETCH(QStringList, arguments);
        const auto object = fit(arguments);
        QVERIFY(!object);
        QCOMPARE(object.error().code, Errc::WrongOption);
    }

    void fitsTheRecordingOfEightLandmarksAsWellAsIsKnown()
    {
        const auto folder = test::testData("tracker/eight-landmarks");
        if (!folder)
            QSKIP("tracker/eight-landmarks is not there");
        const QString path = QString::fromStdString(folder->string());
        const auto object =
            fit(path + QStringLiteral("/EightLandmarkPointsTrackedForPhantomRegistration.igs.mha"),
                path + QStringLiteral("/PlusDeviceSet_fCal_Sim_RecordPhantomLandmarks.xml"));
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QVERIFY(std::abs(number(object->value(QStringLiteral("rms_mm"))) - kKnownRms_mm)
                < kRecordedTolerance_mm);
        QCOMPARE(object->value(QStringLiteral("residuals_mm")).toArray().size(), 8);
        QCOMPARE(object->value(QStringLiteral("dwells")).toInt(), 10);
    }

    void helpNamesEveryKeyAndColumn()
    {
        for (const char* name :
             {"PAIRS.csv", "--recording", "--plus-config", "ax,ay,az", "mx,my,mz", "schema",
              "rms_mm", "residuals_mm", "X_AM_mm", "dwells"})
            QVERIFY2(pageOf(fitCommand()).contains(QLatin1StringView{name}), name);
    }
};

CARINA_TEST(TestFitCommand)

} // namespace carina::lab::fit_command_test

#include "tst_fit_command.moc"
