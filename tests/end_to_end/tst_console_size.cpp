#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QImage>
#include <QTemporaryDir>

namespace carina::console_size_test
{

namespace
{

} // namespace

/// The console on the smallest screen that it is made for.
class TestConsoleSize : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Also with two stations, one of them with a long name.
    void fits1280By800()
    {
        QTemporaryDir folder;
        QVERIFY(folder.isValid());
        Program console{QStringLiteral(CARINA_INSTRUCTOR),
                        {QStringLiteral("--port"), portOfThisTest(), QStringLiteral("--patient"),
                         QStringLiteral("child"), QStringLiteral("--data"), folder.path(),
                         QStringLiteral("--add-station"),
                         QStringLiteral("The room at the end of the long corridor: adult"),
                         QStringLiteral("--size"), QStringLiteral("1280x800"),
                         QStringLiteral("--measure"), folder.path(), QStringLiteral("--seconds"),
                         QStringLiteral("5")},
                        folder.filePath(QStringLiteral("journal.jsonl"))};
        console.start();
        QTRY_VERIFY_WITH_TIMEOUT(console.hasEnded(), kPatience_ms);
        QCOMPARE(console.exitCode(), 0);
        const QImage picture{folder.filePath(QStringLiteral("instructor.png"))};
        QCOMPARE(picture.size(), QSize(1280, 800));
    }
};

CARINA_TEST(TestConsoleSize)

} // namespace carina::console_size_test

#include "tst_console_size.moc"
