#include "tests/engine/io/fact_store/fact_store_files.h"
#include "tests/support/test_class.h"

#include <QCoreApplication>
#include <QProcess>
#include <iostream>
#include <thread>

namespace carina::test::sql_fact_store_test
{

class TestSqlFactStore : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesBackWhatItTook();
    void startsEmpty();
    void goesOnWhereItStopped();
    void takesTheLargestValues();
    void letsOnlyItsOwnerReadIt();
    void takesOnlyTheNextNumber_data();
    void takesOnlyTheNextNumber();
    void storesAllFactsOfATransactionOrNone();
    void keepsTheLastClockAnchor();
    void keepsTheLastActionOnEachObject();
    void servesAnyThread();
    void letsOneProgramIn();
    void losesNothingItReportedWhenKilled();

private:
    FreshFiles m_files;
};

namespace
{

constexpr std::uint64_t kTogether = 5;

/// The next facts of a store, appended together.
Result<void> appendNext(FactStore& store, std::uint64_t first)
{
    std::vector<FactRecord> facts;
    for (std::uint64_t number = first; number < first + kTogether; ++number)
        facts.push_back(numbered(number));
    return store.append(facts);
}

/// What the killed child does: appends for ever, several at once, and reports the last number once
/// they are stored.
int appendForEver(int& argc, char** argv)
{
    const QCoreApplication application{argc, argv};
    const auto store = opened(argv[1]);
    for (std::uint64_t number = store->load()->size() + 1;; number += kTogether) {
        if (!appendNext(*store, number))
            return 1;
        std::cout << number + kTogether - 1 << std::endl;
    }
}

const TestEntry kChild{"append-for-ever", appendForEver};

} // namespace

void TestSqlFactStore::givesBackWhatItTook()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 100);
    const Result<std::vector<FactRecord>> facts = opened(path)->load();
    QVERIFY(facts.has_value());
    QCOMPARE(facts->size(), std::size_t{100});
    for (std::uint64_t number = 1; number <= 100; ++number)
        QVERIFY((*facts)[number - 1] == numbered(number));
}

void TestSqlFactStore::startsEmpty()
{
    const auto store = opened(m_files.next());
    QVERIFY(store->load()->empty());
    QVERIFY(!store->clockAnchor()->has_value());
}

void TestSqlFactStore::goesOnWhereItStopped()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 3);
    const auto store = opened(path);
    QVERIFY(append(*store, numbered(4)));
    QCOMPARE(store->load()->size(), std::size_t{4});
}

void TestSqlFactStore::takesTheLargestValues()
{
    const std::filesystem::path path = m_files.next();
    const FactRecord largest{FactNumber{1},
                             ProposalId{~std::uint64_t{0}},
                             ParticipantId{65535},
                             StationId{65535},
                             SessionTime{Duration::max()},
                             SessionTime{Duration::min()},
                             std::vector<std::byte>(kLargestFactBody, std::byte{255})};
    QVERIFY(append(*opened(path), largest));
    QVERIFY(opened(path)->load()->front() == largest);
}

void TestSqlFactStore::letsOnlyItsOwnerReadIt()
{
    using std::filesystem::perms;
    const std::filesystem::path path = m_files.next();
    fill(path, 1);
    std::filesystem::permissions(path, perms{0644}); // as earlier versions left it
    const auto store = opened(path);
    QVERIFY(append(*store, numbered(2)));
    for (const auto& file : std::filesystem::directory_iterator{path.parent_path()})
        if (file.path().string().starts_with(path.string()))
            QCOMPARE(file.status().permissions(), perms::owner_read | perms::owner_write);
}

void TestSqlFactStore::takesOnlyTheNextNumber_data()
{
    QTest::addColumn<quint64>("number");
    QTest::addColumn<bool>("taken");
    QTest::newRow("next") << quint64{4} << true;
    QTest::newRow("last again") << quint64{3} << false;
    QTest::newRow("one left out") << quint64{5} << false;
    QTest::newRow("zero") << quint64{0} << false;
}

void TestSqlFactStore::takesOnlyTheNextNumber()
{
    QFETCH(const quint64, number);
    QFETCH(const bool, taken);
    const std::filesystem::path path = m_files.next();
    fill(path, 3);
    const auto store = opened(path);
    const Result<void> stored = append(*store, numbered(number));
    QCOMPARE(stored.has_value(), taken);
    QCOMPARE(store->load()->size(), std::size_t(taken ? 4 : 3));
    if (!taken)
        QCOMPARE(stored.error().code, Errc::StoreFailed);
}

void TestSqlFactStore::storesAllFactsOfATransactionOrNone()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 3);
    const auto store = opened(path);
    const std::array gap{numbered(4), numbered(6)};
    QCOMPARE(store->append(gap).error().code, Errc::StoreFailed);
    QCOMPARE(store->load()->size(), std::size_t{3});
    QVERIFY(store->append({}));
    const std::array whole{numbered(4), numbered(5)};
    QVERIFY(store->append(whole));
    QCOMPARE(store->load()->size(), std::size_t{5});
}

void TestSqlFactStore::keepsTheLastClockAnchor()
{
    const std::filesystem::path path = m_files.next();
    {
        const auto store = opened(path);
        QVERIFY(store->setClockAnchor({"first boot", Duration{5}}));
        QVERIFY(store->setClockAnchor({"second boot", Duration{-1'234'567'890'123'456'789}}));
    }
    const auto anchor = opened(path)->clockAnchor();
    QVERIFY(anchor && *anchor);
    QCOMPARE((*anchor)->bootId, std::string{"second boot"});
    QVERIFY((*anchor)->offset == Duration{-1'234'567'890'123'456'789});
}

void TestSqlFactStore::keepsTheLastActionOnEachObject()
{
    const std::filesystem::path path = m_files.next();
    EventCpo first;
    first.object = ObjectId{7};
    first.epoch = 3;
    first.action = 41;
    first.kind = ActionKind::Scaling;
    first.start = SessionTime{Duration{1'234'567'890'123'456'789}};
    first.p_AO = Vec3{1.0 / 3.0, -2.0, 0.1};
    first.rate = -0.1F;
    EventCpo next = first;
    next.action = 42;
    EventCpo other = first;
    other.object = ObjectId{65535};
    {
        const auto store = opened(path);
        QVERIFY(store->actions()->empty());
        for (const EventCpo& event : {first, other, next})
            QVERIFY(keepAction(*store, event));
    }
    const auto actions = opened(path)->actions();
    QVERIFY(actions);
    QCOMPARE(actions->size(), std::size_t{2});
    const EventCpo& kept = actions->at(0).object == first.object ? actions->at(0) : actions->at(1);
    QCOMPARE(kept.object, next.object);
    QCOMPARE(kept.epoch, next.epoch);
    QCOMPARE(kept.action, next.action);
    QCOMPARE(kept.kind, next.kind);
    QCOMPARE(kept.start, next.start);
    QVERIFY(kept.p_AO == next.p_AO);
    QCOMPARE(kept.rate, next.rate);
}

void TestSqlFactStore::servesAnyThread()
{
    const auto store = opened(m_files.next());
    QVERIFY(append(*store, numbered(1)));
    bool stored = false;
    std::thread other{[&] { stored = append(*store, numbered(2)).has_value(); }};
    other.join();
    QVERIFY(stored);
    QVERIFY(append(*store, numbered(3)));
    QCOMPARE(store->load()->size(), std::size_t{3});
}

void TestSqlFactStore::letsOneProgramIn()
{
    const std::filesystem::path path = m_files.next();
    fill(path, 2);
    auto store = opened(path);
    QCOMPARE(openFactStore(path).error().code, Errc::StoreFailed);
    QVERIFY(append(*store, numbered(3)));
    store.reset();
    QCOMPARE(opened(path)->load()->size(), std::size_t{3});
}

void TestSqlFactStore::losesNothingItReportedWhenKilled()
{
    const std::filesystem::path path = m_files.next();
    std::uint64_t reported = 0;
    for (int round = 0; round < 3; ++round) {
        QProcess child;
        child.start(QCoreApplication::applicationFilePath(),
                    {QStringLiteral("append-for-ever"), QFile::decodeName(path.c_str())});
        const std::uint64_t enough = reported + 40;
        QByteArray output;
        while (output.count('\n') < qsizetype(enough - reported)) {
            QVERIFY2(child.waitForReadyRead(30'000), "the child stores nothing");
            output += child.readAllStandardOutput();
        }
        child.kill();
        QVERIFY(child.waitForFinished());
        QVERIFY(child.exitStatus() == QProcess::CrashExit);
        output += child.readAllStandardOutput();
        // The last whole line is the last number that was reported.
        const QByteArray whole = output.left(output.lastIndexOf('\n'));
        reported = whole.mid(whole.lastIndexOf('\n') + 1).toULongLong();
        QVERIFY(reported >= enough);

        const Result<std::vector<FactRecord>> facts = opened(path)->load();
        QVERIFY(facts.has_value());
        QVERIFY(facts->size() >= reported);
        QVERIFY(facts->size() <= reported + kTogether); // stored perhaps, and not reported
        QCOMPARE(facts->size() % kTogether, std::size_t{0});
        for (const FactRecord& fact : *facts)
            QVERIFY(fact == numbered(fact.number.value));
        reported = facts->size();
    }
}

CARINA_TEST(TestSqlFactStore)

} // namespace carina::test::sql_fact_store_test

#include "tst_sql_fact_store.moc"
