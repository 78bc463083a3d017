#include "engine/scoring/course/depth_rule.h"

#include "tests/support/test_class.h"

#include <cmath>

namespace carina::depth_rule_test
{
namespace
{

constexpr double kRounding_mm = 1e-6;

/// Twelve years, 150 cm, with a tube of 6.5 mm.
const TubedPatient kChild{metres(1.50), 12.0, false, millimetres(6.5)};
const TubedPatient kWoman{metres(1.62), 30.0, true, millimetres(7.0)};
const TubedPatient kMan{metres(1.75), 30.0, false, millimetres(8.0)};

} // namespace

class TestDepthRule : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isAsPublished_data();
    void isAsPublished();
    void isForWhomItIsMade();
    void needsATubeWhereItAsksForOne();
    void hasAUsualOneForEverybody();
};

void TestDepthRule::isAsPublished_data()
{
    QTest::addColumn<DepthRule>("rule");
    QTest::addColumn<double>("depth_mm");
    QTest::newRow("Morgan") << DepthRule::TenthOfHeight << 200.0;
    QTest::newRow("an eighth of the height") << DepthRule::EighthOfHeight << 221.5;
    QTest::newRow("three diameters") << DepthRule::ThreeDiameters << 195.0;
    QTest::newRow("half of the age") << DepthRule::HalfOfAge << 180.0;
}

void TestDepthRule::isAsPublished()
{
    QFETCH(const DepthRule, rule);
    QFETCH(const double, depth_mm);
    QVERIFY(std::abs(inMillimetres(depthBy(rule, kChild).value()) - depth_mm) < kRounding_mm);
}

void TestDepthRule::isForWhomItIsMade()
{
    for (const DepthRule rule : kDepthRules) {
        const bool isForAdults = rule == DepthRule::WomanTwentyOneManTwentyThree;
        QCOMPARE(depthBy(rule, kChild).has_value(), !isForAdults);
        QCOMPARE(depthBy(rule, kMan).has_value(), isForAdults);
    }
    const DepthRule adults = DepthRule::WomanTwentyOneManTwentyThree;
    QCOMPARE(inMillimetres(depthBy(adults, kWoman).value()), 210.0);
    QCOMPARE(inMillimetres(depthBy(adults, kMan).value()), 230.0);
    TubedPatient infant = kChild;
    infant.ageInYears = 0.5;
    QVERIFY(!depthBy(DepthRule::HalfOfAge, infant));
}

void TestDepthRule::needsATubeWhereItAsksForOne()
{
    TubedPatient without = kChild;
    without.innerDiameter = {};
    QVERIFY(!depthBy(DepthRule::ThreeDiameters, without));
    QVERIFY(depthBy(DepthRule::TenthOfHeight, without));
}

void TestDepthRule::hasAUsualOneForEverybody()
{
    for (const TubedPatient& patient : {kChild, kWoman, kMan})
        QVERIFY(depthBy(usualDepthRule(patient), patient));
}

CARINA_TEST(TestDepthRule)

} // namespace carina::depth_rule_test

#include "tst_depth_rule.moc"
