#include "engine/io/fact_store/sql_fact_store.h"
#include "tests/engine/net/node/nodes.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QFile>

#include <functional>

namespace carina::node_store_test
{
namespace
{

/// A host whose session is in a file.
std::unique_ptr<SessionNode> hostFile(const MemoryDisk& disk, const QString& file)
{
    auto store = openFactStore(file.toStdString());
    if (!store)
        return nullptr;
    HostSettings settings = hostSettings(disk);
    settings.secrets =
        std::filesystem::path{file.toStdString()}.replace_extension(".secrets").string();
    auto node = SessionNode::host(settings, *std::move(store));
    return node ? *std::move(node) : nullptr;
}

void writeOver(const QString& file)
{
    QFile target{file};
    QVERIFY(target.open(QIODevice::ReadWrite));
    QCOMPARE(target.write(QByteArray{6000, 'x'}), qint64{6000});
}

using Harm = std::function<void(const QString& file)>;

} // namespace

/// The store of a host, while somebody else is at its files.
class TestNodeStore : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void lostFileIsSavedAnew_data()
    {
        QTest::addColumn<Harm>("harm");
        const auto row = [](const char* name, const Harm& harm) { QTest::newRow(name) << harm; };
        row("deleted", [](const QString& file) { QVERIFY(QFile::remove(file)); });
        row("its changes deleted",
            [](const QString& file) { QVERIFY(QFile::remove(file + QStringLiteral("-wal"))); });
        row("replaced", [](const QString& file) {
            writeOver(file + QStringLiteral("x"));
            QVERIFY(QFile::remove(file) && QFile::rename(file + QStringLiteral("x"), file));
        });
        row("moved away", [](const QString& file) {
            QVERIFY(QFile::rename(file, file + QStringLiteral("-moved")));
        });
        row("written over", [](const QString& file) { writeOver(file); });
        row("made empty", [](const QString& file) { QVERIFY(QFile::resize(file, 0)); });
        row("deleted with its folder",
            [](const QString& file) { QVERIFY(QDir{QFileInfo{file}.path()}.removeRecursively()); });
    }

    void lostFileIsSavedAnew()
    {
        QFETCH(const Harm, harm);
        const MemoryDisk disk;
        QVERIFY(QDir{disk.folder.path()}.mkdir(QStringLiteral("data")));
        const QString file = disk.folder.filePath(QStringLiteral("data/session.sqlite"));
        const QString next = disk.folder.filePath(QStringLiteral("data/session_2.sqlite"));
        auto instructor = hostFile(disk, file);
        QVERIFY(instructor);
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(25.0)});
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*instructor), 25.0, kPatience_ms);
        QVERIFY(!instructor->refusal());
        harm(file);
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal(), kPatience_ms);
        QCOMPARE(instructor->refusal()->code, Errc::StoreReplaced);
        QCOMPARE(instructor->refusal()->detail, next.toStdString());

        instructor->propose(kStation, fact::BreathingRateSet{perMinute(26.0)});
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*instructor), 26.0, kPatience_ms);
        const std::uint64_t facts = instructor->state()->lastApplied().value;
        const std::string id = instructor->state()->sessionId();
        const JoinCodes codes = instructor->joinCodes();
        instructor.reset();
        QCOMPARE((*openFactStore(next.toStdString()))->load()->size(), std::size_t(facts));
        instructor = hostFile(disk, next);
        QVERIFY(instructor && !instructor->refusal());
        QCOMPARE(instructor->state()->sessionId(), id);
        QCOMPARE(ratePerMinute(*instructor), 26.0);
        QVERIFY(instructor->joinCodes() == codes);
    }

    /// Nothing is decided that is only in a lost file.
    void lostFileThatCannotBeSavedAnewIsSaidUntilItCan()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        disk.full = true;
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal(), kPatience_ms);
        QCOMPARE(instructor->refusal()->code, Errc::StoreFailed);
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(25.0)});
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal(), kPatience_ms);
        disk.full = false;
        disk.moved = "elsewhere/session_2.sqlite";
        QTRY_COMPARE_WITH_TIMEOUT(instructor->refusal()->code, Errc::StoreReplaced, kPatience_ms);
    }

    void clockThatContradictsTheLogIsSaid()
    {
        MemoryDisk disk;
        host(disk).reset();
        QVERIFY(disk.anchor);
        disk.anchor->offset = Duration::max();
        const SessionTime last = disk.facts.back().committed;
        const auto instructor = host(disk);
        QVERIFY(instructor && instructor->refusal());
        QCOMPARE(instructor->refusal()->code, Errc::ClockLost);
        QVERIFY(*instructor->now() >= last && *instructor->now() < last + 60s);
    }
};

CARINA_TEST(TestNodeStore)

} // namespace carina::node_store_test

#include "tst_node_store.moc"
