#include "apps/instructor/console_options.h"

#include "tests/support/test_class.h"

#include <QCommandLineParser>

namespace carina::console_options_test
{

class TestConsoleOptions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void asksFirstUnlessASessionIsSpokenOf_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<bool>("asksFirst");
        const auto row = [](const char* name, const QStringList& words, bool asksFirst) {
            QTest::newRow(name) << words << asksFirst;
        };
        const QString file = QStringLiteral("file");
        row("nothing", {}, true);
        row("a folder", {QStringLiteral("--data"), file}, true);
        row("a size", {QStringLiteral("--size"), QStringLiteral("1280x800")}, true);
        row("a site", {QStringLiteral("--site"), file}, true);
        row("a script", {QStringLiteral("--script"), file}, true);
        row("a site and a port",
            {QStringLiteral("--site"), file, QStringLiteral("--port"), QStringLiteral("0")}, false);
        row("a new session", {QStringLiteral("--new")}, false);
        row("who can join", {QStringLiteral("--by-link")}, false);
        row("a patient", {QStringLiteral("--patient"), QStringLiteral("adult")}, false);
        row("an intubation", {QStringLiteral("--play"), QStringLiteral("good")}, false);
        row("the start page", {QStringLiteral("--new"), QStringLiteral("--start-page")}, true);
    }
    void asksFirstUnlessASessionIsSpokenOf()
    {
        QFETCH(const QStringList, words);
        QFETCH(const bool, asksFirst);
        QCommandLineParser parser;
        addConsoleOptions(parser);
        QVERIFY2(parser.parse(QStringList{QStringLiteral("carina-instructor")} + words),
                 qPrintable(parser.errorText()));
        const auto options = consoleOptions(parser);
        QVERIFY(options);
        QCOMPARE(options->asksFirst, asksFirst);
    }

    void assistsAtTheIntubationThatIsNamed()
    {
        const auto read = [](const char* play) {
            QCommandLineParser parser;
            addConsoleOptions(parser);
            parser.parse({QStringLiteral("carina-instructor"), QStringLiteral("--play"),
                          QString::fromLatin1(play)});
            return consoleOptions(parser);
        };
        const auto options = read("neck_flexed,seed=3");
        QVERIFY(options && options->played);
        QCOMPARE(options->played->kind, MotionKind::NeckFlexed);
        QCOMPARE(options->played->seed, 3U);
        for (const char* wrong : {"perfect", "good,seed=x", "good,after=5", "good,rate=30"})
            QVERIFY2(!read(wrong), wrong);
    }

    void namesTheOptionsThatKeepTheStartPage()
    {
        QCommandLineParser parser;
        addConsoleOptions(parser);
        const QString help = parser.helpText().simplified();
        QVERIFY2(help.contains(QStringLiteral("any but --data, --size, --site, --script the")),
                 qPrintable(help));
    }
};

CARINA_TEST(TestConsoleOptions)

} // namespace carina::console_options_test

#include "tst_console_options.moc"
