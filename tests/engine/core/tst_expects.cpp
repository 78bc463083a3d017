#include "engine/core/expects.h"
#include "tests/engine/core/ended_child.h"
#include "tests/support/test_class.h"

#include <csignal>

namespace carina::expects_test
{
namespace
{

/// Runs a contract in a child, since a broken one ends the program.
test::EndedChild endOfChildThatExpects(bool condition)
{
    return test::endOfChild([condition](int out) {
        std::signal(SIGABRT, SIG_DFL);
        dup2(out, STDERR_FILENO);
        CARINA_EXPECTS(condition);
        _exit(0);
    });
}

} // namespace

class ExpectsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void goesOnWhereTheContractHolds()
    {
        const test::EndedChild end = endOfChildThatExpects(true);
        QVERIFY(WIFEXITED(end.status));
        QCOMPARE(end.said, std::string{});
    }

    void stopsTheProgramAndNamesTheBrokenContract()
    {
        const test::EndedChild end = endOfChildThatExpects(false);
        QVERIFY(WIFSIGNALED(end.status) && WTERMSIG(end.status) == SIGABRT);
        QVERIFY(end.said.find("condition") != std::string::npos);
        QVERIFY(end.said.find("tst_expects.cpp") != std::string::npos);
    }
};

CARINA_TEST(ExpectsTest)

} // namespace carina::expects_test

#include "tst_expects.moc"
