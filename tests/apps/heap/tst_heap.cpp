#include "apps/lab/programs/watched_program.h"
#include "tests/support/test_class.h"

#include <QCoreApplication>

#include <array>
#include <jemalloc/jemalloc.h>
#include <memory>
#include <optional>
#include <sys/types.h>
#include <vector>

namespace carina::heap_test
{
namespace
{

constexpr double kWritten_kb = 64'000.0;
constexpr std::size_t kLivesOn = 100; ///< of so many blocks one

using Block = std::array<char, 4000>;

double memory_kb()
{
    return lab::footprintOf(QCoreApplication::applicationPid())
        .value_or(lab::Footprint{})
        .memory_kb;
}

/// A setting that jemalloc has; none where the heap is another.
template <class T> std::optional<T> told(const char* name)
{
    T value{};
    std::size_t size = sizeof value;
    return mallctl(name, &value, &size, nullptr, 0) == 0 ? std::optional{value} : std::nullopt;
}

/// A heap with holes: blocks as small as many are, of which few live on.
std::vector<std::unique_ptr<Block>> heapWithHoles()
{
    constexpr auto kBlocks = static_cast<std::size_t>(1024 * kWritten_kb / sizeof(Block));
    std::vector<std::unique_ptr<Block>> blocks(kBlocks);
    for (auto& block : blocks) {
        block = std::make_unique<Block>();
        block->fill('x');
    }
    for (std::size_t i = 0; i < kBlocks; ++i)
        if (i % kLivesOn != 0)
            blocks[i].reset();
    return blocks;
}

} // namespace

class TestHeap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void keepsFreePagesForTwoSeconds()
    {
        QCOMPARE(told<ssize_t>("opt.dirty_decay_ms"), std::optional<ssize_t>{2000});
        QCOMPARE(told<ssize_t>("opt.muzzy_decay_ms"), std::optional<ssize_t>{0});
        QCOMPARE(told<bool>("background_thread"), std::optional{true});
    }

    /// While the thread that freed them rests.
    void holesGoBackToTheSystem()
    {
        constexpr int kPatience_ms = 30'000;
        const double before = memory_kb();
        const auto blocks = heapWithHoles();
        QTRY_VERIFY_WITH_TIMEOUT(memory_kb() - before < 0.1 * kWritten_kb, kPatience_ms);
        for (std::size_t i = 0; i < blocks.size(); i += kLivesOn)
            QCOMPARE(blocks[i]->front(), 'x');
    }
};

CARINA_TEST(TestHeap)

} // namespace carina::heap_test

#include "tst_heap.moc"
