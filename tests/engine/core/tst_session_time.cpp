#include "engine/core/session_time.h"
#include "tests/support/test_class.h"

#include <type_traits>

namespace carina::session_time_test
{

using namespace std::chrono_literals;

class SessionTimeTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void countsNanoseconds()
    {
        QCOMPARE((SessionTime{} + 1s).time_since_epoch().count(), qint64{1'000'000'000});
        QCOMPARE(toSeconds(1500ms), 1.5);
        QCOMPARE(toSeconds(-1ns), -1e-9);
    }

    void roundsSecondsToTheNearestNanosecond_data()
    {
        QTest::addColumn<double>("seconds");
        QTest::addColumn<qint64>("nanoseconds");
        QTest::newRow("zero") << 0.0 << qint64{0};
        QTest::newRow("a sixtieth") << 1.0 / 60.0 << qint64{16'666'667};
        QTest::newRow("a third") << 1.0 / 3.0 << qint64{333'333'333};
        QTest::newRow("below half") << 1.4e-9 << qint64{1};
        QTest::newRow("above half") << 1.6e-9 << qint64{2};
        QTest::newRow("negative") << -1.6e-9 << qint64{-2};
        QTest::newRow("a day") << 86400.0 << qint64{86'400'000'000'000};
    }
    void roundsSecondsToTheNearestNanosecond()
    {
        QFETCH(double, seconds);
        QTEST(qint64{fromSeconds(seconds).count()}, "nanoseconds");
    }

    void keepsSessionAndLocalTimeApart()
    {
        static_assert(!std::is_convertible_v<SessionTime, LocalTime>);
        static_assert(!std::is_convertible_v<LocalTime, SessionTime>);
        static_assert(!std::is_constructible_v<SessionTime, LocalTime>);
        static_assert(!std::is_convertible_v<qint64, SessionTime>);
    }
};

CARINA_TEST(SessionTimeTest)

} // namespace carina::session_time_test

#include "tst_session_time.moc"
