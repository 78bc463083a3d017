#include "engine/geometry/fit/consensus.h"
#include "tests/support/test_class.h"

namespace carina::consensus_test
{
namespace
{

/// Which of some numbers agree about one place.
std::vector<std::size_t> agreeing(const std::vector<double>& numbers, std::size_t sampleSize,
                                  double limit)
{
    const auto mean = [&](std::span<const std::size_t> which) {
        double sum = 0.0;
        for (const std::size_t i : which)
            sum += numbers[i];
        return sum / double(which.size());
    };
    return consensus(numbers.size(), sampleSize, limit, mean,
                     [&](double place, std::size_t i) { return std::abs(numbers[i] - place); });
}

} // namespace

class TestConsensus : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void takesAllThatAgree()
    {
        QCOMPARE(agreeing({1.0, 1.25, 0.75, 1.0}, 2, 0.5), (std::vector<std::size_t>{0, 1, 2, 3}));
    }

    void goesWithTheLargerPartWhereverItStands()
    {
        QCOMPARE(agreeing({7.0, 1.0, 7.1, 1.1, 0.9, 6.9, 1.0}, 2, 0.5),
                 (std::vector<std::size_t>{1, 3, 4, 6}));
        QCOMPARE(agreeing({1.0, 9.0, 1.0, 9.0, 9.0}, 1, 0.5), (std::vector<std::size_t>{1, 3, 4}));
    }

    /// Nine of eighteen agree, and the others with nobody.
    void findsTheHalfThatAgrees()
    {
        std::vector<double> numbers;
        std::vector<std::size_t> right;
        for (int i = 0; i < 9; ++i) {
            numbers.push_back(100.0 * (i + 1));
            right.push_back(numbers.size());
            numbers.push_back(0.01 * i);
        }
        QCOMPARE(agreeing(numbers, 4, 1.0), right);
    }

    void takesWhatIsJustWithinTheLimit()
    {
        QCOMPARE(agreeing({0.0, 2.0}, 2, 1.0).size(), 2U);
        QCOMPARE(agreeing({0.0, 2.0}, 2, 0.999).size(), 0U);
    }

    void passesOverWhatIsNoNumber()
    {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(agreeing({1.0, nan, 1.0, 1.0, nan}, 1, 0.5), (std::vector<std::size_t>{0, 2, 3}));
        QVERIFY(agreeing({nan, nan, nan}, 2, 0.5).empty());
    }
};

CARINA_TEST(TestConsensus)

} // namespace carina::consensus_test

#include "tst_consensus.moc"
