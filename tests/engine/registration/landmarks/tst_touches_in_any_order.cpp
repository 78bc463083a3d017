#include "tests/engine/registration/landmarks/touching_person.h"
#include "tests/support/test_class.h"

#include <array>

namespace carina::touches_in_any_order_test
{

using namespace test;

namespace
{

constexpr int kTrials = 1000;
constexpr double kWrong = 0.01;      // share of registrations
constexpr double kAskedLater = 0.02; // share of touches, where five or more are touched

struct Tally {
    std::array<int, kCount> ambiguous{}; ///< by how many were touched before
    std::array<int, kCount> wrong{};
    std::array<int, kCount> nowhere{};
    std::array<int, kCount> again{}; ///< taken for one that was touched before
    int renamed = 0;

    /// What became of a touch of this landmark after n others.
    void take(std::size_t n, const TouchFinding& finding, std::size_t landmark)
    {
        const bool named = finding.verdict == TouchVerdict::Landmark;
        ambiguous[n] += finding.verdict == TouchVerdict::Ambiguous ? 1 : 0;
        nowhere[n] += finding.verdict == TouchVerdict::Nowhere ? 1 : 0;
        again[n] += finding.verdict == TouchVerdict::Again ? 1 : 0;
        renamed += finding.verdict == TouchVerdict::Renamed ? 1 : 0;
        wrong[n] += named && finding.landmark != landmark ? 1 : 0;
    }
    void print(const char* what) const
    {
        for (std::size_t i = 0; i < kCount; ++i)
            qInfo("%s, touch %zu: ambiguous %.1f %%, wrong %.1f %%, nowhere %.1f %%", what, i + 1,
                  100.0 * ambiguous[i] / kTrials, 100.0 * wrong[i] / kTrials,
                  100.0 * nowhere[i] / kTrials);
    }
    [[nodiscard]] static int sum(const std::array<int, kCount>& counts)
    {
        return std::accumulate(counts.begin(), counts.end(), 0);
    }
};

} // namespace

/// Whole registrations of eight landmarks, touched as they come.
class TestTouchesInAnyOrder : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Nobody proposes anything: what is not clear is asked for.
    void takesAnyOrderAndAsksWhereItIsNotClear()
    {
        Person person{211};
        Tally tally;
        for (int trial = 0; trial < kTrials; ++trial) {
            person.begin();
            const auto order = shuffled(person.hand.random());
            for (std::size_t n = 0; n < kCount; ++n) {
                const TouchFinding finding = person.recognise(order[n], {});
                tally.take(n, finding, order[n]);
                person.touches[order[n]] = person.truth.back().second;
            }
        }
        tally.print("asked");
        QVERIFY(Tally::sum(tally.wrong) + Tally::sum(tally.again) + tally.renamed
                < kWrong * kTrials);
        for (std::size_t n = 4; n < kCount; ++n)
            QVERIFY(tally.ambiguous[n] + tally.nowhere[n] < kAskedLater * kTrials);
    }

    /// First what is asked for, three landmarks; then as they come.
    void takesAnyOrderAfterThree()
    {
        Person person{223};
        Tally tally;
        for (int trial = 0; trial < kTrials; ++trial) {
            person.begin();
            auto order = shuffled(person.hand.random());
            std::ranges::stable_partition(order, [](std::size_t i) { return i < 3; });
            std::sort(order.begin(), order.begin() + 3);
            for (std::size_t n = 0; n < kCount; ++n) {
                const TouchFinding finding = person.recognise(order[n], person.firstOpen());
                tally.take(n, finding, order[n]);
                person.touches[order[n]] = person.truth.back().second;
            }
        }
        tally.print("three as asked for");
        QVERIFY(Tally::sum(tally.wrong) < kWrong * kTrials);
        for (std::size_t n = 0; n < kCount; ++n)
            QVERIFY(tally.ambiguous[n] + tally.nowhere[n] < kAskedLater * kTrials);
    }

    /// Never mind what is asked for.
    void mendsNamesThatWereGivenByWhatWasAskedFor()
    {
        Person person{227};
        Tally tally;
        int right = 0;
        for (int trial = 0; trial < kTrials; ++trial) {
            person.begin();
            const auto order = shuffled(person.hand.random());
            for (std::size_t n = 0; n < kCount; ++n) {
                const TouchFinding finding = person.recognise(order[n], person.firstOpen());
                const Vec3 p_TQ = person.truth.back().second;
                tally.take(n, finding, order[n]);
                if (finding.verdict == TouchVerdict::Renamed)
                    person.touches = finding.renamed_p_TQ;
                else if (finding.verdict == TouchVerdict::Landmark)
                    person.touches[finding.landmark] = p_TQ;
                else
                    person.touches[order[n]] = p_TQ;
            }
            right += person.isRight() ? 1 : 0;
        }
        qInfo("right %d, renamed %d, asked %d", right, tally.renamed,
              Tally::sum(tally.ambiguous) + Tally::sum(tally.nowhere));
        QVERIFY(right > (1.0 - kWrong) * kTrials);
    }
};

CARINA_TEST(TestTouchesInAnyOrder)

} // namespace carina::touches_in_any_order_test

#include "tst_touches_in_any_order.moc"
