#include "tests/support/soon.h"
#include "tests/support/test_class.h"
#include "widgets/second_press.h"

#include <QSignalSpy>

namespace carina::second_press_test
{
namespace
{

using namespace std::chrono_literals;

/// As long as a person pauses who means it.
void pause(std::chrono::milliseconds time = SecondPress::kLeastPause + 100ms)
{
    bool isOver = false;
    QTimer::singleShot(time, qApp, [&isOver] { isOver = true; });
    QVERIFY(test::soon([&isOver] { return isOver; }));
}

} // namespace

class TestSecondPress : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void asksAndThenDoesIt()
    {
        SecondPress twice;
        const QSignalSpy done{&twice, &SecondPress::confirmed};
        twice.press();
        QVERIFY(twice.isAsked());
        pause();
        QCOMPARE(done.count(), 0);
        twice.press();
        QCOMPARE(done.count(), 1);
        QVERIFY(!twice.isAsked());
    }

    void takesADoubleClickForOnePress()
    {
        SecondPress twice;
        const QSignalSpy done{&twice, &SecondPress::confirmed};
        twice.press();
        twice.press();
        QCOMPARE(done.count(), 0);
        QVERIFY(twice.isAsked());
    }

    void takesAHeldKeyForOnePress()
    {
        SecondPress twice;
        const QSignalSpy done{&twice, &SecondPress::confirmed};
        QTimer held;
        connect(&held, &QTimer::timeout, &twice, &SecondPress::press);
        held.start(30ms);
        pause(3 * SecondPress::kLeastPause);
        QCOMPARE(done.count(), 0);
        QVERIFY(twice.isAsked());
    }

    void waitsAFewSecondsForTheSecond()
    {
        SecondPress twice;
        const QSignalSpy done{&twice, &SecondPress::confirmed};
        twice.press();
        QVERIFY(test::soon([&] { return !twice.isAsked(); }, 8s));
        twice.press(); // asks anew
        QVERIFY(twice.isAsked());
        QCOMPARE(done.count(), 0);
    }

    void forgetsThatItWasAsked()
    {
        SecondPress twice;
        const QSignalSpy done{&twice, &SecondPress::confirmed};
        twice.press();
        twice.forget();
        QVERIFY(!twice.isAsked());
        pause();
        twice.press();
        QCOMPARE(done.count(), 0);
    }
};

CARINA_SCREEN_TEST(TestSecondPress)

} // namespace carina::second_press_test

#include "tst_second_press.moc"
