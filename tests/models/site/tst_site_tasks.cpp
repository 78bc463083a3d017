#include "models/site/site_tasks.h"

#include "tests/models/registration/made_site.h"
#include "tests/support/test_class.h"

namespace carina::site_tasks_test
{
namespace
{

using namespace test;

const QString kThisTracker = QString::fromStdString(kTracker);
const QDateTime kDay{{2004, 3, 27}, {12, 0}, Qt::UTC};

SiteTask taskOf(const Site& site, SiteStep step)
{
    return siteTask(site, step, kTool, kThisTracker, kDay);
}

TaskState stateOf(const Site& site, SiteStep step) { return taskOf(site, step).state; }

QStringList healthOf(const Site& site, const QDateTime& today,
                     const std::vector<ExpectedError>& expected = {})
{
    return siteHealth(site, kTool, kThisTracker, today, expected);
}

} // namespace

/// How far each task of a site is, and why it is no further.
class TestSiteTasks : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void knowsTheTracker()
    {
        QCOMPARE(stateOf({}, SiteStep::Tracker), TaskState::Open);
        QVERIFY(taskOf({}, SiteStep::Tracker).why.isEmpty());
        QCOMPARE(stateOf(preparedSite(), SiteStep::Tracker), TaskState::Done);
        const SiteTask other =
            siteTask(preparedSite(), SiteStep::Tracker, kTool, QStringLiteral("Tracker B"), kDay);
        QCOMPARE(other.state, TaskState::Stale);
        QVERIFY(other.why.contains(kThisTracker));
    }

    void knowsTheStylusInHand()
    {
        QCOMPARE(stateOf({}, SiteStep::Stylus), TaskState::Open);
        QCOMPARE(stateOf(preparedSite(), SiteStep::Stylus), TaskState::Done);
        QCOMPARE(
            siteTask(preparedSite(), SiteStep::Stylus, "Other stylus", kThisTracker, kDay).state,
            TaskState::Open);
    }

    void knowsTheLandmarks()
    {
        QCOMPARE(stateOf({}, SiteStep::Landmarks), TaskState::Open);
        QCOMPARE(stateOf(preparedSite(), SiteStep::Landmarks), TaskState::Done);
    }

    void knowsHowFarTheTouchingIs()
    {
        const Site noStylus = withLandmarks({}, eightLandmarks());
        QCOMPARE(stateOf(noStylus, SiteStep::Touch), TaskState::Waits);
        QVERIFY(taskOf(noStylus, SiteStep::Touch).why.contains(QStringLiteral("stylus")));
        QCOMPARE(stateOf(preparedSite(), SiteStep::Touch), TaskState::Open);
        QCOMPARE(stateOf(withStylus({}, someTip()), SiteStep::Touch), TaskState::Open);
        QCOMPARE(stateOf(touchedSite(3), SiteStep::Touch), TaskState::Begun);
        QCOMPARE(taskOf(touchedSite(3), SiteStep::Touch).why,
                 QStringLiteral("3 of 8 are touched."));
        QCOMPARE(stateOf(touchedSite(), SiteStep::Touch), TaskState::Done);
        QCOMPARE(stateOf(withStylus(touchedSite(), someTip()), SiteStep::Touch), TaskState::Stale);
    }

    void knowsTheFit()
    {
        QCOMPARE(stateOf(touchedSite(2), SiteStep::Fit), TaskState::Waits);
        QVERIFY(!taskOf(touchedSite(2), SiteStep::Fit).why.isEmpty());
        QCOMPARE(stateOf(touchedSite(3), SiteStep::Fit), TaskState::Open);
        QCOMPARE(stateOf(fittedSite(), SiteStep::Fit), TaskState::Done);
        QCOMPARE(stateOf(withStylus(fittedSite(), someTip()), SiteStep::Fit), TaskState::Stale);
    }

    void knowsTheVerification()
    {
        QCOMPARE(stateOf(touchedSite(), SiteStep::Verify), TaskState::Waits);
        QVERIFY(!taskOf(touchedSite(), SiteStep::Verify).why.isEmpty());
        QCOMPARE(stateOf(fittedSite(), SiteStep::Verify), TaskState::Open);
        QCOMPARE(stateOf(verifiedSite(Verdict::Open), SiteStep::Verify), TaskState::Begun);
        QVERIFY(!taskOf(verifiedSite(Verdict::Open), SiteStep::Verify).why.isEmpty());
        QCOMPARE(stateOf(verifiedSite(), SiteStep::Verify), TaskState::Done);
        QCOMPARE(stateOf(verifiedSite(Verdict::NotGood), SiteStep::Verify), TaskState::Begun);
        QVERIFY(!taskOf(verifiedSite(Verdict::NotGood), SiteStep::Verify).why.isEmpty());
        QCOMPARE(stateOf(withStylus(verifiedSite(), someTip()), SiteStep::Verify),
                 TaskState::Stale);
    }

    void leadsFromOneTaskToTheNext()
    {
        const auto next = [](const Site& site) {
            return nextTask(site, kTool, kThisTracker, kDay);
        };
        Site fittedAgain = verifiedSite(Verdict::NotGood);
        fittedAgain.verification->stale = StaleCause::Fit;
        QCOMPARE(next({}), SiteStep::Tracker);
        QCOMPARE(next(withTracker({}, kTracker)), SiteStep::Stylus);
        QCOMPARE(next(withStylus(withTracker({}, kTracker), someTip())), SiteStep::Landmarks);
        QCOMPARE(next(preparedSite()), SiteStep::Touch);
        QCOMPARE(next(touchedSite(5)), SiteStep::Touch);
        QCOMPARE(next(touchedSite()), SiteStep::Fit);
        QCOMPARE(next(fittedSite()), SiteStep::Verify);
        QCOMPARE(next(verifiedSite()), SiteStep::Overview);
        QCOMPARE(next(verifiedSite(Verdict::NotGood)), SiteStep::Touch);
        QCOMPARE(next(fittedAgain), SiteStep::Verify);
        QCOMPARE(next(withStylus(verifiedSite(), someTip())), SiteStep::Touch);
        QCOMPARE(stateOf(fittedSite(), SiteStep::Overview), TaskState::Begun);
        QCOMPARE(stateOf(verifiedSite(), SiteStep::Overview), TaskState::Done);
    }

    void saysWhatIsStaleAndWhy_data()
    {
        QTest::addColumn<int>("cause");
        QTest::addColumn<QString>("word");
        QTest::newRow("tracker") << int(StaleCause::Tracker) << QStringLiteral("tracker");
        QTest::newRow("stylus") << int(StaleCause::Stylus) << QStringLiteral("stylus");
        QTest::newRow("landmarks") << int(StaleCause::Landmarks) << QStringLiteral("changed");
        QTest::newRow("touches") << int(StaleCause::Touches) << QStringLiteral("touched again");
        QTest::newRow("fit") << int(StaleCause::Fit) << QStringLiteral("fitted again");
    }
    void saysWhatIsStaleAndWhy()
    {
        QFETCH(int, cause);
        QFETCH(QString, word);
        Site site = verifiedSite();
        site.touched[1].stale = static_cast<StaleCause>(cause);
        site.registration->stale = static_cast<StaleCause>(cause);
        site.verification->stale = static_cast<StaleCause>(cause);
        const QString health = healthOf(site, kDay).join(QLatin1Char('\n'));
        for (const SiteStep step : {SiteStep::Touch, SiteStep::Fit, SiteStep::Verify}) {
            QCOMPARE(stateOf(site, step), TaskState::Stale);
            QVERIFY2(taskOf(site, step).why.contains(word), qPrintable(taskOf(site, step).why));
            QVERIFY(health.contains(stepTitle(step) + QStringLiteral(": ")));
        }
    }

    void tellsTheHealthOfASite()
    {
        QCOMPARE(healthOf({}, kDay).size(), 1);
        const QStringList fitted = healthOf(fittedSite(), kDay);
        QVERIFY2(fitted[0].startsWith(QStringLiteral("Registered today. By A. Frei.")),
                 qPrintable(fitted[0]));
        QVERIFY(fitted[1].contains(QStringLiteral("not verified")));
        QCOMPARE(healthOf(verifiedSite(), kDay.addDays(2))[1],
                 QStringLiteral("Verified 2 days ago: good."));
        Site beyond = verifiedSite();
        beyond.verification->points.front().error = 2e-3;
        beyond.verification->points.front().bound = 1.9e-3;
        const QString told = healthOf(beyond, kDay)[1];
        QVERIFY(told.contains(QStringLiteral("2.0\u00a0mm")));
        QVERIFY(told.contains(QString::fromStdString(beyond.verification->points.front().name)));
        QVERIFY(
            healthOf(verifiedSite(Verdict::NotGood), kDay)[1].contains(QStringLiteral("not good")));
        const Site stale = withStylus(verifiedSite(), someTip());
        QVERIFY(healthOf(stale, kDay)[1].contains(QStringLiteral("not verified")));
    }

    void namesTheWorstPlaceToExpect()
    {
        const ExpectedError glottis{.name = QStringLiteral("Glottis"), .bound_mm = 1.24};
        const ExpectedError carina{.name = QStringLiteral("Carina"), .bound_mm = 0.9};
        const ExpectedError base{.name = QStringLiteral("Left lung base"), .bound_mm = 1.86};
        const QString worst = healthOf(fittedSite(), kDay, {glottis, base, carina})[1];
        QVERIFY2(worst.contains(QStringLiteral("Glottis, less than 1.2\u00a0mm")),
                 qPrintable(worst));
        QVERIFY2(worst.contains(QStringLiteral("Worst: Left lung base, less than 1.9\u00a0mm")),
                 qPrintable(worst));
        const QString first = healthOf(fittedSite(), kDay, {glottis, carina})[1];
        QVERIFY2(!first.contains(QStringLiteral("Worst")), qPrintable(first));
    }

    void saysHowOldTheStylusIs()
    {
        const auto inDays = [](int days) {
            return healthOf(preparedSite(), kDay.addDays(days)).join(QLatin1Char('\n'));
        };
        QVERIFY(!inDays(30).contains(QStringLiteral("stylus")));
        QVERIFY2(inDays(31).contains(QStringLiteral("The stylus was calibrated 31 days ago")),
                 qPrintable(inDays(31)));
    }

    void asksForAVerificationAfterAMonth()
    {
        const auto inDays = [](const Site& site, int days) {
            return siteTask(site, SiteStep::Verify, kTool, kThisTracker, kDay.addDays(days)).state;
        };
        QCOMPARE(healthOf(verifiedSite(), kDay.addDays(30)).size(), 2);
        QCOMPARE(inDays(verifiedSite(), 30), TaskState::Done);
        const QStringList old = healthOf(verifiedSite(), kDay.addDays(31));
        QCOMPARE(old.size(), 4); // and one of the stylus
        QVERIFY(old[3].contains(QStringLiteral("verify two points")));
        QCOMPARE(inDays(verifiedSite(), 31), TaskState::Stale);
        QCOMPARE(nextTask(verifiedSite(), kTool, kThisTracker, kDay.addDays(31)), SiteStep::Verify);
        Site again = verifiedSite(); // registered long ago, and verified since
        again.verification->at = kDay.addDays(29).toString(Qt::ISODate).toStdString();
        QCOMPARE(inDays(again, 31), TaskState::Done);
        QCOMPARE(healthOf(again, kDay.addDays(31)).size(), 3);
    }

    void tellsOfARelay()
    {
        Site site = verifiedSite();
        site.registration->relays = {{.at = "2004-03-26T08:00:00Z", .landmarks = 3}};
        const QString relaid = healthOf(site, kDay)[1];
        QVERIFY2(relaid.contains(QStringLiteral("3 landmarks yesterday")), qPrintable(relaid));
    }

    void countsDays()
    {
        QCOMPARE(howLongAgo("2004-03-27T00:10:00Z", kDay), QStringLiteral("today"));
        QCOMPARE(howLongAgo("2004-03-26T23:50:00Z", kDay), QStringLiteral("yesterday"));
        QCOMPARE(howLongAgo("2004-03-20T10:00:00Z", kDay), QStringLiteral("7 days ago"));
        QCOMPARE(howLongAgo("2004-04-01T10:00:00Z", kDay),
                 QStringLiteral("today")); // a wrong clock
    }
};

CARINA_TEST(TestSiteTasks)

} // namespace carina::site_tasks_test

#include "tst_site_tasks.moc"
