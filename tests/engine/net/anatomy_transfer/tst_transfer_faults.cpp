#include "tests/engine/net/anatomy_transfer/transfer_ends.h"
#include "tests/support/socket_faults.h"
#include "tests/support/test_class.h"

#include <cerrno>

namespace carina::transfer_faults_test
{

using namespace test;

namespace
{

namespace faults = test::socket_faults;

constexpr std::size_t kSmall = 4'000; ///< some ten calls that read and as many that write

} // namespace

/// Server and receiver of an anatomy set while a call that reads or writes fails: the set comes
/// whole over a further connection.
class TestTransferFaults : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void cleanup() { faults::begin({}); }

    void setComesWhicheverCallFails_data()
    {
        QTest::addColumn<int>("error");
        QTest::newRow("reset by the peer") << ECONNRESET;
        QTest::newRow("broken pipe") << EPIPE;
        QTest::newRow("timed out") << ETIMEDOUT;
        QTest::newRow("input and output error") << EIO;
    }

    void setComesWhicheverCallFails()
    {
        QFETCH(int, error);
        const int all = callsOfTransfer({.of = faults::Of::Connections});
        QVERIFY(all >= 10);
        for (int first = 1; first <= all && !QTest::currentTestFailed(); ++first)
            callsOfTransfer({.of = faults::Of::Connections, .first = first, .error = error});
        qInfo("%d calls struck", all);
    }

private:
    /// Carries a set over, and looks at every byte of it. @returns the calls made
    int callsOfTransfer(const faults::Plan& plan)
    {
        ServingHost host{kSmall};
        const QTemporaryDir folder;
        const std::filesystem::path cache = folder.path().toStdString() + "/here";
        faults::begin(plan);
        const SetFetch fetch{doorAt(host.port()), kSetHash, cache};
        const bool came = comes(fetch);
        const int calls = faults::calls();
        const int struck = faults::struck();
        faults::begin({});
        const auto digest = fetch.status().set.digest;
        const bool isWhole = came && contentOf(CarriedSets{cache}.file(digest)) == host.bytes;
        // The last calls of one transfer may be missing in another.
        const bool isStruck = plan.first == 0 || struck == 1 || calls < plan.first;
        if (!isWhole || !isStruck)
            QTest::qFail(qPrintable(QStringLiteral("call %1: came %2, struck %3 of %4")
                                        .arg(plan.first)
                                        .arg(came)
                                        .arg(struck)
                                        .arg(calls)),
                         __FILE__, __LINE__);
        return calls;
    }
};

CARINA_TEST(TestTransferFaults)

} // namespace carina::transfer_faults_test

#include "tst_transfer_faults.moc"
