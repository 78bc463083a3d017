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
    void opensAStoreFromBeforeThereWereActions();
    void refusesAnActionThatIsNone();
    void namesAPlaceItCannotWriteTo();

private:
    FreshFiles m_files;
};

namespace
{

QByteArray bytesOf(const std::filesystem::path& path)
{
    QFile file{QFile::decodeName(path.c_str())};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
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
    runSql(path, QStringLiteral("PRAGMA user_version = 2"));
    const auto store = openFactStore(path);
    QCOMPARE(store.error().code, Errc::UnknownFormat);
    QVERIFY(store.error().detail.ends_with("version 2"));
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
    row("longest body", "UPDATE fact SET body = zeroblob(1024) WHERE number = 4", "");
    row("largest ids", "UPDATE fact SET author = 65535, station = 65535 WHERE number = 4", "");
    row("smallest ids", "UPDATE fact SET author = 0, station = 0 WHERE number = 4", "");
}

void TestDamagedFactStore::refusesATamperedLog()
{
    QFETCH(const QString, sql);
    QFETCH(const QString, fact);
    const std::filesystem::path path = m_files.next();
    fill(path, 5);
    runSql(path, sql);
    const Result<std::vector<FactRecord>> facts = opened(path)->load();
    QCOMPARE(facts.has_value(), fact.isEmpty());
    if (facts)
        return;
    QCOMPARE(facts.error().code, Errc::StoreCorrupt);
    QVERIFY(facts.error().detail.ends_with(fact.toStdString()));
}

void TestDamagedFactStore::opensAStoreFromBeforeThereWereActions()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 2);
    runSql(path, QStringLiteral("DROP TABLE action"));
    const auto store = opened(path);
    QVERIFY(store->actions()->empty());
    QCOMPARE(store->load()->size(), std::size_t{2});
}

void TestDamagedFactStore::refusesAnActionThatIsNone()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 1);
    runSql(path, QStringLiteral("INSERT INTO action VALUES (1, zeroblob(93))"));
    QCOMPARE(opened(path)->actions().error().code, Errc::StoreCorrupt);
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
