#include "models/tracker/background_work.h"

#include "tests/support/test_class.h"

#include <QSignalSpy>

namespace carina::background_work_test
{

/// The works here go on until they are told to end: they end by that alone.
class TestBackgroundWork : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsHowFarItIsAndThatItHasEnded()
    {
        BackgroundWork work;
        const QSignalSpy progressed{&work, &BackgroundWork::progressed};
        const QSignalSpy finished{&work, &BackgroundWork::finished};
        work.start([](const Progress& goesOn) {
            while (goesOn(0.4)) {}
        });
        QVERIFY(work.isUnderWay());
        QTRY_COMPARE(work.percent(), 40);
        QTRY_COMPARE(progressed.count(), 1);
        work.cancel();
        QTRY_COMPARE(finished.count(), 1);
        QVERIFY(!work.isUnderWay());
    }

    void canBeDoneAgainAfterItWasCancelled()
    {
        BackgroundWork work;
        work.start([](const Progress& goesOn) {
            while (goesOn(0.0)) {}
        });
        work.cancel();
        QTRY_VERIFY(!work.isUnderWay());
        bool wentOn = false;
        work.start([&wentOn](const Progress& goesOn) { wentOn = goesOn(1.0); });
        QTRY_VERIFY(!work.isUnderWay());
        QVERIFY(wentOn);
    }

    void isCancelledByItsDestructor()
    {
        bool hasEnded = false;
        {
            BackgroundWork work;
            work.start([&hasEnded](const Progress& goesOn) {
                while (goesOn(0.0)) {}
                hasEnded = true;
            });
        }
        QVERIFY(hasEnded);
    }
};

CARINA_TEST(TestBackgroundWork)

} // namespace carina::background_work_test

#include "tst_background_work.moc"
