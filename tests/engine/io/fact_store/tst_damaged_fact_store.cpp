#include "tests/engine/io/fact_store/fact_store_files.h"
#include "tests/support/test_class.h"

#include <QSqlDatabase>
#include <QSqlQuery>

namespace carina::test::damaged_fact_store_test
{

class TestDamagedFactStore : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void refusesAFileThatIsNoDatabase();
    void refusesATruncatedFile();
    void refusesAnotherProgramsDatabase();
    void refusesANewerVersion();
    void refusesATamperedLog_data();
    void refusesATamperedLog();
    void refusesAnEmptyFile();
    void refusesAStoreOfVersion2AndLeavesItAlone();
    void refusesAStoreOfVersion1AndLeavesItAlone();
    void noticesEveryFlippedBit();
    void refusesAnActionThatIsNone();
    void namesAPlaceItCannotWriteTo();

private:
    FreshFiles m_files;
};

namespace
{

/// Whether a byte of a file may be read: it is not zero, or beside one that is not.
bool isWritten(const QByteArray& file, qsizetype at)
{
    const QByteArray around = file.mid(std::max(qsizetype{0}, at - 2), 5);
    return around.count('\0') < around.size();
}

/// Changes a closed store behind our back.
void runSql(const std::filesystem::path& path, const QString& sql)
{
    const QString name = QStringLiteral("tamper");
    {
        QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), name);
        database.setDatabaseName(QFile::decodeName(path.c_str()));
        QVERIFY(database.open());
        QSqlQuery query{database};
        QVERIFY2(query.exec(sql), qPrintable(sql));
    }
    QSqlDatabase::removeDatabase(name);
}

} // namespace

void TestDamagedFactStore::refusesAFileThatIsNoDatabase()
{
    const std::filesystem::path path = m_files.next();
    const QByteArray text = QByteArray{"notes of a session, not a log\n"}.repeated(500);
    write(path, text);
    const auto store = openFactStore(path);
    QCOMPARE(store.error().code, Errc::StoreCorrupt);
    QVERIFY(store.error().detail.starts_with(path.string()));
    QCOMPARE(bytesOf(path), text);
}

void TestDamagedFactStore::refusesATruncatedFile()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 400);
    const QByteArray whole = bytesOf(path);
    QVERIFY(whole.size() > 20'000);
    for (const qsizetype kept :
         {whole.size() / 2, whole.size() - 1, qsizetype{4096}, qsizetype{50}}) {
        write(path, whole.left(kept));
        const auto store = openFactStore(path);
        QVERIFY2(!store, qPrintable(QString::number(kept)));
        QCOMPARE(store.error().code, Errc::StoreCorrupt);
        QCOMPARE(bytesOf(path), whole.left(kept));
    }
    write(path, whole);
    QCOMPARE(opened(path)->load()->size(), std::size_t{400});
}

void TestDamagedFactStore::refusesAnotherProgramsDatabase()
{
    const std::filesystem::path path = m_files.next();
    runSql(path, QStringLiteral("CREATE TABLE recipe (name TEXT)"));
    const QByteArray before = bytesOf(path);
    QCOMPARE(openFactStore(path).error().code, Errc::UnknownFormat);
    QCOMPARE(bytesOf(path), before);
}

void TestDamagedFactStore::refusesANewerVersion()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 1);
    runSql(path, QStringLiteral("PRAGMA user_version = 4"));
    const auto store = openFactStore(path);
    QCOMPARE(store.error().code, Errc::UnknownFormat);
    QVERIFY(store.error().detail.ends_with("version 4"));
}

void TestDamagedFactStore::refusesATamperedLog_data()
{
    QTest::addColumn<QString>("sql");
    QTest::addColumn<QString>("fact");
    const auto row = [](const char* name, const char* sql, const char* fact) {
        QTest::newRow(name) << QString::fromUtf8(sql) << QString::fromUtf8(fact);
    };
    row("first gone", "DELETE FROM fact WHERE number = 1", ": fact 1");
    row("one gone", "DELETE FROM fact WHERE number = 3", ": fact 3");
    row("negative author", "UPDATE fact SET author = -1 WHERE number = 2", ": fact 2");
    row("author too large", "UPDATE fact SET author = 65536 WHERE number = 2", ": fact 2");
    row("negative station", "UPDATE fact SET station = -1 WHERE number = 5", ": fact 5");
    row("station too large", "UPDATE fact SET station = 65536 WHERE number = 5", ": fact 5");
    row("body too long", "UPDATE fact SET body = zeroblob(1025) WHERE number = 4", ": fact 4");
    row("body of 20 MB", "UPDATE fact SET body = zeroblob(20000000) WHERE number = 4", ": fact 4");
    row("another author", "UPDATE fact SET author = 7 WHERE number = 1", ": fact 1");
    row("another body", "UPDATE fact SET body = x'00' WHERE number = 1", ": fact 1");
    row("another proposal", "UPDATE fact SET proposal = proposal + 1 WHERE number = 3", ": fact 3");
    row("another time", "UPDATE fact SET effect_ns = effect_ns - 1 WHERE number = 5", ": fact 5");
    row("no digest", "UPDATE fact SET digest = x'' WHERE number = 5", ": fact 5");
    row("another clock", "INSERT OR REPLACE INTO clock_anchor VALUES (0, 'boot', 5, x'00')",
        ": the clock");
}

void TestDamagedFactStore::refusesATamperedLog()
{
    QFETCH(const QString, sql);
    QFETCH(const QString, fact);
    const std::filesystem::path path = m_files.next();
    fill(path, 5);
    runSql(path, sql);
    const Result<std::vector<FactRecord>> facts = opened(path)->load();
    QVERIFY(!facts);
    QCOMPARE(facts.error().code, Errc::StoreCorrupt);
    QVERIFY(facts.error().detail.ends_with(fact.toStdString()));
}

/// A crash leaves a new store whole or not at all, so an empty file has lost a session.
void TestDamagedFactStore::refusesAnEmptyFile()
{
    const std::filesystem::path path = m_files.next();
    write(path, {});
    const auto store = openFactStore(path);
    QCOMPARE(store.error().code, Errc::StoreCorrupt);
    QVERIFY(store.error().detail.ends_with("it is empty"));
    QVERIFY(std::filesystem::is_empty(path));
}

/// Of a time when some facts were encoded otherwise: it cannot be read, and stays for the Carina
/// that can.
void TestDamagedFactStore::refusesAStoreOfVersion2AndLeavesItAlone()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 2);
    runSql(path, QStringLiteral("PRAGMA user_version = 2"));
    const QByteArray before = bytesOf(path);
    const auto store = openFactStore(path);
    QVERIFY(!store);
    QCOMPARE(store.error().code, Errc::StoreTooOld);
    QCOMPARE(bytesOf(path), before);
}

/// Likewise; it knows fewer tables.
void TestDamagedFactStore::refusesAStoreOfVersion1AndLeavesItAlone()
{
    using std::filesystem::perms;
    const std::filesystem::path path = m_files.next();
    fill(path, 2);
    for (const char* sql :
         {"ALTER TABLE fact DROP COLUMN digest", "ALTER TABLE clock_anchor DROP COLUMN digest",
          "DROP TABLE action", "PRAGMA user_version = 1"})
        runSql(path, QString::fromLatin1(sql));
    std::filesystem::permissions(path, perms{0644}); // as version 1 left it
    const QByteArray before = bytesOf(path);
    const auto store = openFactStore(path);
    QVERIFY(!store);
    QCOMPARE(store.error().code, Errc::StoreTooOld);
    QVERIFY(store.error().detail == path.string());
    QCOMPARE(bytesOf(path), before);
    QVERIFY(std::filesystem::status(path).permissions() == perms{0644});
}

/// Every bit of a small store flipped, one after another: it is refused and left alone, or what is
/// read is the same (a bit that nobody reads).
void TestDamagedFactStore::noticesEveryFlippedBit()
{
    const std::filesystem::path path = m_files.next();
    EventCpo event;
    event.object = ObjectId{7};
    fill(path, 3);
    {
        const auto store = opened(path);
        QVERIFY(store->setClockAnchor({"boot", Duration{5}}));
        QVERIFY(keepAction(*store, event));
    }
    const QByteArray whole = bytesOf(path);
    int refused = 0;
    for (qsizetype bit = 0; bit < 8 * whole.size(); ++bit) {
        if (!isWritten(whole, bit / 8))
            continue;
        QByteArray flipped = whole;
        flipped[bit / 8] = char(flipped[bit / 8] ^ (1 << bit % 8));
        write(path, flipped);
        auto store = openFactStore(path);
        const auto facts = store ? (*store)->load() : tl::unexpected(store.error());
        if (store)
            store->reset();
        if (!facts) {
            ++refused;
            QVERIFY(facts.error().code == Errc::StoreCorrupt
                    || facts.error().code == Errc::StoreFailed
                    || facts.error().code == Errc::UnknownFormat
                    || facts.error().code == Errc::StoreTooOld);
            continue;
        }
        QCOMPARE(facts->size(), std::size_t{3});
        for (const FactRecord& fact : *facts)
            QVERIFY2(fact == numbered(fact.number.value), qPrintable(QString::number(bit)));
        const auto again = opened(path);
        QVERIFY(again->clockAnchor()->value().offset == Duration{5});
        QVERIFY(again->clockAnchor()->value().bootId == "boot");
        QCOMPARE(again->actions()->size(), std::size_t{1});
        QCOMPARE(again->actions()->front().object, event.object);
    }
    qInfo("%d flipped bits refused", refused);
    QVERIFY(refused > 8 * 3 * 20);
}

void TestDamagedFactStore::refusesAnActionThatIsNone()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 1);
    runSql(path, QStringLiteral("INSERT INTO action VALUES (1, zeroblob(93), x'00')"));
    const auto actions = opened(path)->actions();
    QCOMPARE(actions.error().code, Errc::StoreCorrupt);
    QVERIFY(actions.error().detail.ends_with(": an action"));
}

void TestDamagedFactStore::namesAPlaceItCannotWriteTo()
{
    const std::filesystem::path path = m_files.next() / "no such folder" / "log";
    const auto store = openFactStore(path);
    QCOMPARE(store.error().code, Errc::StoreFailed);
    QVERIFY(store.error().detail.starts_with(path.string()));
}

CARINA_TEST(TestDamagedFactStore)

} // namespace carina::test::damaged_fact_store_test

#include "tst_damaged_fact_store.moc"
