#include "models/airway/head_positions.h"
#include "tests/support/test_class.h"

#include <set>

namespace carina::head_positions_test
{

class TestHeadPositions : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void beginWithTheNeutralOne()
    {
        QVERIFY(usualHeadPositions().front().position == HeadPosition{});
        QVERIFY(usualOf({}) == &usualHeadPositions().front());
    }

    void areEachFoundByNameAndByAngles()
    {
        std::set<QString> words;
        for (const UsualHeadPosition& usual : usualHeadPositions()) {
            QVERIFY(headPositionNamed(usual.name) == &usual);
            QVERIFY(usualOf(usual.position) == &usual);
            QVERIFY(withinReach(usual.position) == usual.position);
            words.insert(usualText(usual));
        }
        QCOMPARE(words.size(), usualHeadPositions().size());
        QVERIFY(!headPositionNamed("upright"));
        QVERIFY(!usualOf({degrees(34.0), kSniffing.extension}));
    }

    void haveTheirFigures_data()
    {
        QTest::addColumn<double>("flexion_deg");
        QTest::addColumn<double>("extension_deg");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* name, double flexion_deg, double extension_deg,
                            const char* text) {
            QTest::newRow(name) << flexion_deg << extension_deg << QString::fromUtf8(text);
        };
        row("neutral", 0.0, 0.0, "Neutral: neck 0°, head 0°");
        row("sniffing", 35.0, 24.2, "Sniffing: neck 35° flexed, head 24° extended");
        row("extended", 0.0, 20.4, "Extended: neck 0°, head 20° extended");
        row("flexed", 35.0, 0.0, "Flexed: neck 35° flexed, head 0°");
        row("of no name", -12.4, -4.6, "neck 12° extended, head 5° flexed");
        row("hardly bent", 0.4, -0.4, "neck 0°, head 0°");
    }

    void haveTheirFigures()
    {
        QFETCH(const double, flexion_deg);
        QFETCH(const double, extension_deg);
        QFETCH(const QString, text);
        QCOMPARE(headPositionText({degrees(flexion_deg), degrees(extension_deg)}), text);
    }
};

CARINA_TEST(TestHeadPositions)

} // namespace carina::head_positions_test

#include "tst_head_positions.moc"
