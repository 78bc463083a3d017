#include "apps/lab/command/command.h"
#include "apps/lab/command/help.h"
#include "apps/lab/command/words.h"
#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QJsonDocument>

#include <array>

namespace carina::lab::command_test
{
namespace
{

int runs = 0;

constexpr Option kLimit{"limit", "MM", "how far at most, in mm (3)"};
constexpr Option kRaw{"raw", "", "leaves everything as it is"};
constexpr Option kEach{"each", "WORD", "given several times", true};
constexpr Key kSchema{"schema", "carina.warn/1"};
constexpr Key kCount{"count", "how many"};

Result<QJsonObject> warn(const Words&)
{
    ++runs;
    return QJsonObject{{kWarnings, QJsonArray{QStringLiteral("It is doubtful: do it again.")}}};
}

Result<QJsonObject> refuse(const Words&)
{
    ++runs;
    return fail(Errc::OutOfRange, "It cannot be done: do something else.");
}

/// Prints the limit as a number and as a whole number.
Result<QJsonObject> count(const Words& words)
{
    const auto limit = words.number(kLimit, 0.5, 10.0, 3.0);
    const auto whole = words.whole(kLimit, 1, 10, 3);
    if (!limit || !whole)
        return tl::unexpected(limit ? whole.error() : limit.error());
    return QJsonObject{{kCount, *limit}, {kSchema, qint64(*whole)}};
}

/// Prints the words in the order in which they were given.
Result<QJsonObject> list(const Words& words)
{
    return QJsonObject{{kCount, QJsonArray::fromStringList(words.texts(kEach))}};
}

const std::array kCommands{
    Command{.name = "warn",
            .theme = "words",
            .summary = "warns",
            .uses = {{.lines = {"[--limit MM]", "--raw"},
                      .text = "Warns.",
                      .options = {kLimit, kRaw},
                      .schema = kSchema,
                      .keys = {kCount}}},
            .experiment = warn},
    Command{
        .name = "refuse", .theme = "words", .summary = "refuses", .uses = {}, .experiment = refuse},
    Command{.name = "count",
            .theme = "",
            .summary = "",
            .uses = {{.lines = {"[FILE]"}, .text = "", .options = {kLimit, kRaw}}},
            .mostFiles = 1,
            .reminder = "Look at the help.",
            .experiment = count},
    Command{.name = "list",
            .theme = "",
            .summary = "",
            .uses = {{.lines = {"--each WORD"}, .text = "", .options = {kRaw, kEach}}},
            .experiment = list}};

int status(const QStringList& words)
{
    return runCommandLine(kCommands, QStringList{QStringLiteral("carina-lab")} + words);
}

QString refusalOf(const QStringList& words)
{
    const auto result = kCommands[2].run(words);
    return result ? QString{} : QString::fromStdString(result.error().detail);
}

} // namespace

/// How a command line is read and ends.
class TestCommand : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void endsAsTheCommandDoes()
    {
        QCOMPARE(status({QStringLiteral("warn")}), 0);
        QCOMPARE(status({QStringLiteral("refuse")}), 1);
        QCOMPARE(status({QStringLiteral("other")}), 2);
        QCOMPARE(status({}), 2);
    }

    /// Of words that cannot be used, whichever part of a command finds out.
    void endsWithTwoAfterWrongWords()
    {
        QCOMPARE(status({QStringLiteral("count"), QStringLiteral("--speed")}), 2);
        QCOMPARE(status({QStringLiteral("count"), QStringLiteral("a"), QStringLiteral("b")}), 2);
        QCOMPARE(status({QStringLiteral("count"), QStringLiteral("--limit")}), 2);
        QCOMPARE(status({QStringLiteral("count"), QStringLiteral("--limit=11")}), 2);
        QCOMPARE(status({QStringLiteral("count"), QStringLiteral("--limit=7")}), 0);
    }

    void helpsWithoutRunning()
    {
        runs = 0;
        for (const char* help : {"--help", "-h"}) {
            QCOMPARE(status({QStringLiteral("refuse"), QLatin1String{help}}), 0);
            QCOMPARE(status({QLatin1String{help}}), 0);
        }
        QCOMPARE(
            status({QStringLiteral("refuse"), QStringLiteral("--raw"), QStringLiteral("--help")}),
            0);
        QCOMPARE(status({QStringLiteral("help"), QStringLiteral("warn")}), 0);
        QCOMPARE(status({QStringLiteral("help"), QStringLiteral("other")}), 2);
        QCOMPARE(runs, 0);
    }

    void tellsOfEachCommandInOneLineUnderItsTheme()
    {
        const QString overview = overviewOf(kCommands);
        QVERIFY(overview.contains(QStringLiteral("\nwords\n  warn          warns\n")));
        QVERIFY(overview.contains(QStringLiteral("\n  refuse        refuses\n")));
        QVERIFY(!overview.contains(QStringLiteral("count"))); // not for people
    }

    void aPageHasUsageOptionsAndKeys()
    {
        QCOMPARE(pageOf(kCommands[0]),
                 QStringLiteral("warn [--limit MM]\n"
                                "warn --raw\n"
                                "    Warns.\n"
                                "    --limit MM          how far at most, in "
                                "mm (3)\n"
                                "    --raw               leaves everything as "
                                "it is\n"
                                "  prints\n"
                                "    schema              "
                                "\"carina.warn/1\"\n"
                                "    count               how many\n"));
    }

    void refusesAnOptionTwiceAndOneForAValue()
    {
        const QString limit = QStringLiteral("--limit");
        QCOMPARE(refusalOf({limit, QStringLiteral("7"), limit, QStringLiteral("7")}),
                 QStringLiteral("count has --limit twice. Look at the help."));
        QCOMPARE(refusalOf({limit, QStringLiteral("--raw")}),
                 QStringLiteral("count needs a value for --limit, not --raw. Look at the help."));
    }

    void readsAnOptionThatRepeatsAsOftenAsItIsGiven()
    {
        const QString each = QStringLiteral("--each");
        const auto listed = kCommands[3].run(
            {each, QStringLiteral("b"), QStringLiteral("--raw"), each, QStringLiteral("-a")});
        QVERIFY(listed);
        QCOMPARE(listed->value(kCount).toArray(),
                 (QJsonArray{QStringLiteral("b"), QStringLiteral("-a")}));
        QVERIFY(!kCommands[3].run({each, QStringLiteral("b"), each, QStringLiteral("--raw")}));
        QVERIFY(!kCommands[3].run({QStringLiteral("--raw"), QStringLiteral("--raw")}));
    }

    void readsNumbersWithinTheirBounds()
    {
        const auto given = kCommands[2].run({QStringLiteral("--limit"), QStringLiteral("7")});
        QCOMPARE(given->value(kCount).toDouble(), 7.0);
        QCOMPARE(given->value(kSchema).toInt(), 7);
        QCOMPARE(kCommands[2].run({})->value(kCount).toDouble(), 3.0); // where nothing is given
        QCOMPARE(refusalOf({QStringLiteral("--limit"), QStringLiteral("11")}),
                 QStringLiteral("count needs --limit with a number from 0.5 to 10."));
        QCOMPARE(refusalOf({QStringLiteral("--limit"), QStringLiteral("nan")}),
                 QStringLiteral("count needs --limit with a number from 0.5 to 10."));
        QCOMPARE(refusalOf({QStringLiteral("--limit"), QStringLiteral("2.5")}),
                 QStringLiteral("count needs --limit with a whole number from 1 to 10."));
    }

    void printsTheMicrosecondsOfATime()
    {
        const QByteArray text = printed({{kCount, 1127242654.1876216}, {kSchema, -12345678.5}});
        QVERIFY2(text.contains("1127242654.187622"), text.constData());
        QVERIFY2(text.contains("-12345678.5"), text.constData());
    }

    void printsNumbersWithoutTheNoiseOfRounding()
    {
        const double sum = 0.1 + 0.2;
        const qint64 whole = 9'007'199'254'740'993; // no double has it
        const QByteArray text =
            printed({{kCount, sum},
                     {kSchema, whole},
                     {kWarnings, QJsonArray{QJsonObject{{kCount, 1e-9 * sum}}, -sum, true}}});
        QVERIFY2(!text.contains("0000000"), text.constData());
        for (const char* part : {"0.3,", "9007199254740993", "3e-10", "-0.3,", "true"})
            QVERIFY2(text.contains(part), text.constData());
        const QJsonObject back = QJsonDocument::fromJson(text).object();
        QVERIFY(std::abs(back.value(kCount).toDouble() - sum) < 1e-12 * sum);
    }

    void refusesWordsThatArePartOfNoPage()
    {
        QCOMPARE(refusalOf({QStringLiteral("--speed")}),
                 QStringLiteral("count has no option --speed. Look at the help."));
        QCOMPARE(refusalOf({QStringLiteral("a"), QStringLiteral("b")}),
                 QStringLiteral("count does not take 'b'. Look at the help."));
        QVERIFY(
            refusalOf({QStringLiteral("--limit")}).endsWith(QStringLiteral("Look at the help.")));
        QVERIFY(
            refusalOf({QStringLiteral("--raw=1")}).endsWith(QStringLiteral("Look at the help.")));
    }
};

CARINA_TEST(TestCommand)

} // namespace carina::lab::command_test

#include "tst_command.moc"
