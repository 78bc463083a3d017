#include "engine/anatomy/events/throat_room.h"

#include "engine/anatomy/events/swallow.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>

namespace carina::throat_room_test
{
namespace
{

using enum AirwayEventKind;

constexpr double kRounding = 1e-12; ///< of a severity

AirwayEvents drawn(const AirwayEvents& events)
{
    return asDrawn(events, [](AirwayEventKind) { return true; });
}

bool isNear(const AirwayEvents& events, const AirwayEvents& expected)
{
    return std::ranges::equal(events, expected, [](const AirwayEvent& a, const AirwayEvent& b) {
        return a.kind == b.kind && std::abs(a.severity - b.severity) < kRounding;
    });
}

} // namespace

/// How severe events are drawn that fill the throat.
class TestThroatRoom : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsTwoAtTheirWorstAsTheyAre()
    {
        const AirwayEvents two{{TongueOedema, 1.0}, {Epiglottitis, 1.0}, {Laryngospasm, 1.0}};
        QVERIFY(drawn(two) == two);
    }

    /// Three at their worst are drawn as of 2 / 3 each, and of 1, 1 and 0.5 as of 4 / 5 of that.
    void drawsEachOfMoreLessInProportion()
    {
        constexpr double kThird = 2.0 / 3.0;
        QVERIFY(isNear(
            drawn({{TongueOedema, 1.0}, {PharyngealSwelling, 1.0}, {FloppyEpiglottis, 1.0}}),
            {{TongueOedema, kThird}, {PharyngealSwelling, kThird}, {FloppyEpiglottis, kThird}}));
        QVERIFY(isNear(drawn({{TongueOedema, 1.0}, {PharyngealSwelling, 0.5}, {Epiglottitis, 1.0}}),
                       {{TongueOedema, 0.8}, {PharyngealSwelling, 0.4}, {Epiglottitis, 0.8}}));
    }

    void leavesWhatDoesNotFillTheThroat()
    {
        const AirwayEvents events = drawn({{TongueOedema, 1.0},
                                           {PharyngealSwelling, 1.0},
                                           {Epiglottitis, 1.0},
                                           {LaryngealOedema, 0.9},
                                           {AngioOedema, 0.8},
                                           {NeckObesity, 0.7}});
        QCOMPARE(severityOf(events, LaryngealOedema), 0.9);
        QCOMPARE(severityOf(events, AngioOedema), 0.8);
        QCOMPARE(severityOf(events, NeckObesity), 0.7);
    }

    /// By 0.3, 0.7 and 0.4 of the severity; less than what is set changes nothing.
    void swellsByABurnWhatIsNotSwollenMore()
    {
        QVERIFY(isNear(drawn({{Epiglottitis, 0.3}, {Burn, 0.5}}), {{TongueOedema, 0.15},
                                                                   {PharyngealSwelling, 0.35},
                                                                   {Epiglottitis, 0.3},
                                                                   {LaryngealOedema, 0.35},
                                                                   {Burn, 0.5}}));
    }

    /// By 0.5, 0.6 and 0.8 of what has risen, and not while the cords alone have moved.
    void movesInASwallowWhatIsNotMovedMore()
    {
        QVERIFY(
            isNear(drawn({{FloppyEpiglottis, 0.9}, {Swallowing, 1.0}}), {{PharyngealSwelling, 0.5},
                                                                         {LaryngealOedema, 0.6},
                                                                         {FloppyEpiglottis, 0.9},
                                                                         {Swallowing, 1.0}}));
        const AirwayEvents begun{{Swallowing, kCordsShutInSwallow}};
        QVERIFY(drawn(begun) == begun);
    }

    /// Without a tongue a burn swells none, which leaves its room to the others: 0.7, 1 and 1 are
    /// 2.7 together, and 3 with the tongue's 0.3.
    void countsOnlyWhatThePatientShows()
    {
        const AirwayEvents set{
            {TongueOedema, 1.0}, {Epiglottitis, 1.0}, {FloppyEpiglottis, 1.0}, {Burn, 1.0}};
        const AirwayEvents events =
            asDrawn(set, [](AirwayEventKind kind) { return kind != TongueOedema; });
        QCOMPARE(severityOf(events, TongueOedema), 0.0);
        QVERIFY(std::abs(severityOf(events, Epiglottitis) - 2.0 / 2.7) < kRounding);
        QVERIFY(std::abs(severityOf(events, PharyngealSwelling) - 0.7 * 2.0 / 2.7) < kRounding);
        QCOMPARE(severityOf(events, Burn), 1.0);
    }
};

CARINA_TEST(TestThroatRoom)

} // namespace carina::throat_room_test

#include "tst_throat_room.moc"
