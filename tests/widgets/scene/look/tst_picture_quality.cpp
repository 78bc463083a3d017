#include "tests/support/test_class.h"
#include "widgets/scene/look/picture_quality.h"

#include <algorithm>
#include <array>

namespace carina::picture_quality_test
{

using std::chrono::microseconds;
using std::chrono::milliseconds;

namespace
{

constexpr Duration kBudget = milliseconds{25};
constexpr Duration kInterval = milliseconds{16};
constexpr int kDecision = QualityChoice::kFramesPerDecision + QualityChoice::kFramesToSettle;

/// What a frame takes in each quality on some computer.
using FrameCosts = std::array<Duration, kPictureQualities>;

constexpr FrameCosts kGraphicsCard{microseconds{2000}, microseconds{2100}, microseconds{2400}};
constexpr FrameCosts kSoftware{milliseconds{8}, milliseconds{11}, milliseconds{30}};
constexpr FrameCosts kSlow{milliseconds{30}, milliseconds{40}, milliseconds{90}};

Duration costIn(PictureQuality quality, const FrameCosts& costs)
{
    return costs[static_cast<std::size_t>(quality)];
}

void draw(QualityChoice& choice, int frames, const FrameCosts& costs, bool isDetailFinest = true)
{
    for (int i = 0; i < frames; ++i)
        choice.frameTook(costIn(choice.quality(), costs), kInterval, isDetailFinest);
}

QualityChoice fineChoice()
{
    QualityChoice choice{kBudget};
    draw(choice, 10 * kDecision, kGraphicsCard);
    return choice;
}

} // namespace

class TestPictureQuality : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void startsWithTheQuickest();
    void risesStepByStepWhereEdgesTakeHardlyAnyTime();
    void staysQuickWhereFramesAreSlow();
    void makesNoViewSlowerByMoreThanATwentieth_data();
    void makesNoViewSlowerByMoreThanATwentieth();
    void takesWhatIsLeftBetweenRareFrames();
    void isNotMisledByASceneThatIsBeingPrepared();
    void fallsWhereFramesBecomeSlow();
    void leavesTheTimeToTheSurfacesFirst();
    void triesAgainOnceTheComputerIsFree();
    void beginsAnewWithTheQuickest();
    void keepsWhatIsFixed();
};

void TestPictureQuality::startsWithTheQuickest()
{
    QCOMPARE(QualityChoice{kBudget}.quality(), PictureQuality::Quick);
}

void TestPictureQuality::risesStepByStepWhereEdgesTakeHardlyAnyTime()
{
    QualityChoice choice{kBudget};
    draw(choice, 2 * kDecision, kGraphicsCard);
    QCOMPARE(choice.quality(), PictureQuality::Smoothed);
    draw(choice, kDecision, kGraphicsCard);
    QCOMPARE(choice.quality(), PictureQuality::Fine);
    draw(choice, 100 * kDecision, kGraphicsCard);
    QCOMPARE(choice.quality(), PictureQuality::Fine);
}

void TestPictureQuality::staysQuickWhereFramesAreSlow()
{
    QualityChoice choice{kBudget};
    for (int i = 0; i < 2000; ++i) {
        draw(choice, 1, kSlow);
        QCOMPARE(choice.quality(), PictureQuality::Quick);
    }
}

void TestPictureQuality::makesNoViewSlowerByMoreThanATwentieth_data()
{
    QTest::addColumn<FrameCosts>("costs");
    QTest::addColumn<Duration>("interval");
    QTest::newRow("a graphics card") << kGraphicsCard << kInterval;
    QTest::newRow("without one") << kSoftware << kInterval;
    QTest::newRow("without one, a small picture")
        << FrameCosts{milliseconds{3}, microseconds{3900}, milliseconds{9}} << kInterval;
    QTest::newRow("without one, slower than its interval")
        << FrameCosts{milliseconds{18}, milliseconds{25}, milliseconds{60}} << kInterval;
    QTest::newRow("without one and without a pause") << kSoftware << Duration::zero();
    QTest::newRow("without one, drawn seldom")
        << FrameCosts{milliseconds{12}, milliseconds{15}, milliseconds{50}}
        << Duration{milliseconds{80}};
}

/// In frames per second, and in the time that is left to others, over some minutes with all that
/// was tried.
void TestPictureQuality::makesNoViewSlowerByMoreThanATwentieth()
{
    constexpr int kFrames = 30'000;
    QFETCH(FrameCosts, costs);
    QFETCH(Duration, interval);
    QualityChoice choice{kBudget};
    Duration drawing{};
    Duration whole{};
    for (int i = 0; i < kFrames; ++i) {
        const Duration took = costIn(choice.quality(), costs);
        drawing += took;
        whole += std::max(took, interval);
        choice.frameTook(took, interval, true);
    }
    const Duration whileQuick = std::max(costs.front(), interval);
    const double slower = toSeconds(whole) / (kFrames * toSeconds(whileQuick)) - 1.0;
    const double taken =
        toSeconds(drawing - kFrames * costs.front()) / (kFrames * toSeconds(whileQuick));
    QVERIFY2(slower < 0.05, qPrintable(QString::number(slower)));
    QVERIFY2(taken < 0.05, qPrintable(QString::number(taken)));
}

/// 3 ms more in 80 are less than a twentieth, 38 are not.
void TestPictureQuality::takesWhatIsLeftBetweenRareFrames()
{
    constexpr FrameCosts kCosts{milliseconds{12}, milliseconds{15}, milliseconds{50}};
    QualityChoice choice{kBudget};
    for (int i = 0; i < 10 * kDecision; ++i)
        choice.frameTook(costIn(choice.quality(), kCosts), milliseconds{80}, true);
    QCOMPARE(choice.quality(), PictureQuality::Smoothed);
}

/// The first frames take longer than the quickest does, so the next would seem to add nothing.
void TestPictureQuality::isNotMisledByASceneThatIsBeingPrepared()
{
    QualityChoice choice{kBudget};
    draw(choice, kDecision, {milliseconds{14}, milliseconds{14}, milliseconds{14}});
    draw(choice, 10 * kDecision, kSoftware);
    QCOMPARE(choice.quality(), PictureQuality::Quick);
}

void TestPictureQuality::fallsWhereFramesBecomeSlow()
{
    QualityChoice choice = fineChoice();
    // 20 budgets are 500 ms: of 90 ms six frames, and then of 40 ms thirteen
    draw(choice, QualityChoice::kFramesPerDecision, kSlow);
    QCOMPARE(choice.quality(), PictureQuality::Smoothed);
    draw(choice, 13 + QualityChoice::kFramesToSettle, kSlow);
    QCOMPARE(choice.quality(), PictureQuality::Quick);
    draw(choice, 10 * kDecision, kSlow);
    QCOMPARE(choice.quality(), PictureQuality::Quick);
}

void TestPictureQuality::leavesTheTimeToTheSurfacesFirst()
{
    QualityChoice choice{kBudget};
    draw(choice, 20 * kDecision, kGraphicsCard, false);
    QCOMPARE(choice.quality(), PictureQuality::Quick);
    draw(choice, kDecision, kGraphicsCard, true);
    QCOMPARE(choice.quality(), PictureQuality::Smoothed);
}

void TestPictureQuality::triesAgainOnceTheComputerIsFree()
{
    QualityChoice choice{kBudget};
    draw(choice, 5 * kDecision, kSoftware);
    QCOMPARE(choice.quality(), PictureQuality::Quick);
    draw(choice, (QualityChoice::kDecisionsApart + 5) * kDecision, kGraphicsCard);
    QCOMPARE(choice.quality(), PictureQuality::Fine);
}

void TestPictureQuality::beginsAnewWithTheQuickest()
{
    QualityChoice choice = fineChoice();
    QCOMPARE(choice.quality(), PictureQuality::Fine);
    choice.beginAnew();
    QCOMPARE(choice.quality(), PictureQuality::Quick);
    draw(choice, 5 * kDecision, kSoftware);
    QCOMPARE(choice.quality(), PictureQuality::Quick);
    choice.beginAnew(); // and what was too slow may be tried
    draw(choice, 4 * kDecision, kGraphicsCard);
    QCOMPARE(choice.quality(), PictureQuality::Fine);
}

void TestPictureQuality::keepsWhatIsFixed()
{
    QualityChoice choice{kBudget};
    choice.fix(PictureQuality::Fine);
    draw(choice, 5 * kDecision, kSlow);
    QCOMPARE(choice.quality(), PictureQuality::Fine);
    choice.fix(std::nullopt);
    QCOMPARE(choice.quality(), PictureQuality::Quick);
}

CARINA_TEST(TestPictureQuality)

} // namespace carina::picture_quality_test

#include "tst_picture_quality.moc"
