#include "models/airway/airway_presets.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <set>

namespace carina::airway_presets_test
{

class TestAirwayPresets : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginWithTheClearAirway();
    void areEachFoundByNameAndByEvents();
    void haveProperEventsThatAreThere();
    void haveWholePercents();
    void findNoneWhereOneSeverityDiffers();
    void haveAWordEach();
    void nameWhatIsSet();
    void areNamedForGrades();
    void haveASourceForEachRange();
    void areDrawnFromTheirRanges();
    void areDrawnAlikeFromTheSameSeed();
    void burnAsTheEventDoes();
};

void TestAirwayPresets::beginWithTheClearAirway()
{
    QVERIFY(airwayPresets().front().events.empty());
    QVERIFY(presetOf({}) == &airwayPresets().front());
}

void TestAirwayPresets::areEachFoundByNameAndByEvents()
{
    for (const AirwayPreset& preset : airwayPresets()) {
        QVERIFY(presetNamed(preset.name) == &preset);
        QVERIFY(presetOf(preset.events) == &preset);
    }
    QVERIFY(!presetNamed("cough"));
}

void TestAirwayPresets::haveProperEventsThatAreThere()
{
    for (const AirwayPreset& preset : airwayPresets()) {
        QVERIFY(areProper(preset.events));
        QVERIFY(std::ranges::all_of(preset.events,
                                    [](const AirwayEvent& event) { return event.severity > 0.0; }));
    }
}

// As the console's boxes set them.
void TestAirwayPresets::haveWholePercents()
{
    for (const AirwayPreset& preset : airwayPresets())
        for (const AirwayEvent& event : preset.events)
            QVERIFY(event.severity == qRound(100.0 * event.severity) / 100.0);
}

void TestAirwayPresets::findNoneWhereOneSeverityDiffers()
{
    for (const AirwayPreset& preset : airwayPresets())
        for (std::size_t n = 0; n < preset.events.size(); ++n) {
            AirwayEvents other = preset.events;
            other[n].severity -= 0.01;
            QVERIFY(!presetOf(other));
        }
}

void TestAirwayPresets::haveAWordEach()
{
    std::set<QString> words;
    for (const AirwayPreset& preset : airwayPresets())
        words.insert(presetText(preset));
    QCOMPARE(words.size(), airwayPresets().size());
    QVERIFY(!words.contains(QString{}));
}

void TestAirwayPresets::nameWhatIsSet()
{
    const AirwayPreset& preset = *presetNamed("anaphylaxis");
    QCOMPARE(airwayText(preset.events), QStringLiteral("Anaphylaxis"));
    QCOMPARE(shortAirwayText(preset.events), QStringLiteral("Anaphylaxis"));
    QCOMPARE(airwayText(presetNamed("web")->events), QStringLiteral("Laryngeal web 70\u00a0%"));
    QCOMPARE(shortAirwayText({}), QStringLiteral("Clear"));
    AirwayEvents onTheirWay = preset.events;
    for (AirwayEvent& event : onTheirWay)
        event.severity *= 0.5;
    QCOMPARE(airwayText(onTheirWay).count(QLatin1Char{'+'}), 3);
    QCOMPARE(shortAirwayText(onTheirWay), QStringLiteral("Laryngeal oedema 40\u00a0% + 3 more"));
}

void TestAirwayPresets::areNamedForGrades()
{
    const auto count = [](CormackLehane grade) {
        return std::ranges::count_if(airwayPresets(), [grade](const AirwayPreset& preset) {
            return isNamedFor(preset, grade);
        });
    };
    for (const CormackLehane grade :
         {CormackLehane::Grade1, CormackLehane::Grade2a, CormackLehane::Grade2b,
          CormackLehane::Grade3, CormackLehane::Grade4})
        QCOMPARE(count(grade), 1);
    QVERIFY(isNamedFor(*presetNamed("cormack_lehane_2"), CormackLehane::Grade2a));
    QVERIFY(isNamedFor(*presetNamed("cormack_lehane_2"), CormackLehane::Grade2b));
    QVERIFY(!isNamedFor(*presetNamed("cormack_lehane_2"), CormackLehane::Grade3));
    QVERIFY(!isNamedFor(airwayPresets().front(), CormackLehane::Grade1));
}

void TestAirwayPresets::haveASourceForEachRange()
{
    for (const AirwayPreset& preset : airwayPresets()) {
        QCOMPARE(preset.grade > 0, !preset.ranges.empty());
        for (std::size_t n = 0; n < preset.ranges.size(); ++n) {
            const SeverityRange& range = preset.ranges[n];
            QVERIFY(*range.source != '\0');
            QVERIFY(range.least > 0.0 && range.least < range.most && range.most <= 1.0);
            QVERIFY(preset.events.at(n).kind == range.kind);
            QCOMPARE(preset.events.at(n).severity, 0.5 * (range.least + range.most));
        }
    }
}

// From end to end of each: of 200 draws the smallest and the largest are within a tenth of them.
void TestAirwayPresets::areDrawnFromTheirRanges()
{
    std::mt19937 random{7};
    for (const AirwayPreset& preset : airwayPresets())
        for (std::size_t n = 0; n < preset.ranges.size(); ++n) {
            const SeverityRange& range = preset.ranges[n];
            double least = 1.0;
            double most = 0.0;
            for (int i = 0; i < 200; ++i) {
                const AirwayEvents events = drawnFrom(preset, random);
                QVERIFY(areProper(events));
                QVERIFY(events.at(n).kind == range.kind);
                least = std::min(least, events[n].severity);
                most = std::max(most, events[n].severity);
            }
            const double tenth = 0.1 * (range.most - range.least);
            QVERIFY(least >= range.least && least < range.least + tenth);
            QVERIFY(most <= range.most && most > range.most - tenth);
        }
}

void TestAirwayPresets::areDrawnAlikeFromTheSameSeed()
{
    const AirwayPreset& preset = *presetNamed("cormack_lehane_3");
    std::mt19937 one{1};
    std::mt19937 same{1};
    std::mt19937 other{2};
    const AirwayEvents first = drawnFrom(preset, one);
    QVERIFY(first == drawnFrom(preset, same));
    QVERIFY(first != drawnFrom(preset, one));
    QVERIFY(first != drawnFrom(preset, other));
    const AirwayPreset& fixed = *presetNamed("anaphylaxis");
    QVERIFY(drawnFrom(fixed, one) == fixed.events);
}

void TestAirwayPresets::burnAsTheEventDoes()
{
    QVERIFY((presetNamed("burn")->events == AirwayEvents{{AirwayEventKind::Burn, 1.0}}));
}

CARINA_TEST(TestAirwayPresets)

} // namespace carina::airway_presets_test

#include "tst_airway_presets.moc"
