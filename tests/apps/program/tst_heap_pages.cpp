#include "apps/lab/programs/watched_program.h"
#include "apps/program/heap_pages.h"
#include "tests/support/test_class.h"

#include <QCoreApplication>

#include <array>
#include <memory>
#include <vector>

namespace carina::heap_pages_test
{
namespace
{

using namespace carina::program;
using namespace std::chrono_literals;

constexpr double kWritten_kb = 64'000.0;
constexpr std::size_t kLivesOn = 100; ///< of so many blocks one

using Block = std::array<char, 4000>;

double memory_kb()
{
    return lab::footprintOf(QCoreApplication::applicationPid())
        .value_or(lab::Footprint{})
        .memory_kb;
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

class TestHeapPages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holesGoBackToTheSystem()
    {
        const double before = memory_kb();
        const auto blocks = heapWithHoles();
        const double withHoles = memory_kb() - before;
        QVERIFY(withHoles > 0.9 * kWritten_kb); // glibc keeps them
        returnFreePages();
        const double left = memory_kb() - before;
        QVERIFY2(left < 0.1 * kWritten_kb, qPrintable(QString::number(left)));
        for (std::size_t i = 0; i < blocks.size(); i += kLivesOn)
            QCOMPARE(blocks[i]->front(), 'x');
    }

    void programsDoItByThemselves()
    {
        const double before = memory_kb();
        const HeapPages pages{1ms};
        const auto blocks = heapWithHoles();
        QTRY_VERIFY(memory_kb() - before < 0.1 * kWritten_kb);
    }

    void endsAtOnce() { const HeapPages pages{24h}; }
};

CARINA_TEST(TestHeapPages)

} // namespace carina::heap_pages_test

#include "tst_heap_pages.moc"
