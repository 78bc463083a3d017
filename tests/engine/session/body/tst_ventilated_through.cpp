#include "engine/session/body/ventilated_through.h"

#include "engine/session/facts/fact_rules.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carina::ventilated_through_test
{

namespace
{

constexpr GasSupply kRoomAir{};
constexpr GasSupply kMask{1.0, true, true};
constexpr Length kSize = millimetres(7.0);

RespiratorySettings onVentilator(VentilationMode mode = VentilationMode::VolumeControl)
{
    RespiratorySettings settings;
    settings.ventilator.mode = mode;
    settings.tube = kSize;
    settings.pattern.tidalVolume = millilitres(400.0);
    return settings;
}

RespiratorySettings byBag()
{
    RespiratorySettings settings;
    settings.bag = {perMinute(12.0), millilitres(500.0)};
    return settings;
}

double severityOf(const LungConditions& conditions, ConditionKind kind, ConditionSide side)
{
    const auto found = std::ranges::find_if(conditions, [&](const LungCondition& each) {
        return each.kind == kind && each.side == side;
    });
    return found == conditions.end() ? 0.0 : found->severity;
}

} // namespace

class TestVentilatedThrough : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void leavesATubeInTheTracheaAsItIsSet()
    {
        const TubePlace tube{TubeSeat::Trachea, kSize};
        QVERIFY(ventilatedThrough(onVentilator(), tube, kRoomAir) == onVentilator());
        QCOMPARE(stomachBreaths(onVentilator(), tube), Frequency{});
    }

    /// Sessions from before there was a monitor: neither tube nor mask is needed.
    void reachesThePatientWhereNobodyWatchesATube()
    {
        RespiratorySettings without = onVentilator();
        without.tube = {};
        QVERIFY(ventilatedThrough(without, {}, kRoomAir) == without);
        QVERIFY(ventilatedThrough(byBag(), {}, kRoomAir) == byBag());
    }

    void reachesNobodyThroughATubeThatIsWatchedOutside()
    {
        const TubePlace outside{TubeSeat::None, kSize};
        const RespiratorySettings alone = ventilatedThrough(onVentilator(), outside, kRoomAir);
        QVERIFY(alone.ventilator.mode == VentilationMode::Spontaneous);
        QCOMPARE(alone.tube, Length{});
        QCOMPARE(ventilatedThrough(byBag(), outside, kRoomAir).bag.rate, Frequency{});
        QVERIFY(ventilatedThrough(byBag(), outside, kMask) == byBag());
        QCOMPARE(stomachBreaths(byBag(), outside), Frequency{});
    }

    void blowsIntoTheStomachThroughTheOesophagus()
    {
        const TubePlace tube{TubeSeat::Oesophagus, kSize};
        for (const GasSupply& gas : {kRoomAir, kMask}) {
            const RespiratorySettings alone = ventilatedThrough(onVentilator(), tube, gas);
            QVERIFY(alone.ventilator.mode == VentilationMode::Spontaneous);
            QCOMPARE(alone.tube, Length{});
            QCOMPARE(alone.ownBreathing, 1.0);
            QVERIFY(alone.conditions.empty());
        }
        QCOMPARE(stomachBreaths(onVentilator(), tube), onVentilator().pattern.rate);
        QCOMPARE(stomachBreaths(byBag(), tube), perMinute(12.0));
        QCOMPARE(stomachBreaths(RespiratorySettings{}, tube), Frequency{});
    }

    void ventilatesTheLungOfItsSide()
    {
        using enum ConditionKind;
        const auto conditionsWith = [](TubeSeat seat, const LungConditions& set) {
            RespiratorySettings settings = onVentilator();
            settings.conditions = set;
            return ventilatedThrough(settings, {seat, kSize}, kRoomAir).conditions;
        };
        QVERIFY(conditionsWith(TubeSeat::RightMain, {})
                == (LungConditions{{MainstemIntubation, 1.0, ConditionSide::Right}}));
        QVERIFY(conditionsWith(TubeSeat::LeftMain, {})
                == (LungConditions{{MainstemIntubation, 1.0, ConditionSide::Left}}));
        const LungConditions set{{MainstemIntubation, 0.5, ConditionSide::Left}};
        QVERIFY(conditionsWith(TubeSeat::RightMain, set) == set); // as people set it
        const LungConditions asthma{{Asthma, 0.5, ConditionSide::Both}};
        QCOMPARE(conditionsWith(TubeSeat::RightMain, asthma).size(), std::size_t{2});
    }

    void losesWhatLeaksOfTheDeliveredVolume()
    {
        const TubePlace leaking{TubeSeat::Trachea, kSize, 0.25};
        const auto deliveredBy = [&](const RespiratorySettings& settings) {
            return ventilatedThrough(settings, leaking, kRoomAir);
        };
        QCOMPARE(inMillilitres(deliveredBy(onVentilator()).pattern.tidalVolume), 300.0);
        QCOMPARE(inMillilitres(deliveredBy(byBag()).bag.tidalVolume), 375.0);
        QCOMPARE(deliveredBy(byBag()).pattern.tidalVolume, byBag().pattern.tidalVolume);
        const RespiratorySettings pressure = onVentilator(VentilationMode::PressureControl);
        QCOMPARE(deliveredBy(pressure).pattern.tidalVolume, pressure.pattern.tidalVolume);
        const TubePlace open{TubeSeat::Trachea, kSize, 1.0};
        QCOMPARE(ventilatedThrough(onVentilator(), open, kRoomAir).pattern.tidalVolume,
                 kSmallestTidalVolume);
    }

    /// Borda and Carnot: at a narrow place half of the density times the square of how much faster
    /// the gas is there is lost.
    void losesThePressureOfAKinkInTheTube()
    {
        constexpr double kDensity = 1.2; // kg/m^3
        constexpr double kLoss = 1e-9;   // relative
        const TubePlace open{TubeSeat::Trachea, kSize};
        const TubePlace kinked{TubeSeat::Trachea, kSize, 0.0, 0.7};
        const auto lossOf = [](const TubePlace& tube) {
            return systemOf(ventilatedThrough(onVentilator(), tube, kRoomAir)).upperTurbulent;
        };
        const double section = std::numbers::pi / 4.0 * kSize.si * kSize.si;
        const double faster = (1.0 / 0.3 - 1.0) / section;
        const double ought = 0.5 * kDensity * faster * faster;
        QVERIFY(std::abs(lossOf(kinked) - lossOf(open) - ought) < kLoss * ought);
    }

    void letsNothingThroughATubeThatIsShut()
    {
        const TubePlace shut{TubeSeat::Trachea, kSize, 0.0, 1.0};
        const RespiratorySystem system =
            systemOf(ventilatedThrough(onVentilator(), shut, kRoomAir));
        QVERIFY(system.lungs[0].bronchi < kShut && system.lungs[1].bronchi < kShut);
    }

    void raisesThePressureOfTheVentilatorBehindAKink()
    {
        const auto peakThrough = [](double obstruction) {
            const TubePlace tube{TubeSeat::Trachea, kSize, 0.0, obstruction};
            RespiratoryFold fold{ventilatedThrough(onVentilator(), tube, kRoomAir)};
            for (int i = 0; i < 30 * 500; ++i)
                fold.step();
            return inCmH2O(fold.lastBreath().peak);
        };
        const double open = peakThrough(0.0);
        const double kinked = peakThrough(0.9);
        QVERIFY2(kinked > open + 5.0, qPrintable(QString::number(kinked)));
    }

    void addsAnObstructionToThoseThereAre()
    {
        using enum ConditionKind;
        LungConditions both{{Obstruction, 0.4, ConditionSide::Both}};
        obstruct(both, 0.0);
        QCOMPARE(severityOf(both, Obstruction, ConditionSide::Both), 0.4);
        obstruct(both, 0.6);
        QVERIFY(both == (LungConditions{{Obstruction, 0.6, ConditionSide::Both}}));
        obstruct(both, 0.5);
        QCOMPARE(severityOf(both, Obstruction, ConditionSide::Both), 0.6);
        LungConditions one{{Obstruction, 0.8, ConditionSide::Right}};
        obstruct(one, 0.5);
        QCOMPARE(severityOf(one, Obstruction, ConditionSide::Right), 0.8);
        QCOMPARE(severityOf(one, Obstruction, ConditionSide::Left), 0.5);
        QVERIFY(canCoexist(one));
    }

    void takesThePlaceOfTheMildestWhereThereIsNoRoom()
    {
        using enum ConditionKind;
        LungConditions full{{Ards, 0.5, ConditionSide::Both},
                            {Copd, 0.2, ConditionSide::Both},
                            {Asthma, 0.5, ConditionSide::Both},
                            {SimplePneumothorax, 0.5, ConditionSide::Right},
                            {Atelectasis, 0.5, ConditionSide::Left},
                            {StiffChest, 0.5, ConditionSide::Both}};
        QCOMPARE(full.size(), kMostConditions);
        obstruct(full, 1.0);
        QVERIFY(canCoexist(full));
        QCOMPARE(severityOf(full, Obstruction, ConditionSide::Both), 1.0);
        QCOMPARE(severityOf(full, Copd, ConditionSide::Both), 0.0);
    }
};

CARINA_TEST(TestVentilatedThrough)

} // namespace carina::ventilated_through_test

#include "tst_ventilated_through.moc"
