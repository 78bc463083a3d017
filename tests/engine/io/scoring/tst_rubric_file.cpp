#include "engine/io/scoring/rubric_file.h"

#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

#include <QJsonDocument>

namespace carina::rubric_file_test
{
namespace
{

const std::string kRubric = R"({"schema": "carina.rubric/1", "name": "Our course",
    "source": "Skills laboratory",
    "criteria": [{"metric": "time_to_breath_s", "at_most": 60, "points": 5},
                 {"metric": "in_trachea", "at_least": 1, "points": 5, "penalty": 10,
                  "name": "In the trachea"}]})";

std::string textOf(const Rubric& rubric)
{
    return QJsonDocument{jsonRubric(rubric)}.toJson().toStdString();
}

/// The rubric with one part of its text replaced.
std::string with(const std::string& part, const std::string& other)
{
    std::string text = kRubric;
    return text.replace(text.find(part), part.size(), other);
}

} // namespace

class TestRubricFile : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void readsWhatItIsMadeOf();
    void readsWhatItWrites();
    void saysWhatIsWrong_data();
    void saysWhatIsWrong();
    void takesNoMoreThanItsMost();
    void namesTheFile();
};

void TestRubricFile::readsWhatItIsMadeOf()
{
    const Rubric rubric = rubricIn(kRubric).value();
    QCOMPARE(rubric.name, std::string{"Our course"});
    QCOMPARE(rubric.source, std::string{"Skills laboratory"});
    QCOMPARE(rubric.criteria.size(), std::size_t{2});
    QVERIFY((
        rubric.criteria[0]
        == Criterion{
            .metric = Metric::TimeToBreath, .bound = Bound::AtMost, .limit = 60.0, .points = 5.0}));
    QVERIFY((rubric.criteria[1]
             == Criterion{.name = "In the trachea",
                          .metric = Metric::InTrachea,
                          .limit = 1.0,
                          .points = 5.0,
                          .penalty = 10.0}));
}

void TestRubricFile::readsWhatItWrites()
{
    for (const Rubric& rubric : {publishedRubric(), rubricIn(kRubric).value()})
        QVERIFY(rubricIn(textOf(rubric)).value() == rubric);
}

void TestRubricFile::saysWhatIsWrong_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QByteArray>("said");
    const auto row = [](const char* name, const std::string& text, const char* said) {
        QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray{said};
    };
    row("no JSON", "{", "at byte");
    row("a list", "[]", "schema: a text is expected");
    row("another schema", with("carina.rubric/1", "carina.site/1"), "it is carina.site/1");
    row("no name", with("\"Our course\"", "\"\""), "name: a text is expected");
    row("an unknown key", with("\"source\"", "\"sourse\""), "sourse: this key is not known");
    row("an unknown metric", with("time_to_breath_s", "speed"),
        "criteria[0].metric: \"speed\" is none of its words");
    row("no limit", with("\"at_most\": 60,", ""), "either at_most or at_least");
    row("two limits", with("\"at_most\": 60,", "\"at_most\": 60, \"at_least\": 1,"),
        "either at_most or at_least");
    row("a text for a limit", with("60", "\"60\""), "criteria[0].at_most: a number is expected");
    row("a limit beyond all numbers", with("60", "1e999"), "at byte");
    row("a limit that is no number", with("60", "NaN"), "at byte");
    row("a limit above a million", with("60", "1e9"), "criteria[0].at_most: a number is expected");
    row("very deep lists", with("60", std::string(5000, '[')), "at byte");
    row("a penalty below 0", with("\"penalty\": 10", "\"penalty\": -10"),
        "criteria[1].penalty: a number that is not negative");
    row("no points", with("\"points\": 5,", ""), "criteria[1].points");
    row("no criteria", R"({"schema": "carina.rubric/1", "name": "x", "criteria": []})",
        "criteria: 1 to 100 are expected");
}

void TestRubricFile::saysWhatIsWrong()
{
    QFETCH(const QByteArray, text);
    QFETCH(const QByteArray, said);
    const auto rubric = rubricIn(text.toStdString());
    QVERIFY(!rubric);
    QVERIFY2(rubric.error().detail.find(said.toStdString()) != std::string::npos,
             rubric.error().detail.c_str());
}

void TestRubricFile::takesNoMoreThanItsMost()
{
    Rubric rubric = publishedRubric();
    rubric.criteria.resize(kMostCriteria);
    QVERIFY(rubricIn(textOf(rubric)));
    rubric.criteria.resize(kMostCriteria + 1);
    QVERIFY(!rubricIn(textOf(rubric)));
}

void TestRubricFile::namesTheFile()
{
    const test::ScratchFolder folder;
    const auto read = [](const QString& file) { return readRubricFile(file.toStdString()); };
    QCOMPARE(read(folder.filePath("none.json")).error().code, Errc::FileNotFound);
    QVERIFY(read(folder.write("rubric.json", kRubric)));
    const QString other = folder.write("other.json", "{}");
    QVERIFY(read(other).error().detail.starts_with(other.toStdString()));
}

CARINA_TEST(TestRubricFile)

} // namespace carina::rubric_file_test

#include "tst_rubric_file.moc"
