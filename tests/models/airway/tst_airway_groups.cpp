#include "models/airway/airway_groups.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <set>

namespace carina::airway_groups_test
{

class TestAirwayGroups : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void haveEachKindOnce();
    void areFoundByName();
    void keepWhatAHelperDoesApart();
    void haveAWordEach();
};

void TestAirwayGroups::haveEachKindOnce()
{
    for (int place = 0; place < kAirwayEventKinds; ++place) {
        const auto kind = static_cast<AirwayEventKind>(place);
        const auto groups = std::ranges::count_if(airwayGroups(), [kind](const AirwayGroup& group) {
            return std::ranges::count(group.kinds, kind) == 1;
        });
        QVERIFY2(groups == 1, eventName(kind));
    }
}

void TestAirwayGroups::areFoundByName()
{
    for (const AirwayGroup& group : airwayGroups())
        QVERIFY(airwayGroupNamed(group.name) == &group);
    QVERIFY(!airwayGroupNamed("nose"));
}

/// A manoeuvre is no disease.
void TestAirwayGroups::keepWhatAHelperDoesApart()
{
    const AirwayGroup& last = airwayGroups().back();
    QCOMPARE(last.kinds.size(), std::size_t{1});
    QVERIFY(last.kinds.front() == AirwayEventKind::ExternalPressure);
}

void TestAirwayGroups::haveAWordEach()
{
    std::set<QString> words;
    for (const AirwayGroup& group : airwayGroups())
        words.insert(groupText(group));
    QCOMPARE(words.size(), airwayGroups().size());
    QVERIFY(!words.contains(QString{}));
}

CARINA_TEST(TestAirwayGroups)

} // namespace carina::airway_groups_test

#include "tst_airway_groups.moc"
