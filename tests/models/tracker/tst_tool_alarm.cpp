#include "models/tracker/tool_alarm.h"

#include "tests/support/test_class.h"

namespace carina::tool_alarm_test
{
namespace
{

std::vector<ToolStatus> tool(ToolRole role, bool isVisible)
{
    return {{.role = role, .name = toolRoleName(role), .isVisible = isVisible}};
}

} // namespace

class TestToolAlarm : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsOnceThatAToolIsLostAndOnceThatItIsBack()
    {
        ToolAlarm alarm{ToolUse::Session};
        QVERIFY(alarm.look(tool(ToolRole::Tube, true)).lost.isEmpty());
        QVERIFY(alarm.look(tool(ToolRole::Tube, false)).lost.isEmpty()); // for a moment
        const auto lost = alarm.look(tool(ToolRole::Tube, false));
        QCOMPARE(lost.lost, QStringList{QStringLiteral("Tube")});
        QVERIFY(lost.losesNeeded && lost.back.isEmpty() && !lost.returnsNeeded);
        QVERIFY(alarm.look(tool(ToolRole::Tube, false)).lost.isEmpty());
        const auto back = alarm.look(tool(ToolRole::Tube, true));
        QCOMPARE(back.back, QStringList{QStringLiteral("Tube")});
        QVERIFY(back.returnsNeeded && back.lost.isEmpty() && !back.losesNeeded);
        QVERIFY(alarm.look(tool(ToolRole::Tube, true)).back.isEmpty());
    }

    void passesOverWhatWasHiddenForOneLook()
    {
        ToolAlarm alarm{ToolUse::Session};
        for (const bool isVisible : {true, false, true, false, true}) {
            const auto change = alarm.look(tool(ToolRole::Tube, isVisible));
            QVERIFY(change.lost.isEmpty() && change.back.isEmpty());
        }
    }

    void doesNotMissWhatWasNeverThere()
    {
        ToolAlarm alarm{ToolUse::Session};
        for (int look = 0; look < 5; ++look)
            QVERIFY(alarm.look(tool(ToolRole::Tube, false)).lost.isEmpty());
        QVERIFY(alarm.look(tool(ToolRole::Tube, true)).back.isEmpty());
    }

    void knowsWhichToolsAreNeeded_data()
    {
        QTest::addColumn<ToolRole>("role");
        QTest::addColumn<bool>("inSession");
        QTest::addColumn<bool>("inRegistration");
        QTest::newRow("head") << ToolRole::Head << true << false;
        QTest::newRow("chin probe") << ToolRole::Jaw << true << true;
        QTest::newRow("tube") << ToolRole::Tube << true << false;
        QTest::newRow("stylus") << ToolRole::Stylus << false << true;
        QTest::newRow("manikin") << ToolRole::Manikin << true << true;
        QTest::newRow("chest") << ToolRole::Chest << true << false;
        QTest::newRow("hand") << ToolRole::Hand << true << false;
        QTest::newRow("laryngoscope") << ToolRole::Laryngoscope << true << false;
        QTest::newRow("other") << ToolRole::Other << false << false;
    }
    void knowsWhichToolsAreNeeded()
    {
        QFETCH(const ToolRole, role);
        QFETCH(const bool, inSession);
        QFETCH(const bool, inRegistration);
        QCOMPARE(isNeeded(role, ToolUse::Session), inSession);
        QCOMPARE(isNeeded(role, ToolUse::Registration), inRegistration);
    }

    /// What is not needed is told, too, but not by a sound.
    void tellsOfToolsThatAreNotNeededApart()
    {
        ToolAlarm alarm{ToolUse::Session};
        (void)alarm.look(tool(ToolRole::Stylus, true));
        (void)alarm.look(tool(ToolRole::Stylus, false));
        const auto lost = alarm.look(tool(ToolRole::Stylus, false));
        QCOMPARE(lost.lost, QStringList{QStringLiteral("Stylus")});
        QVERIFY(!lost.losesNeeded);
    }
};

CARINA_TEST(TestToolAlarm)

} // namespace carina::tool_alarm_test

#include "tst_tool_alarm.moc"
