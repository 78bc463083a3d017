#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

#include <cmath>

namespace carina::lab::fit_report_test
{
namespace
{

constexpr double kExact_mm = 1e-9;

double number(const QJsonValue& value) { return value.toDouble(std::nan("")); }

} // namespace

/// What `carina-lab fit` says of touched landmarks beside the pose.
class TestFitReport : public QObject
{
    Q_OBJECT

private:
    test::ScratchFolder m_folder;

    static Result<QJsonObject> fit(const QStringList& arguments)
    {
        return fitCommand().run(arguments);
    }
    /// Touches of a and b exchanged.
    QString exchanged() const
    {
        return m_folder.write("order.csv", "name,ax,ay,az,mx,my,mz\n"
                                           "a,100,0,0,0,150,0\nb,0,150,0,100,0,0\n"
                                           "c,0,0,210,0,0,210\nd,0,0,0,0,0,0\n");
    }

private Q_SLOTS:
    /// A tetrahedron of which one corner was touched 8 mm from its place. With one order and four
    /// landmarks the FLE is root 2 times the FRE and its limit 1.9155 times that: the root of 6
    /// over 1.6354, the 5 % quantile of chi-squared with 6 degrees of freedom.
    void describesWhatTheResidualsTell()
    {
        const auto object = fit({m_folder.write("off.csv", "name,ax,ay,az,mx,my,mz\n"
                                                           "a,100,0,0,100,0,0\nb,0,150,0,0,150,0\n"
                                                           "c,0,0,210,0,0,210\nd,0,0,0,8,0,0\n"),
                                 QStringLiteral("--fle"), QStringLiteral("5")});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        const double rms = number(object->value(QStringLiteral("rms_mm")));
        const QJsonValue fle = object->value(QStringLiteral("fle_mm"));
        QVERIFY(std::abs(number(fle[QStringLiteral("rms")]) / rms - std::sqrt(2.0)) < kExact_mm);
        QVERIFY(std::abs(number(fle[QStringLiteral("limit95")]) / number(fle[QStringLiteral("rms")])
                         - 1.9155)
                < 1e-3);
        QCOMPARE(number(fle[QStringLiteral("degrees")]), 6.0);
        const QJsonValue left = object->value(QStringLiteral("leave_one_out_mm"));
        QCOMPARE(left[3][QStringLiteral("name")].toString(), QStringLiteral("d"));
        QVERIFY(std::abs(number(left[3][QStringLiteral("mm")]) - 8.0) < kExact_mm);
        const QJsonValue order = object->value(QStringLiteral("order"));
        QCOMPARE(order[QStringLiteral("found")].toString(), QStringLiteral("as given"));
        QCOMPARE(number(order[QStringLiteral("rms_mm")]), rms);
        QCOMPARE(order[QStringLiteral("explanations")].toInt(), 1);
        const auto sure =
            fit({m_folder.filePath("off.csv"), QStringLiteral("--fle"), QStringLiteral("0.5")});
        QCOMPARE(sure->value(QStringLiteral("order"))[QStringLiteral("found")].toString(),
                 QStringLiteral("unexplained"));
        QVERIFY(sure->value(QStringLiteral("warnings"))[0].toString().contains(
            QStringLiteral("touch it again")));
    }

    void refusesALandmarkThatStandsThereTwice()
    {
        const QString file = m_folder.write("twice.csv", "name,ax,ay,az,mx,my,mz\n"
                                                         "a,100,0,0,100,0,0\nb,0,150,0,0,150,0\n"
                                                         "c,0,0,210,0,0,210\nb,0,150,0,0,150,0\n");
        const auto object = fit({file});
        QVERIFY(!object);
        QCOMPARE(object.error(),
                 (Error{Errc::FileMalformed,
                        file.toStdString() + " names the landmark b twice; leave one out."}));
    }

    void namesExchangedLandmarksAndFitsThemNot()
    {
        const auto object = fit({exchanged()});
        QVERIFY(!object);
        QCOMPARE(object.error().code, Errc::DegenerateLandmarks);
        const std::string& sentence = object.error().detail;
        for (const char* named :
             {"order.csv", "a has the touch of b, b has the touch of a;", "--repair-order (a"})
            QVERIFY2(sentence.find(named) != std::string::npos, sentence.c_str());
        QVERIFY2(sentence.find("c has") == std::string::npos, sentence.c_str());
    }

    void repairsTheirOrderOnRequest()
    {
        const auto object = fit({exchanged(), QStringLiteral("--repair-order")});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        const QJsonValue order = object->value(QStringLiteral("order"));
        QCOMPARE(order[QStringLiteral("found")].toString(), QStringLiteral("exchanged"));
        QCOMPARE(order[QStringLiteral("touch_of")].toArray(),
                 (QJsonArray{QStringLiteral("b"), QStringLiteral("a"), QStringLiteral("c"),
                             QStringLiteral("d")}));
        QVERIFY(number(order[QStringLiteral("rms_mm")]) < kExact_mm);
        QVERIFY(number(object->value(QStringLiteral("rms_mm"))) < kExact_mm);
        QVERIFY(!object->contains(QStringLiteral("warnings")));
    }

    /// No order of these is their mirror image: nothing can be repaired.
    void refusesAMirrorImage()
    {
        const QString file = m_folder.write("mirror.csv", "name,ax,ay,az,mx,my,mz\n"
                                                          "a,100,0,0,-100,0,0\nb,0,150,0,0,150,0\n"
                                                          "c,0,0,210,0,0,210\nd,0,0,0,0,0,0\n");
        for (const QStringList& options : {QStringList{}, {QStringLiteral("--repair-order")}}) {
            const auto object = fit(QStringList{file} + options);
            QVERIFY(!object);
            QVERIFY(object.error().detail.find("mirror image") != std::string::npos);
        }
    }

    /// There a mirror image is an exchange, too, but no cycle of three is one.
    void saysThatASignMayBeWrongWhereTheLayoutIsSymmetric()
    {
        const QString head = QStringLiteral("name,ax,ay,az,mx,my,mz\n");
        const auto why = [&](const char* rows) {
            const auto object = fit({m_folder.write("sign.csv", head.toStdString() + rows)});
            return object ? QString{} : QString::fromStdString(object.error().detail);
        };
        const QString mirrored = why("left,-50,0,0,50,0,0\nright,50,0,0,-50,0,0\n"
                                     "chin,0,120,0,0,120,0\nnotch,0,30,80,0,30,80\n");
        QVERIFY2(mirrored.contains(QStringLiteral("left has the touch of right"))
                     && mirrored.contains(QStringLiteral("a wrong sign of one axis")),
                 qPrintable(mirrored));
        const QString cycle = why("a,100,0,0,0,150,0\nb,0,150,0,0,0,210\n"
                                  "c,0,0,210,100,0,0\nd,0,0,0,0,0,0\n");
        QVERIFY2(cycle.endsWith(QStringLiteral("or add --repair-order.")), qPrintable(cycle));
    }

    /// Three landmarks 100 mm long and so wide: by 10 mm an error of 1 mm beside their line is
    /// 3 mm, by 30 mm it is 1.2 mm (Fitzpatrick, West and Maurer's formula by hand).
    void warnsOfLandmarksNearlyOnALine_data()
    {
        QTest::addColumn<int>("width_mm");
        QTest::addColumn<bool>("warns");
        QTest::newRow("narrow") << 10 << true;
        QTest::newRow("wide") << 30 << false;
    }
    void warnsOfLandmarksNearlyOnALine()
    {
        QFETCH(int, width_mm);
        QFETCH(bool, warns);
        const std::string width = std::to_string(width_mm);
        const QString file = m_folder.write(
            "line.csv", "name,ax,ay,az,mx,my,mz\na,0,0,0,0,0,0\nb,100,0,0,100,0,0\nc,50," + width
                            + ",0,50," + width + ",0\n");
        const auto object = fit({file, QStringLiteral("--fle"), QStringLiteral("1")});
        QVERIFY(object.has_value());
        const QJsonArray warnings = object->value(QStringLiteral("warnings")).toArray();
        QCOMPARE(warnings.size(), warns ? 1 : 0);
        if (warns)
            QVERIFY2(warnings[0].toString().contains(QStringLiteral("an error of 3.0 mm (RMS)")),
                     qPrintable(warnings[0].toString()));
    }

    void saysNothingOfThreeLandmarksLeftOut()
    {
        const auto object =
            fit({m_folder.write("three.csv", "name,ax,ay,az,mx,my,mz\n"
                                             "a,100,0,0,100,0,0\nb,0,150,0,0,150,0\n"
                                             "c,0,0,210,0,0,210\n")});
        QVERIFY(object.has_value());
        QVERIFY(
            object->value(QStringLiteral("leave_one_out_mm"))[2][QStringLiteral("mm")].isNull());
    }

    /// The corners of a square, one of them pulled out by 4 mm along x where it is known to 0.1 mm
    /// only across: the weighed fit lets it go.
    void weighsByCovariance()
    {
        const std::string ball = ",1,1,1,0,0,0\n";
        const QString file =
            m_folder.write("weighed.csv", "name,ax,ay,az,mx,my,mz,cxx,cyy,czz,cxy,cxz,cyz\n"
                                          "a,100,0,0,104,0,0,1e6,1,1,0,0,0\n"
                                          "b,0,100,0,0,100,0"
                                              + ball + "c,-100,0,0,-100,0,0" + ball
                                              + "d,0,-100,0,0,-100,0" + ball);
        const auto object = fit({file, QStringLiteral("--covariance")});
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        const QJsonArray residuals = object->value(QStringLiteral("residuals_mm")).toArray();
        QVERIFY(std::abs(number(residuals[0][QStringLiteral("mm")]) - 4.0) < 1e-4);
        QVERIFY(number(residuals[2][QStringLiteral("mm")]) < 1e-4);
        QCOMPARE(number(object->value(QStringLiteral("degrees"))), 6.0);
        const double chiSquared = number(object->value(QStringLiteral("chi_squared")));
        QVERIFY(std::abs(chiSquared - 16e-6) < 1e-8);
        QVERIFY(std::abs(number(object->value(QStringLiteral("scale"))) - chiSquared / 6.0)
                < 1e-15);
        QVERIFY(object->contains(QStringLiteral("order")));
        QVERIFY(!object->contains(QStringLiteral("fle_mm")));
    }

    void refusesCovariancesThatAreNone()
    {
        const auto object =
            fit({m_folder.write("none.csv", "name,ax,ay,az,mx,my,mz,cxx,cyy,czz,cxy,cxz,cyz\n"
                                            "a,100,0,0,104,0,0,-1,1,1,0,0,0\n"
                                            "b,0,100,0,0,100,0,1,1,1,0,0,0\n"
                                            "c,-100,0,0,-100,0,0,1,1,1,0,0,0\n"),
                 QStringLiteral("--covariance")});
        QVERIFY(!object);
        QCOMPARE(object.error().code, Errc::OutOfRange);
        QVERIFY(object.error().detail.find("cannot be fitted") != std::string::npos);
    }

    void refusesAnotherOption_data()
    {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QString>("sentence");
        const QString fle = QStringLiteral("--fle");
        const QString positive = QStringLiteral("--fle needs a number of millimetres above 0.");
        QTest::newRow("another flag")
            << QStringList{QStringLiteral("--fast")} << QStringLiteral("fit has no option --fast.");
        QTest::newRow("no error") << QStringList{fle}
                                  << QStringLiteral("fit: Missing value after '--fle'.");
        QTest::newRow("an error of nothing") << QStringList{fle, QStringLiteral("0")} << positive;
        QTest::newRow("an error that is no number")
            << QStringList{fle, QStringLiteral("nan")} << positive;
    }

    void refusesAnotherOption()
    {
        QFETCH(QStringList, options);
        QFETCH(QString, sentence);
        const auto object = fit(QStringList{QStringLiteral("pairs.csv")} + options);
        QVERIFY(!object);
        QCOMPARE(object.error().code, Errc::WrongOption);
        QCOMPARE(QString::fromStdString(object.error().detail), sentence);
    }

    void helpNamesEveryKeyAndFlag()
    {
        for (const char* name :
             {"--covariance", "--fle", "cxx,cyy,czz,cxy,cxz,cyz", "fle_mm", "limit95", "degrees",
              "leave_one_out_mm", "order", "found", "touch_of", "explanations", "chi_squared",
              "scale", "--repair-order", "warnings", "example"})
            QVERIFY2(pageOf(fitCommand()).contains(QLatin1StringView{name}), name);
    }
};

CARINA_TEST(TestFitReport)

} // namespace carina::lab::fit_report_test

#include "tst_fit_report.moc"
