#include "tests/support/test_class.h"
#include "widgets/scene/view/shared_time.h"

#include <cmath>

namespace carina::shared_time_test
{

using std::chrono::milliseconds;

constexpr milliseconds kOften{16};
constexpr milliseconds kSeldom{80};

class TestSharedTime : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// 20 ms of each 80.
    void leavesWhatTheOneThatIsDrawnSeldomDoesNotTake()
    {
        SharedTime times;
        const int seldom = 0;
        LocalTime now{};
        for (int i = 0; i < 200; ++i, now += kSeldom)
            times.took(&seldom, now, milliseconds{20}, kSeldom);
        QVERIFY(std::abs(times.leftFor(kOften) - 0.75) < 1e-6);
        QCOMPARE(times.leftFor(kSeldom), 1.0); // what it takes itself is its own
        times.forget(&seldom);
        QCOMPARE(times.leftFor(kOften), 1.0);
    }

    /// Within about a second of being hidden.
    void leavesAllOnceThatIsNotDrawnAnyMore()
    {
        SharedTime times;
        const int seldom = 0;
        LocalTime now{};
        for (int i = 0; i < 200; ++i, now += kSeldom)
            times.took(&seldom, now, milliseconds{40}, kSeldom);
        times.took(&seldom, now - kSeldom + SharedTime::kOver, Duration::zero(), kSeldom);
        QVERIFY(std::abs(times.leftFor(kOften) - (1.0 - 0.5 / std::exp(1.0))) < 1e-6);
    }

    void leavesSomethingWhateverOthersTake()
    {
        SharedTime times;
        const int seldom = 0;
        LocalTime now{};
        for (int i = 0; i < 200; ++i, now += kSeldom)
            times.took(&seldom, now, milliseconds{300}, kSeldom);
        QCOMPARE(times.leftFor(kOften), SharedTime::kLeastLeft);
    }
};

CARINA_TEST(TestSharedTime)

} // namespace carina::shared_time_test

#include "tst_shared_time.moc"
