#include "engine/anatomy/patient/patient_name.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::patient_name_test
{

class TestPatientName : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsTheBuiltInPatients();
    void aChildIsABoyUnlessAGirlIsAskedFor();
    void anAirwayIsSaidInMillimetres();
    void readsFiguresInAnyOrder_data();
    void readsFiguresInAnyOrder();
    void refusesWhatSaysNoPatient_data();
    void refusesWhatSaysNoPatient();
    void understandsFiguresThatAreOutOfRange();
    void saysTheAgeOfASmallChildInMonths_data();
    void saysTheAgeOfASmallChildInMonths();
    void namesEveryPatientByAHashThatSaysHowToMakeThem();
    void takesNothingElseForAHash_data();
    void takesNothingElseForAHash();
};

void TestPatientName::knowsTheBuiltInPatients()
{
    QVERIFY(patientFromWords("adult") == parametersOf(BuiltinPatient::Adult));
    QVERIFY(patientFromWords("child") == parametersOf(BuiltinPatient::TwelveYears));
    QVERIFY(patientFromWords("child")->sex == Sex::Male); // as the manikin of 2004
    QVERIFY(patientFromWords("30 years, 175 cm, man") == parametersOf(BuiltinPatient::Adult));
    QCOMPARE(nameOf(parametersOf(BuiltinPatient::Adult)), std::string{"Adult"});
    QCOMPARE(nameOf(parametersOf(BuiltinPatient::TwelveYears)),
             std::string{"12 years, 150 cm, boy"});
    QCOMPARE(nameOf({12.0, metres(1.5), Sex::Female, Habitus::Normal, {}}),
             std::string{"12 years, 150 cm, girl"});
    QCOMPARE(nameOf({18.0, metres(1.7), Sex::Female, Habitus::Slim}),
             std::string{"18 years, 170 cm, woman, slim"});
}

void TestPatientName::aChildIsABoyUnlessAGirlIsAskedFor()
{
    const auto girl = patientFromWords("child, girl");
    QVERIFY(girl && girl->sex == Sex::Female && girl->ageInYears == 12.0);
    QVERIFY(patientFromWords("girl, child") == girl);
    QVERIFY(patientFromWords("12 years, 150 cm, girl") == girl);
    QVERIFY(patientFromWords("child, boy") == parametersOf(BuiltinPatient::TwelveYears));
    QVERIFY(!patientFromWords("child, 13 years"));
    QVERIFY(!patientFromWords("child, adult"));
}

void TestPatientName::anAirwayIsSaidInMillimetres()
{
    for (const char* words : {"adult, airway 250 mm", "30 years, 175 cm, man, 250mm"}) {
        const auto read = patientFromWords(words);
        QVERIFY2(read.has_value(), words);
        QVERIFY(std::abs(read->teethToCarina->si - 0.25) < 1e-12);
        QCOMPARE(nameOf(*read), std::string{"30 years, 175 cm, man, airway 250 mm"});
        QVERIFY(patientFromWords(nameOf(*read)) == read);
        QVERIFY(parametersOfHash(madeHash(*read)) == *read);
    }
    for (const char* words : {"adult, airway 250", "adult, airway 250 cm", "adult, airway mm",
                              "adult, 250 mm, 250 mm", "adult, airway 30 years"})
        QVERIFY2(!patientFromWords(words), words);
    QVERIFY(QString::fromStdString(patientFromWords("adult, airway 300 mm").error().detail)
                .contains(QStringLiteral("204 to 276 mm")));
}

void TestPatientName::readsFiguresInAnyOrder_data()
{
    QTest::addColumn<QByteArray>("words");
    QTest::addColumn<double>("age");
    QTest::addColumn<double>("height_m");
    QTest::addColumn<Sex>("sex");
    QTest::addColumn<Habitus>("habitus");
    const auto row = [](const char* words, double age, double height_m, Sex sex, Habitus habitus) {
        QTest::newRow(words) << QByteArray{words} << age << height_m << sex << habitus;
    };
    row("45 years, 182 cm, man, obese", 45.0, 1.82, Sex::Male, Habitus::Obese);
    row("girl,slim,8y,128cm", 8.0, 1.28, Sex::Female, Habitus::Slim);
    row("  female , 90 years,  210 cm ", 90.0, 2.1, Sex::Female, Habitus::Normal);
    row("45 Years, 182 CM, Man, OBESE", 45.0, 1.82, Sex::Male, Habitus::Obese);
    row("6y, 100cm, boy, normal", 6.0, 1.0, Sex::Male, Habitus::Normal);
}

void TestPatientName::readsFiguresInAnyOrder()
{
    QFETCH(QByteArray, words);
    const auto read = patientFromWords(words.toStdString());
    QVERIFY2(read.has_value(), read ? "" : read.error().detail.c_str());
    QTEST(read->ageInYears, "age");
    QTEST(read->height.si, "height_m");
    QTEST(read->sex, "sex");
    QTEST(read->habitus, "habitus");
}

void TestPatientName::refusesWhatSaysNoPatient_data()
{
    QTest::addColumn<QByteArray>("words");
    QTest::addColumn<QString>("asked");
    const auto row = [](const char* words, const char* asked) {
        QTest::newRow(words) << QByteArray{words} << QString::fromLatin1(asked);
    };
    row("", "adult, child, or age");
    row("giant", "'giant' is not understood");
    row("45 years, 182 cm, purple", "'purple'");
    row("40.5 years, 182 cm, man", "'40.5 years'");
    row("91 years, 170 cm", "the sex is missing");
    row("45 years, 182 cm", "the sex is missing");
    row("45 years, man", "the height is missing");
    row("182 cm, man", "the age is missing");
    row("45, 182, man", "age (newborn to 90 years), height");
    row("45 years, 45 years, 182 cm, man", "age (newborn to 90 years), height");
    row("45 years, 182 cm, man, woman", "age (newborn to 90 years), height");
    row("45 years, 182 cm, man, slim, obese", "age (newborn to 90 years), height");
    row("45 years, 182 cm, man,", "age (newborn to 90 years), height");
    row("45 years, 99999999999 cm, man", "age (newborn to 90 years), height");
    row("-1 years, 50 cm, boy", "0 to 90 years");
    row("91 years, 170 cm, woman", "0 to 90 years");
    row("72 months, 110 cm, boy", "'72 months'");
    row("newborn, 3 months, 60 cm, boy", "'3 months'");
    row("1 year, 3 months, 75 cm, boy", "'3 months'");
    row("newborn, 62 cm, girl", "45 to 60 cm at this age");
    row("7 years, 99 cm, boy", "100 to 210 cm");
    row("30 years, 211 cm, man", "100 to 210 cm");
}

void TestPatientName::refusesWhatSaysNoPatient()
{
    QFETCH(QByteArray, words);
    QFETCH(QString, asked);
    const auto read = patientFromWords(words.toStdString());
    QVERIFY(!read && read.error().code == Errc::OutOfRange);
    QVERIFY2(QString::fromStdString(read.error().detail).contains(asked),
             read.error().detail.c_str());
}

void TestPatientName::understandsFiguresThatAreOutOfRange()
{
    const auto said = parametersFromWords("95 years, 300 cm, man, 1 mm");
    QVERIFY(said && said->ageInYears == 95.0 && said->teethToCarina);
    QVERIFY(std::abs(said->height.si - 3.0) < 1e-12);
    QVERIFY(!patientFromWords("95 years, 300 cm, man, 1 mm"));
    QVERIFY(!parametersFromWords("95 years, 300 cm"));
    QVERIFY(parametersFromWords("adult") == patientFromWords("adult"));
}

void TestPatientName::saysTheAgeOfASmallChildInMonths_data()
{
    QTest::addColumn<QByteArray>("words");
    QTest::addColumn<double>("months");
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("hash");
    const auto row = [](const char* words, double months, const char* name, const char* hash) {
        QTest::newRow(words) << QByteArray{words} << months << QByteArray{name} << QByteArray{hash};
    };
    row("newborn, 50 cm, girl", 0.0, "newborn, 50 cm, girl", "builtin-0mo-50cm-female-normal-12");
    row("0 months, 50cm, girl", 0.0, "newborn, 50 cm, girl", "builtin-0mo-50cm-female-normal-12");
    row("1 month, 54 cm, boy", 1.0, "1 month, 54 cm, boy", "builtin-1mo-54cm-male-normal-12");
    row("3mo, 60 cm, boy, slim", 3.0, "3 months, 60 cm, boy, slim",
        "builtin-3mo-60cm-male-slim-12");
    row("12 months, 75 cm, girl", 12.0, "1 year, 75 cm, girl", "builtin-1y-75cm-female-normal-12");
    row("1 year, 75 cm, girl", 12.0, "1 year, 75 cm, girl", "builtin-1y-75cm-female-normal-12");
    row("30 months, 91 cm, girl", 30.0, "30 months, 91 cm, girl",
        "builtin-30mo-91cm-female-normal-12");
    row("5 years, 110 cm, boy", 60.0, "5 years, 110 cm, boy", "builtin-5y-110cm-male-normal-12");
}

void TestPatientName::saysTheAgeOfASmallChildInMonths()
{
    QFETCH(QByteArray, words);
    QFETCH(double, months);
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, hash);
    const auto read = patientFromWords(words.toStdString());
    QVERIFY2(read.has_value(), read ? "" : read.error().detail.c_str());
    QCOMPARE(read->ageInYears, months / 12.0);
    QCOMPARE(QByteArray::fromStdString(nameOf(*read)), name);
    QVERIFY(patientFromWords(nameOf(*read)) == read);
    QCOMPARE(QByteArray::fromStdString(madeHash(*read)), hash);
    QVERIFY(parametersOfHash(madeHash(*read)) == *read);
}

void TestPatientName::namesEveryPatientByAHashThatSaysHowToMakeThem()
{
    QCOMPARE(madeHash(parametersOf(BuiltinPatient::Adult)), std::string{"builtin-adult-12"});
    for (const double age : {6.0, 12.0, 30.0, 90.0})
        for (const int height_cm : {100, 150, 175, 210})
            for (const Sex sex : {Sex::Female, Sex::Male})
                for (const Habitus habitus : {Habitus::Slim, Habitus::Normal, Habitus::Obese}) {
                    const PatientParameters who{age, metres(height_cm / 100.0), sex, habitus, {}};
                    QVERIFY(parametersOfHash(madeHash(who)) == who);
                }
}

void TestPatientName::takesNothingElseForAHash_data()
{
    QTest::addColumn<QByteArray>("text");
    for (const char* text :
         {"", "adult", "builtin-", "builtin-2", "builtin-adult", "builtin-adult-1",
          "builtin-30y-175cm-male-normal-12", // the adult has a hash of its own
          "builtin-045y-182cm-male-obese-12", "builtin-45y-182cm-man-obese-12",
          "builtin-182cm-45y-male-obese-12", "builtin-45y-182cm-male-12",
          "builtin-5y-182cm-male-obese-12", "builtin-0y-50cm-male-normal-12",
          "builtin-12mo-75cm-male-normal-12", "builtin-03mo-60cm-male-normal-12",
          "builtin-45y-182cm-male-obese-2", "builtin-45y-182cm-male-obese-8x",
          "../builtin-45y-182cm-male-obese-12"})
        QTest::newRow(text) << QByteArray{text};
}

void TestPatientName::takesNothingElseForAHash()
{
    QFETCH(QByteArray, text);
    QVERIFY(!parametersOfHash(text.toStdString()));
}

CARINA_TEST(TestPatientName)

} // namespace carina::patient_name_test

#include "tst_patient_name.moc"
