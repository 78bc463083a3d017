#include "apps/lab/programs/watched_program.h"
#include "apps/program/heap.h"
#include "tests/support/test_class.h"

#include <QCoreApplication>

#include <array>
#include <memory>
#include <vector>

namespace carina::heap_test
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

class TestHeap : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holesGoBackToTheSystem()
    {
        keepFreePagesFor({});
        const double before = memory_kb();
        const auto blocks = heapWithHoles();
        const double left = memory_kb() - before;
        QVERIFY2(left < 0.1 * kWritten_kb, qPrintable(QString::number(left)));
        for (std::size_t i = 0; i < blocks.size(); i += kLivesOn)
            QCOMPARE(blocks[i]->front(), 'x');
    }

    /// As they do not when pages are kept: so it is what was set that gives them back.
    void holesAreKeptForTheTime()
    {
        keepFreePagesFor(1h);
        const double before = memory_kb();
        const auto blocks = heapWithHoles();
        QVERIFY(memory_kb() - before > 0.9 * kWritten_kb);
        QCOMPARE(blocks.front()->front(), 'x');
    }
};

CARINA_TEST(TestHeap)

} // namespace carina::heap_test

#include "tst_heap.moc"
