#include "engine/sync/connection/loss_window.h"
#include "tests/support/test_class.h"

namespace carina::loss_window_test
{

class TestLossWindow : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysNothingBeforeAHundred()
    {
        LossWindow window;
        QVERIFY(!window.loss());
        for (std::uint32_t i = 1; i < 100; ++i)
            window.arrived(i);
        QVERIFY(!window.loss());
        window.arrived(100);
        QCOMPARE(window.loss(), std::optional{0.0});
    }

    void countsWhatIsMissing()
    {
        LossWindow window;
        for (std::uint32_t i = 1; i <= 200; ++i)
            if (i % 10 != 0 || i == 200)
                window.arrived(i);
        QCOMPARE(window.loss(), std::optional{1.0 - 181.0 / 200.0});
    }

    void whatWasOvertakenIsNotLost()
    {
        LossWindow window;
        for (std::uint32_t i = 1; i <= 128; ++i)
            if (i != 64)
                window.arrived(i);
        QCOMPARE(window.loss(), std::optional{1.0 / 128.0});
        window.arrived(64);
        window.arrived(64); // a copy
        QCOMPARE(window.loss(), std::optional{0.0});
    }

    void whatWasSentBeforeItBeganDoesNotCount()
    {
        LossWindow window;
        window.arrived(10);
        window.arrived(9);
        window.arrived(10 + 127);
        QCOMPARE(window.loss(), std::optional{1.0 - 2.0 / 128.0});
    }

    void forgetsWhatIsOlderThanItsWindow()
    {
        LossWindow window;
        window.arrived(1);
        window.arrived(1024); // 1022 are missing between
        QCOMPARE(window.loss(), std::optional{1.0 - 2.0 / 1024.0});
        window.arrived(1025); // the first is out of it
        QCOMPARE(window.loss(), std::optional{1.0 - 2.0 / 1024.0});
        window.arrived(1); // too late
        QCOMPARE(window.loss(), std::optional{1.0 - 2.0 / 1024.0});
        window.arrived(2); // the oldest that counts
        QCOMPARE(window.loss(), std::optional{1.0 - 3.0 / 1024.0});
        for (std::uint32_t i = 1026; i <= 1025 + 1024; ++i)
            window.arrived(i);
        QCOMPARE(window.loss(), std::optional{0.0});
    }

    void aLongGapIsAllLost_data()
    {
        QTest::addColumn<quint32>("gap");
        QTest::newRow("the window") << quint32{1024};
        QTest::newRow("more") << quint32{5000};
        QTest::newRow("as much as can be told") << quint32{0x7FFF'FFFF};
    }

    void aLongGapIsAllLost()
    {
        QFETCH(const quint32, gap);
        LossWindow window;
        for (std::uint32_t i = 1; i <= 1024; ++i)
            window.arrived(i);
        window.arrived(1024 + gap);
        QCOMPARE(window.loss(), std::optional{1023.0 / 1024.0});
    }

    void numbersWrap()
    {
        LossWindow window;
        for (std::uint32_t i = 0; i < 200; ++i)
            window.arrived(0xFFFF'FF9CU + i);
        QCOMPARE(window.loss(), std::optional{0.0});
    }
};

CARINA_TEST(TestLossWindow)

} // namespace carina::loss_window_test

#include "tst_loss_window.moc"
