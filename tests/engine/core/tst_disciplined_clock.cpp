#include "engine/core/disciplined_clock.h"
#include "engine/core/monotonic_clock.h"
#include "tests/support/test_class.h"

namespace carina::disciplined_clock_test
{

using namespace std::chrono_literals;

class TestDisciplinedClock : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void onlyADisciplinedClockHasAnError_data()
    {
        QTest::addColumn<bool>("isSynchronised");
        QTest::addColumn<qint64>("estimated_us");
        QTest::addColumn<qint64>("largest_us");
        QTest::addColumn<qint64>("error_us"); // -1: none
        QTest::newRow("disciplined") << true << qint64{350} << qint64{12'000} << qint64{350};
        QTest::newRow("not synchronised") << false << qint64{350} << qint64{12'000} << qint64{-1};
        QTest::newRow("nobody says how well") << true << qint64{0} << qint64{0} << qint64{-1};
        QTest::newRow("lost") << true << qint64{350} << qint64{16'000'000} << qint64{-1};
        QTest::newRow("known to 16 s") << true << qint64{16'000'000} << qint64{1} << qint64{-1};
    }
    void onlyADisciplinedClockHasAnError()
    {
        QFETCH(bool, isSynchronised);
        QFETCH(qint64, estimated_us);
        QFETCH(qint64, largest_us);
        QFETCH(qint64, error_us);
        const auto error = statedError({isSynchronised, estimated_us * 1us, largest_us * 1us});
        QCOMPARE(error.has_value(), error_us >= 0);
        if (error)
            QCOMPARE(*error, Duration{error_us * 1us});
    }

    void readingIsOfTheSystemsClock()
    {
        const auto reading = readDisciplinedClock();
        if (!reading)
            QSKIP("the clock of this computer is not disciplined, or nobody says how well");
        QVERIFY(reading->error > 0s);
        const auto system = std::chrono::system_clock::now().time_since_epoch();
        const Duration read = monotonicNow().time_since_epoch() + reading->offset;
        QVERIFY(std::chrono::abs(system - read) < 1s);
    }
};

CARINA_TEST(TestDisciplinedClock)

} // namespace carina::disciplined_clock_test

#include "tst_disciplined_clock.moc"
