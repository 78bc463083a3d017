#include "apps/lab/programs/watched_program.h"
#include "tests/support/test_class.h"

#include <QFile>

#include <vector>

#include <sys/wait.h>
#include <unistd.h>

namespace carina::watched_program_test
{

using carina::lab::Footprint;
using carina::lab::footprintOf;
using carina::lab::WatchedProgram;

class TestWatchedProgram : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void countsTheDescriptorsAndMemoryOfAProcess()
    {
        constexpr std::size_t kTaken_kb = 50'000;
        const auto before = footprintOf(QCoreApplication::applicationPid());
        QFile file{QStringLiteral("/dev/null")};
        QVERIFY(file.open(QIODevice::ReadOnly));
        const std::vector<char> written(1024 * kTaken_kb, 'x');
        const auto after = footprintOf(QCoreApplication::applicationPid());
        QVERIFY(before && after);
        QCOMPARE(after->descriptors, before->descriptors + 1);
        QVERIFY(after->memory_kb - before->memory_kb > 0.99 * kTaken_kb);
        QVERIFY(after->memory_kb - before->memory_kb < 1.1 * kTaken_kb);
        QVERIFY(after->threads >= 1);
    }

    void endsWithItsProgram()
    {
        std::int64_t ended = 0;
        {
            const WatchedProgram program{"sleeper",
                                         {QStringLiteral("sleep"), QStringLiteral("1000")}};
            QVERIFY(!program.hasEnded());
            QVERIFY(program.footprint().has_value());
            ended = program.processId();
        }
        QVERIFY(!footprintOf(ended).has_value());
    }

    /// The system still knows it, and says nothing of its memory, which is not the same as none.
    void hasNoFootprintOfAProcessThatNobodyHasWaitedFor()
    {
        const pid_t ended = fork();
        if (ended == 0)
            _exit(0);
        siginfo_t end{};
        QCOMPARE(waitid(P_PID, static_cast<id_t>(ended), &end, WEXITED | WNOWAIT), 0);
        QVERIFY(QFile::exists(QStringLiteral("/proc/%1/status").arg(ended)));
        QVERIFY(!footprintOf(ended).has_value());
        QCOMPARE(waitpid(ended, nullptr, 0), ended);
    }

    void hasNoFootprintWhereThereIsNoProgram()
    {
        const WatchedProgram program{"none", {QStringLiteral("/no/such/program")}};
        QVERIFY(program.hasEnded());
        QVERIFY(!program.footprint().has_value());
    }
};

CARINA_TEST(TestWatchedProgram)

} // namespace carina::watched_program_test

#include "tst_watched_program.moc"
