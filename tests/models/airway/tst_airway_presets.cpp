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
    void findNoneWhereOneSeverityDiffers();
    void haveAWordEach();
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

CARINA_TEST(TestAirwayPresets)

} // namespace carina::airway_presets_test

#include "tst_airway_presets.moc"
