#include "engine/io/fact_store/store_writer.h"
#include "tests/support/test_class.h"

#include <semaphore>

namespace carina::store_writer_test
{
namespace
{

FactRecord numbered(std::uint64_t number)
{
    FactRecord fact;
    fact.number = FactNumber{number};
    return fact;
}

/// What the test sees of a store that is the writer's.
struct Disk {
    std::vector<std::size_t> transactions; ///< sizes
    std::thread::id thread;
    bool isFull = false;
    bool isOpen = true;
    std::binary_semaphore work{0}; ///< acquired by each append
};

/// A store that goes on when the test lets it.
class HeldStore final : public FactStore
{
public:
    explicit HeldStore(Disk& disk) : m_disk{disk} {}
    ~HeldStore() override { m_disk.isOpen = false; }
    HeldStore(const HeldStore&) = delete;
    HeldStore& operator=(const HeldStore&) = delete;

    Result<std::vector<FactRecord>> load() override { return {}; }
    Result<void> append(std::span<const FactRecord> facts) override
    {
        m_disk.work.acquire();
        m_disk.thread = std::this_thread::get_id();
        if (m_disk.isFull)
            return fail(Errc::StoreFailed, "disk full");
        m_disk.transactions.push_back(facts.size());
        return {};
    }
    Result<std::optional<ClockAnchor>> clockAnchor() override { return {}; }
    Result<void> setClockAnchor(const ClockAnchor& /*anchor*/) override { return {}; }
    Result<std::vector<EventCpo>> actions() override { return {}; }
    Result<void> keepActions(std::span<const EventCpo> events) override
    {
        return events.size() == 2 ? Result<void>{} : fail(Errc::StoreFailed, "not two");
    }
    Result<std::optional<std::filesystem::path>> keepWhole() override
    {
        return std::optional<std::filesystem::path>{"elsewhere"};
    }

private:
    Disk& m_disk;
};

} // namespace

class TestStoreWriter : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void writesOnAThreadOfItsOwnWhileTheOwnerGoesOn()
    {
        Disk disk;
        StoreWriter writer{std::make_unique<HeldStore>(disk)};
        std::binary_semaphore reported{0};
        writer.onReport([&reported] { reported.release(); });
        QVERIFY(!writer.isBusy() && !writer.take());
        writer.write({.facts = {numbered(1), numbered(2)}});
        QVERIFY(writer.isBusy() && !writer.take()); // the disk is at work
        disk.work.release();
        reported.acquire();
        QVERIFY(writer.isBusy());
        const auto report = writer.take();
        QVERIFY(report && report->facts && report->actions);
        QVERIFY(!writer.isBusy() && !writer.take());
        QCOMPARE(disk.transactions, (std::vector<std::size_t>{2}));
        QVERIFY(disk.thread != std::this_thread::get_id());
    }

    void saysWhatCouldNotBeStored()
    {
        Disk disk;
        disk.isFull = true;
        StoreWriter writer{std::make_unique<HeldStore>(disk)};
        disk.work.release();
        writer.write({.facts = {numbered(1)}, .actions = {EventCpo{}}});
        const StoreReport report = writer.wait();
        QCOMPARE(report.facts.error(), (Error{Errc::StoreFailed, "disk full"}));
        QCOMPARE(report.actions.error(), (Error{Errc::StoreFailed, "not two"}));
        QVERIFY(**report.moved == "elsewhere");
        QVERIFY(!writer.isBusy());
    }

    void whatLiesBesideTheStoreIsWrittenBeforeTheFacts()
    {
        Disk disk;
        StoreWriter writer{std::make_unique<HeldStore>(disk)};
        std::thread::id thread;
        std::size_t before = 1;
        StoreJob job{.facts = {numbered(1)}};
        job.beside = [&]() -> Result<void> {
            thread = std::this_thread::get_id();
            before = disk.transactions.size();
            return {};
        };
        disk.work.release();
        writer.write(job);
        QVERIFY(writer.wait().facts);
        QCOMPARE(before, std::size_t{0});
        QCOMPARE(disk.transactions, (std::vector<std::size_t>{1}));
        QVERIFY(thread == disk.thread);

        job.beside = [] { return Result<void>{fail(Errc::FileUnwritable, "folder")}; };
        writer.write(job);
        QCOMPARE(writer.wait().facts.error(), (Error{Errc::StoreFailed, "folder"}));
        QCOMPARE(disk.transactions.size(), std::size_t{1}); // nothing depends on what is not there
    }

    void emptyJobLooksAfterTheFileAlone()
    {
        Disk disk;
        StoreWriter writer{std::make_unique<HeldStore>(disk)};
        writer.write({});
        const StoreReport report = writer.wait();
        QVERIFY(report.facts && report.actions && **report.moved == "elsewhere");
        QVERIFY(disk.transactions.empty());
    }

    void jobUnderWayIsDoneBeforeTheEnd()
    {
        Disk disk;
        disk.work.release();
        {
            StoreWriter writer{std::make_unique<HeldStore>(disk)};
            writer.write({.facts = {numbered(1)}});
        }
        QCOMPARE(disk.transactions, (std::vector<std::size_t>{1}));
        QVERIFY(!disk.isOpen);
    }
};

CARINA_TEST(TestStoreWriter)

} // namespace carina::store_writer_test

#include "tst_store_writer.moc"
