#include "engine/core/clock_shift.h"
#include "tests/support/test_class.h"

namespace carina::clock_shift_test
{

using namespace std::chrono_literals;

namespace
{

Result<ClockShift> shiftFrom(const QString& offsetMs, const QString& ppm)
{
    const QByteArray offset = offsetMs.toLatin1();
    const QByteArray skew = ppm.toLatin1();
    return clockShiftFrom(offsetMs.isNull() ? nullptr : offset.constData(),
                          ppm.isNull() ? nullptr : skew.constData());
}

} // namespace

class TestClockShift : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void shiftsByOffsetAndSkew_data()
    {
        QTest::addColumn<QString>("offsetMs"); // null for none
        QTest::addColumn<QString>("ppm");
        QTest::addColumn<qint64>("expectedNs"); // at 1000 s
        const QString none;
        QTest::newRow("neither") << none << none << qint64{1'000'000'000'000};
        QTest::newRow("offset") << "-250" << none << qint64{999'750'000'000};
        QTest::newRow("part of a millisecond") << "0.5" << none << qint64{1'000'000'500'000};
        QTest::newRow("skew") << none << "50" << qint64{1'000'050'000'000};
        QTest::newRow("both") << "250"
                              << "-50" << qint64{1'000'200'000'000};
        QTest::newRow("the largest") << "86400000"
                                     << "1000" << qint64{87'401'000'000'000};
    }

    void shiftsByOffsetAndSkew()
    {
        QFETCH(QString, offsetMs);
        QFETCH(QString, ppm);
        QFETCH(qint64, expectedNs);
        const auto shift = shiftFrom(offsetMs, ppm);
        QVERIFY(shift);
        const LocalTime machine{1000s};
        const LocalTime process = shift->process(machine);
        QCOMPARE(qint64{process.time_since_epoch().count()}, expectedNs);
        QVERIFY(std::chrono::abs(shift->machine(process) - machine) <= 1ns);
    }

    void refusesWhatIsNoShift_data()
    {
        QTest::addColumn<QString>("offsetMs"); // null for none
        QTest::addColumn<QString>("ppm");
        QTest::newRow("word") << "late"
                              << "0";
        QTest::newRow("nothing") << ""
                                 << "0";
        QTest::newRow("unit") << "0"
                              << "50ppm";
        QTest::newRow("not a number") << "nan"
                                      << "0";
        QTest::newRow("more than a day") << "86400000.1"
                                         << "0";
        QTest::newRow("too fast") << "0"
                                  << "1000.001";
        QTest::newRow("too slow") << "0"
                                  << "-1000.001";
    }

    void refusesWhatIsNoShift()
    {
        QFETCH(QString, offsetMs);
        QFETCH(QString, ppm);
        QCOMPARE(shiftFrom(offsetMs, ppm).error().code, Errc::OutOfRange);
    }
};

CARINA_TEST(TestClockShift)

} // namespace carina::clock_shift_test

#include "tst_clock_shift.moc"
