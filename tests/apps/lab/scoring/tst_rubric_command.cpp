#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "engine/io/scoring/rubric_file.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

namespace carina::lab::rubric_command_test
{
namespace
{

/// The rubric in what the command prints.
Result<Rubric> printedRubric(const QStringList& words)
{
    return rubricCommand().run(words).and_then(
        [](const QJsonObject& object) { return rubricIn(printed(object).toStdString()); });
}

} // namespace

class TestRubricCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void printsThePublishedOneToBeChanged()
    {
        const auto rubric = printedRubric({});
        QVERIFY(rubric.has_value());
        QVERIFY(*rubric == publishedRubric());
    }

    void printsTheOneOfAFile()
    {
        const test::ScratchFolder folder;
        Rubric ours = publishedRubric();
        ours.name = "Our course";
        ours.criteria.resize(3);
        ours.criteria.front().limit = 42.5;
        const QString file = folder.write("ours.json", printed(jsonRubric(ours)));
        const auto rubric = printedRubric({file});
        QVERIFY(rubric.has_value());
        QVERIFY(*rubric == ours);
    }

    void saysWhatIsWrongInAFile()
    {
        const test::ScratchFolder folder;
        const QString file = folder.write("ours.json", R"({"schema": "carina.rubric/1"})");
        const auto refused = rubricCommand().run({file});
        QCOMPARE(refused.error().code, Errc::FileMalformed);
        QVERIFY(refused.error().detail.find("ours.json: name") != std::string::npos);
        QCOMPARE(rubricCommand().run({file, file}).error().code, Errc::WrongOption);
    }

    void namesEachMetricOnItsPage()
    {
        const QString page = pageOf(rubricCommand());
        for (std::size_t i = 0; i < kMetricCount; ++i)
            QVERIFY2(page.contains(QLatin1StringView{entryOf(static_cast<Metric>(i)).word}),
                     entryOf(static_cast<Metric>(i)).word);
    }
};

CARINA_TEST(TestRubricCommand)

} // namespace carina::lab::rubric_command_test

#include "tst_rubric_command.moc"
