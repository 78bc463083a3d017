#include "apps/lab/command/help.h"
#include "apps/lab/commands.h"
#include "tests/support/test_class.h"

#include <QJsonArray>
#include <QRegularExpression>
#include <QSet>

namespace carina::lab::pages_test
{
namespace
{

constexpr qsizetype kScreenLines = 44;
constexpr qsizetype kScreenColumns = 100;

/// Names of all keys in an object and in what it holds.
void gatherKeys(const QJsonValue& value, QSet<QString>& names)
{
    for (const QJsonValue each : value.toArray())
        gatherKeys(each, names);
    const QJsonObject object = value.toObject();
    for (auto each = object.begin(); each != object.end(); ++each) {
        names.insert(each.key());
        gatherKeys(each.value(), names);
    }
}

const Command& commandNamed(const QString& name)
{
    return *std::ranges::find_if(commands(), [&](const Command& command) {
        return name == QLatin1StringView{command.name};
    });
}

} // namespace

/// The pages of carina-lab, as `carina-lab help` shows them.
class TestPages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theOverviewFitsOnAScreen()
    {
        const QStringList lines = overviewOf(commands()).split(QLatin1Char('\n'));
        QVERIFY2(lines.size() <= kScreenLines, qPrintable(QString::number(lines.size())));
        for (const QString& line : lines)
            QVERIFY2(line.size() <= kScreenColumns, qPrintable(line));
    }

    void eachPageIsWholeAndFitsInItsWidth()
    {
        static const QRegularExpression kSchemaForm{QStringLiteral("^carina\\.[a-z.-]+/[0-9]+$")};
        for (const Command& command : commands()) {
            if (*command.theme == '\0')
                continue;
            QVERIFY2(*command.summary != '\0' && !command.uses.empty(), command.name);
            QVERIFY2(!command.uses.front().keys.empty(), command.name);
            for (const Use& use : command.uses) {
                QVERIFY2(kSchemaForm.match(QString::fromLatin1(use.schema.help)).hasMatch(),
                         command.name);
                QVERIFY2(!use.lines.empty() && *use.text != '\0', command.name);
            }
            for (const Use& use : command.uses)
                for (const Key& key : use.keys)
                    QVERIFY2(*key.help != '\0', key.name);
            for (const QString& line : pageOf(command).split(QLatin1Char('\n')))
                QVERIFY2(line.size() <= kScreenColumns, qPrintable(line));
        }
    }

    void whatIsPrintedIsOnThePage_data()
    {
        QTest::addColumn<QString>("words");
        QTest::newRow("tre") << QStringLiteral("tre --height 1.75 --limit 2");
        QTest::newRow("tool") << QStringLiteral("tool --draws 20");
        QTest::newRow("drift") << QStringLiteral(
            "drift --scenario wan --actions 2 --strategy asa-adaptive");
        QTest::newRow("mechanics") << QStringLiteral("mechanics --condition ards");
    }
    void whatIsPrintedIsOnThePage()
    {
        QFETCH(QString, words);
        const QStringList all = words.split(QLatin1Char(' '));
        const Command& command = commandNamed(all.front());
        const auto object = command.run(all.mid(1));
        QVERIFY2(object.has_value(), object ? "" : object.error().detail.c_str());
        QSet<QString> printed;
        gatherKeys(*object, printed);
        QVERIFY(printed.size() > 5);
        const QString page = pageOf(command);
        for (const QString& key : printed)
            QVERIFY2(page.contains(key), qPrintable(key));
    }
};

CARINA_TEST(TestPages)

} // namespace carina::lab::pages_test

#include "tst_pages.moc"
