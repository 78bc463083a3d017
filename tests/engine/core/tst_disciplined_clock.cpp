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
        // 12 ms are 24 s at 500 ppm, in which 1 ppm makes 24 us.
        QTest::newRow("disciplined") << true << qint64{350} << qint64{12'000} << qint64{374};
        QTest::newRow("set just now") << true << qint64{50} << qint64{0} << qint64{50};
        QTest::newRow("alone for 1000 s") << true << qint64{50} << qint64{500'000} << qint64{1050};
        QTest::newRow("alone for 50 min")
            << true << qint64{50} << qint64{1'500'000} << qint64{3050};
        QTest::newRow("alone for hours") << true << qint64{50} << qint64{3'600'000} << qint64{-1};
        QTest::newRow("not synchronised") << false << qint64{350} << qint64{12'000} << qint64{-1};
        QTest::newRow("nobody says how well") << true << qint64{0} << qint64{0} << qint64{-1};
        QTest::newRow("lost") << true << qint64{350} << qint64{16'000'000} << qint64{-1};
        // linuxptp sets maxerror alone; esterror is the kernel's.
        QTest::newRow("by linuxptp") << true << qint64{16'000'000} << qint64{500} << qint64{-1};
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

    void injectedClockIsAsItIsSaidToBe_data()
    {
        QTest::addColumn<QByteArray>("offsetMs"); // null for none
        QTest::addColumn<QByteArray>("errorMs");
        QTest::addColumn<bool>("isInjected");
        QTest::addColumn<qint64>("offset_us");
        QTest::addColumn<qint64>("error_us");
        const QByteArray none;
        QTest::newRow("none") << none << none << false << qint64{0} << qint64{0};
        QTest::newRow("offset alone") << QByteArray{"3"} << none << false << qint64{0} << qint64{0};
        QTest::newRow("exact") << none << QByteArray{"0.25"} << true << qint64{0} << qint64{250};
        QTest::newRow("off") << QByteArray{"-1.5"} << QByteArray{"1"} << true << qint64{-1500}
                             << qint64{1000};
        QTest::newRow("not disciplined")
            << QByteArray{"2"} << QByteArray{"0"} << true << qint64{2000} << qint64{0};
    }
    void injectedClockIsAsItIsSaidToBe()
    {
        QFETCH(QByteArray, offsetMs);
        QFETCH(QByteArray, errorMs);
        QFETCH(bool, isInjected);
        QFETCH(qint64, offset_us);
        QFETCH(qint64, error_us);
        const auto clock = injectedClockFrom(offsetMs.isNull() ? nullptr : offsetMs.constData(),
                                             errorMs.isNull() ? nullptr : errorMs.constData());
        QVERIFY(clock);
        QCOMPARE(clock->has_value(), isInjected);
        if (isInjected)
            QVERIFY((**clock == InjectedClock{offset_us * 1us, error_us * 1us}));
    }

    void whatIsNoInjectedClockIsRefused_data()
    {
        QTest::addColumn<QByteArray>("offsetMs");
        QTest::addColumn<QByteArray>("errorMs");
        QTest::newRow("offset of a word") << QByteArray{"late"} << QByteArray{"1"};
        QTest::newRow("error of a word") << QByteArray{"0"} << QByteArray{"good"};
        QTest::newRow("error below 0") << QByteArray{"0"} << QByteArray{"-1"};
        QTest::newRow("more than a day") << QByteArray{"86400000.1"} << QByteArray{"1"};
    }
    void whatIsNoInjectedClockIsRefused()
    {
        QFETCH(QByteArray, offsetMs);
        QFETCH(QByteArray, errorMs);
        const auto clock = injectedClockFrom(offsetMs.constData(), errorMs.constData());
        QVERIFY(!clock);
        QCOMPARE(clock.error().code, Errc::OutOfRange);
    }

    void injectedClockIsReadBesideTheSystems()
    {
        constexpr Duration kOffset = -7ms;
        constexpr Duration kError = 2ms;
        const auto system = [] { return std::chrono::system_clock::now().time_since_epoch(); };
        const LocalTime before = monotonicNow();
        const auto systemBefore = system();
        const auto reading = readInjectedClock({kOffset, kError});
        const auto systemAfter = system();
        const LocalTime after = monotonicNow();
        QVERIFY(reading);
        QVERIFY(reading->offset >= systemBefore + kOffset - after.time_since_epoch());
        QVERIFY(reading->offset <= systemAfter + kOffset - before.time_since_epoch());
        QVERIFY(reading->error >= kError && reading->error <= kError + (after - before));
        QVERIFY(!readInjectedClock({kOffset, 0ms}));
    }
};

CARINA_TEST(TestDisciplinedClock)

} // namespace carina::disciplined_clock_test

#include "tst_disciplined_clock.moc"
