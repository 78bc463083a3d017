#include "apps/program/options/try_option.h"

#include "tests/models/scoring/tried_session.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_class.h"

namespace carina::try_option_test
{
namespace
{

constexpr const char* kOneCriterion = R"({"schema": "carina.rubric/1", "name": "Our course",
    "criteria": [{"metric": "in_trachea", "at_least": 1, "points": 5}]})";

/// A program that is started with these words, and a try at its station.
struct Started : test::TriedSession {
    Result<void> with(const QStringList& words)
    {
        QCommandLineParser parser;
        program::addTryOptions(parser);
        if (!parser.parse(QStringList{QStringLiteral("program")} + words))
            return fail(Errc::WrongOption, parser.errorText().toStdString());
        return program::readTryOptions(parser, tries);
    }
    [[nodiscard]] TryReport tried()
    {
        intubate();
        endTry();
        return tries.report().value();
    }
};

} // namespace

class TestTryOption : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void judgesAsPublishedUnlessAsked()
    {
        Started started;
        QVERIFY(started.with({}));
        const TryReport report = started.tried();
        QVERIFY(report.rubric == publishedRubric());
        QCOMPARE(report.rule, DepthRule::TenthOfHeight);
    }

    void judgesByARubricOfAFile()
    {
        const test::ScratchFolder folder;
        Started started;
        QVERIFY(
            started.with({QStringLiteral("--rubric"), folder.write("rubric.json", kOneCriterion)}));
        const TryReport report = started.tried();
        QCOMPARE(report.rubric.name, std::string{"Our course"});
        QCOMPARE(report.score.points, 5.0);
    }

    void takesEachRuleByItsWord()
    {
        for (std::size_t i = 0; i < kDepthRules.size(); ++i) {
            Started started;
            QVERIFY(started.with(
                {QStringLiteral("--depth-rule"), QString::fromLatin1(kDepthRuleWords.at(i))}));
            QCOMPARE(started.tried().rule, kDepthRules.at(i));
        }
    }

    void refusesWhatIsNone()
    {
        Started started;
        const auto rule = started.with({QStringLiteral("--depth-rule"), QStringLiteral("deep")});
        QCOMPARE(rule.error().code, Errc::WrongOption);
        QVERIFY(rule.error().detail.find("half-of-age") != std::string::npos);
        const auto rubric = started.with({QStringLiteral("--rubric"), QStringLiteral("/none")});
        QCOMPARE(rubric.error().code, Errc::FileNotFound);
    }
};

CARINA_TEST(TestTryOption)

} // namespace carina::try_option_test

#include "tst_try_option.moc"
