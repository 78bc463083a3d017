#include "engine/anatomy/events/swallow.h"

#include "tests/support/test_class.h"

namespace carina::swallow_test
{
namespace
{

constexpr Duration kLook = std::chrono::milliseconds{1};

SessionTime after(Duration since) { return SessionTime{std::chrono::hours{1} + since}; }
static_assert(std::chrono::hours{1} % kSwallowEvery == Duration{0});

} // namespace

/// The course of a swallow in time.
class TestSwallow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginsAndEndsWithNothing()
    {
        QCOMPARE(swallowAt(after({})), 0.0);
        QCOMPARE(swallowAt(after(kSwallow)), 0.0);
        for (Duration at = kSwallow; at < kSwallowEvery; at += std::chrono::milliseconds{50})
            QCOMPARE(swallowAt(after(at)), 0.0);
        QVERIFY(swallowAt(after(std::chrono::milliseconds{50})) > 0.0);
        QVERIFY(swallowAt(after(kSwallow - std::chrono::milliseconds{50})) > 0.0);
    }

    /// By less than 1 % within a millisecond: its steepest is 1.5 within 0.9 s.
    void risesOnceAndFallsOnceWithoutALeap()
    {
        constexpr double kMostIn1ms = 0.002;
        double last = 0.0;
        double most = 0.0;
        int turns = 0;
        bool falls = false;
        for (Duration at{}; at <= kSwallow; at += kLook) {
            const double now = swallowAt(after(at));
            QVERIFY(now >= 0.0 && now <= 1.0);
            QVERIFY(std::abs(now - last) < kMostIn1ms);
            if (now != last && (now < last) != falls) {
                falls = now < last;
                ++turns;
            }
            most = std::max(most, now);
            last = now;
        }
        QCOMPARE(turns, 1);
        QCOMPARE(most, 1.0);
    }

    /// To the last bit, also days later.
    void isTheSameEachTime()
    {
        for (Duration at{}; at < kSwallowEvery; at += std::chrono::microseconds{12345})
            for (const Duration later :
                 {1 * kSwallowEvery, 3 * kSwallowEvery, 54321 * kSwallowEvery})
                QCOMPARE(swallowAt(after(at + later)), swallowAt(after(at)));
    }

    /// The cords begin 0.33 s before the hyoid bone, and are open again after 2.2 s (Shaker et al.,
    /// Gastroenterology 1990;98:1478).
    void shutsTheCordsBeforeTheLarynxRises()
    {
        constexpr double kFirst_s = 0.33;
        constexpr double kTolerance_s = 0.1;
        Duration rises{};
        Duration shut{};
        for (Duration at{}; at < kSwallow; at += kLook) {
            const double amount = swallowAt(after(at));
            const double rise = riseInSwallow(amount);
            if (rise > 0.0) {
                QCOMPARE(cordsInSwallow(amount), 1.0);
                if (rises == Duration{})
                    rises = at;
            }
            shut += cordsInSwallow(amount) == 1.0 ? kLook : Duration{};
        }
        QVERIFY2(std::abs(toSeconds(rises) - kFirst_s) < kTolerance_s,
                 qPrintable(QString::number(toSeconds(rises))));
        QVERIFY(toSeconds(shut) > 1.0 && shut < kSwallow);
        QCOMPARE(riseInSwallow(1.0), 1.0);
        QCOMPARE(cordsInSwallow(0.0), 0.0);
    }
};

CARINA_TEST(TestSwallow)

} // namespace carina::swallow_test

#include "tst_swallow.moc"
