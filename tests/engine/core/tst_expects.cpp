#include "engine/core/expects.h"
#include "tests/support/test_class.h"

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

namespace carina::expects_test
{
namespace
{

struct ChildEnd {
    int signal = 0; ///< that ended the child; 0 where it ended by itself
    std::string said;
};

/// Runs a contract in a child of its own, since a broken one ends the program.
ChildEnd endOfChildThatExpects(bool condition)
{
    int pipeEnds[2];
    if (pipe(pipeEnds) != 0)
        return {};
    const pid_t child = fork();
    if (child == 0) {
        std::signal(SIGABRT, SIG_DFL);
        dup2(pipeEnds[1], STDERR_FILENO);
        CARINA_EXPECTS(condition);
        _exit(0);
    }
    close(pipeEnds[1]);
    ChildEnd end;
    char letter = 0;
    while (read(pipeEnds[0], &letter, 1) == 1)
        end.said += letter;
    close(pipeEnds[0]);
    int status = 0;
    waitpid(child, &status, 0);
    end.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    return end;
}

} // namespace

class ExpectsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void goesOnWhereTheContractHolds()
    {
        const ChildEnd end = endOfChildThatExpects(true);
        QCOMPARE(end.signal, 0);
        QCOMPARE(end.said, std::string{});
    }

    void stopsTheProgramAndNamesTheBrokenContract()
    {
        const ChildEnd end = endOfChildThatExpects(false);
        QCOMPARE(end.signal, SIGABRT);
        QVERIFY(end.said.find("condition") != std::string::npos);
        QVERIFY(end.said.find("tst_expects.cpp") != std::string::npos);
    }
};

CARINA_TEST(ExpectsTest)

} // namespace carina::expects_test

#include "tst_expects.moc"
