#include "apps/lab/command/command.h"
#include "tests/support/test_class.h"

#include <QJsonArray>

#include <array>

namespace carina::lab::command_test
{
namespace
{

int runs = 0;

Result<QJsonObject> warn(const QStringList&)
{
    ++runs;
    return QJsonObject{{kWarnings, QJsonArray{QStringLiteral("It is doubtful: do it again.")}}};
}

Result<QJsonObject> refuse(const QStringList&)
{
    ++runs;
    return fail(Errc::OutOfRange, "It cannot be done: do something else.");
}

const std::array kCommands{Command{"warn", "warn\n    Warns.\n", warn},
                           Command{"refuse", "refuse\n    Refuses.\n", refuse}};

int status(const QStringList& words)
{
    return runCommandLine(kCommands, QStringList{QStringLiteral("carina-lab")} + words);
}

} // namespace

/// How a command line ends.
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

    void helpsWithoutRunning()
    {
        runs = 0;
        for (const char* help : {"--help", "-h"}) {
            QCOMPARE(status({QStringLiteral("refuse"), QLatin1String{help}}), 0);
            QCOMPARE(status({QLatin1String{help}}), 0);
        }
        QCOMPARE(runs, 0);
    }
};

CARINA_TEST(TestCommand)

} // namespace carina::lab::command_test

#include "tst_command.moc"
