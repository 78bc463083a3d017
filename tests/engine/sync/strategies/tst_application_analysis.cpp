#include "engine/sync/strategies/application_analysis.h"
#include "tests/support/test_class.h"

namespace carina::application_analysis_test
{
namespace
{

using namespace std::chrono_literals;

constexpr ParticipantId kTom{1};
constexpr ParticipantId kOlga{2};
constexpr ObjectId kTrachea{4};
constexpr ObjectId kLungs{5};

SessionTime after(Duration t) { return SessionTime{1000s + t}; }

} // namespace

class TestApplicationAnalysis : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void upshotIsOneOverTheDelay_data()
    {
        QTest::addColumn<qint64>("delay_us");
        QTest::addColumn<double>("upshot"); // per second
        QTest::newRow("1 ms, the paper's example") << qint64{1000} << 1000.0;
        QTest::newRow("20 ms, the paper's longest") << qint64{20'000} << 50.0;
        QTest::newRow("0.2 ms, the paper's LAN") << qint64{200} << 5000.0;
        QTest::newRow("2 s") << qint64{2'000'000} << 0.5;
    }

    void upshotIsOneOverTheDelay()
    {
        QFETCH(const qint64, delay_us);
        QFETCH(const double, upshot);
        QCOMPARE(upshotFrequency(std::chrono::microseconds{delay_us}), std::optional{upshot});
    }

    void noDelayHasNoUpshot()
    {
        QVERIFY(!upshotFrequency(0s));
        QVERIFY(!upshotFrequency(-1ns));
        QVERIFY(upshotFrequency(1ns));
    }

    void noActionHasNoFrequency()
    {
        const ApplicationAnalysis analysis;
        QVERIFY(!analysis.actionFrequency(kTom, 1, after(0s)));
    }

    void oneActionCountsOnceItsSecondIsOver()
    {
        ApplicationAnalysis analysis;
        analysis.acted(kTom, kTrachea, after(400ms));
        QVERIFY(!analysis.actionFrequency(kTom, 1, after(400ms)));
        QVERIFY(!analysis.actionFrequency(kTom, 1, after(1s - 1ns)));
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(1s)), std::optional{1.0});
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(2s)), std::optional{0.5});
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(10s)), std::optional{0.1});
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(11s)), std::optional{0.0});
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(1h)), std::optional{0.0});
        QVERIFY(!analysis.actionFrequency(kTom, 1, after(-5s))); // it was not yet
    }

    void aPersonAtAScreenActsFourTimesASecond()
    {
        // The paper's person, 240 ms a response: 25 actions in 6 s, 50 in 12 s.
        ApplicationAnalysis analysis;
        for (int i = 0; i < 100; ++i)
            analysis.acted(kTom, kTrachea, after(i * 240ms));
        const double frequency = analysis.actionFrequency(kTom, 1, after(24s)).value();
        QVERIFY(std::abs(frequency - 1.0 / 0.24) <= 0.1); // one of ten seconds' actions
    }

    void aTrackerActsAsOftenAsItMeasures()
    {
        ApplicationAnalysis analysis;
        for (int i = 0; i < 30 * 20; ++i)
            analysis.acted(kTom, kTrachea, after(Duration{1s} * i / 30));
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(1s)), std::optional{30.0});
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(20s)), std::optional{30.0});
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(20s + 999ms)), std::optional{30.0});
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(25s)), std::optional{15.0});
    }

    void actionsOfOneInstantCountEach()
    {
        ApplicationAnalysis analysis;
        for (int i = 0; i < 3; ++i)
            analysis.acted(kTom, kTrachea, after(1s)); // where a second begins: it is that second's
        QVERIFY(!analysis.actionFrequency(kTom, 1, after(1s)));
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(2s)), std::optional{3.0});
    }

    void theOrderOfArrivalDoesNotMatter()
    {
        ApplicationAnalysis inOrder;
        ApplicationAnalysis reversed;
        for (int i = 0; i < 40; ++i) {
            inOrder.acted(kTom, kTrachea, after(i * 250ms));
            reversed.acted(kTom, kTrachea, after((39 - i) * 250ms));
        }
        QCOMPARE(reversed.actionFrequency(kTom, 1, after(10s)), std::optional{4.0});
        QCOMPARE(inOrder.actionFrequency(kTom, 1, after(10s)), std::optional{4.0});
    }

    void whatCameFarTooLateIsNotKept()
    {
        ApplicationAnalysis analysis;
        analysis.acted(kTom, kTrachea, after(20s));
        analysis.acted(kTom, kTrachea, after(0s)); // the oldest kept
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(1s)), std::optional{1.0});
        analysis.acted(kTom, kTrachea, after(21s));
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(1s)), std::optional{0.0});
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(22s)), std::optional{0.2});
    }

    void equationThreeOfThePaper()
    {
        // b_jk in 2 s on m = 3 objects: Tom 6 and 4 and 0, Olga 0 and 3 and 0.
        ApplicationAnalysis analysis;
        for (int i = 0; i < 6; ++i)
            analysis.acted(kTom, kTrachea, after(i * 300ms));
        for (int i = 0; i < 4; ++i)
            analysis.acted(kTom, kLungs, after(i * 500ms));
        for (int i = 0; i < 3; ++i)
            analysis.acted(kOlga, kLungs, after(i * 600ms));
        QCOMPARE(analysis.actionFrequency(kTom, 3, after(2s)), std::optional{10.0 / (3.0 * 2.0)});
        QCOMPARE(analysis.actionFrequency(kOlga, 3, after(2s)), std::optional{3.0 / (3.0 * 2.0)});
        QCOMPARE(analysis.participants(), (std::vector{kTom, kOlga}));
    }

    void forgottenObjectsDoNotCount()
    {
        ApplicationAnalysis analysis;
        analysis.acted(kTom, kTrachea, after(0s));
        analysis.acted(kTom, kLungs, after(0s));
        analysis.acted(kOlga, kLungs, after(1ms));
        analysis.forget(kLungs);
        QCOMPARE(analysis.actionFrequency(kTom, 1, after(1s)), std::optional{1.0});
        QVERIFY(!analysis.actionFrequency(kOlga, 1, after(1s)));
        analysis.clear();
        QVERIFY(!analysis.actionFrequency(kTom, 1, after(1s)));
    }

    void sumOfTwoCountsIsThatOfOne()
    {
        ApplicationAnalysis whole;
        ApplicationAnalysis samples;
        ApplicationAnalysis actions;
        for (int i = 0; i < 50; ++i) {
            const SessionTime at = after(i * 210ms);
            whole.acted(kTom, i % 3 == 0 ? kLungs : kTrachea, at);
            (i % 3 == 0 ? actions : samples).acted(kTom, i % 3 == 0 ? kLungs : kTrachea, at);
        }
        samples.add(actions);
        for (const Duration t : {1s, 5s, 11s, 15s, 30s})
            QCOMPARE(samples.actionFrequency(kTom, 2, after(t)),
                     whole.actionFrequency(kTom, 2, after(t)));
    }

    void categoryIsByWhichIsLarger()
    {
        QCOMPARE(categoryOf(4.0, 50.0), ApplicationCategory::BelowUpshot);
        QCOMPARE(categoryOf(0.0, 50.0), ApplicationCategory::BelowUpshot);
        QCOMPARE(categoryOf(50.0, 50.0), ApplicationCategory::AboveUpshot);
        QCOMPARE(categoryOf(60.0, 50.0), ApplicationCategory::AboveUpshot);
    }
};

CARINA_TEST(TestApplicationAnalysis)

} // namespace carina::application_analysis_test

#include "tst_application_analysis.moc"
