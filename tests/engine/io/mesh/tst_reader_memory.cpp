#include "engine/io/mesh/reader_memory.h"

#include "tests/support/test_class.h"

#include <future>
#include <thread>

namespace carina::reader_memory_test
{
namespace
{

constexpr std::chrono::milliseconds kNoPatience{0};
constexpr std::chrono::milliseconds kLong{20'000};
constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30U;

} // namespace

class TestReaderMemory final : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allSharesTogetherAreTheWhole()
    {
        const unsigned all = ReaderMemory::shares();
        QVERIFY(all >= 4 && all <= 16);
        QVERIFY(ReaderMemory::bytesOf(all) <= kMostBytes);
        QCOMPARE(ReaderMemory::bytesOf(1) * all, ReaderMemory::bytesOf(all));
    }

    void noMoreIsGivenThanThereIs()
    {
        const unsigned all = ReaderMemory::shares();
        for (unsigned i = 0; i < all; ++i)
            QVERIFY(ReaderMemory::take(1, kNoPatience));
        QVERIFY(!ReaderMemory::take(1, kNoPatience));
        ReaderMemory::giveBack(1);
        QVERIFY(!ReaderMemory::take(all, kNoPatience));
        QVERIFY(ReaderMemory::take(1, kNoPatience));
        ReaderMemory::giveBack(all);
        QVERIFY(ReaderMemory::take(all, kNoPatience));
        QVERIFY(!ReaderMemory::take(1, kNoPatience));
        ReaderMemory::giveBack(all);
    }

    void whoWantsAllIsServedBeforeTheNextWhoWantsOne()
    {
        const unsigned all = ReaderMemory::shares();
        QVERIFY(ReaderMemory::take(1, kNoPatience));
        auto whole =
            std::async(std::launch::async, [all] { return ReaderMemory::take(all, kLong); });
        while (!ReaderMemory::isWantedWhole())
            std::this_thread::yield();
        QVERIFY(!ReaderMemory::take(1, kNoPatience)); // though there are some
        ReaderMemory::giveBack(1);
        QVERIFY(whole.get());
        QVERIFY(!ReaderMemory::isWantedWhole());
        ReaderMemory::giveBack(all);
        QVERIFY(ReaderMemory::take(1, kNoPatience));
        ReaderMemory::giveBack(1);
    }
};

CARINA_TEST(TestReaderMemory)

} // namespace carina::reader_memory_test

#include "tst_reader_memory.moc"
