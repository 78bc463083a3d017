#include "ui/panels/airway/try_panel.h"

#include "tests/models/scoring/tried_session.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QTextDocumentFragment>

#include <array>

namespace carina::try_panel_test
{
namespace
{

using test::soon;

constexpr std::array kParts{"tryFigures",  "tryAdvice",     "tryPoints",
                            "tryHandling", "tryLiterature", "tryMissing"};

struct Desk : test::TriedSession {
    TryPanel panel;

    Desk()
    {
        panel.setModel(tries);
        panel.resize(430, 700);
        panel.show();
        QApplication::setActiveWindow(&panel); // the display has no window manager
    }
    [[nodiscard]] QLabel& label(const char* name) const
    {
        return *panel.findChild<QLabel*>(QLatin1String{name});
    }
    [[nodiscard]] QPushButton& finish() const
    {
        return *panel.findChild<QPushButton*>(QStringLiteral("finishTry"));
    }
};

} // namespace

class TestTryPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void saysWhenATryBegins();
    void saysThatATryIsUnderWay();
    void endsATryByKeyboard();
    void tellsHowATryWent();
    void forgetsItWhenTheNextOneBegins();
    void namesEachPartForAScreenReader();
    void leadsToTheMomentOfLostPointsByKeyboard();
};

void TestTryPanel::saysWhenATryBegins()
{
    const Desk desk;
    QVERIFY(desk.label("tryState").text().startsWith(QStringLiteral("○ No try yet")));
    QVERIFY(!desk.finish().isEnabled());
    for (const char* part : kParts)
        QVERIFY(!desk.label(part).isVisible());
}

void TestTryPanel::saysThatATryIsUnderWay()
{
    Desk desk;
    desk.intubate();
    QVERIFY(desk.finish().isEnabled());
    QVERIFY(desk.label("tryState").text().startsWith(QStringLiteral("● A try is under way")));
    desk.run(std::chrono::seconds{61});
    QVERIFY(soon([&] { return desk.label("tryState").text().contains(QStringLiteral("1 min")); }));
}

void TestTryPanel::endsATryByKeyboard()
{
    Desk desk;
    desk.intubate();
    desk.finish().setFocus();
    QTest::keyClick(&desk.finish(), Qt::Key_Space);
    desk.run(std::chrono::milliseconds{300});
    QVERIFY(desk.tries.report());
    QVERIFY(!desk.finish().isEnabled());
    QCOMPARE(desk.label("tryState").text(), QStringLiteral("✓ The last try has ended"));
}

void TestTryPanel::tellsHowATryWent()
{
    Desk desk;
    BladeEffort effort;
    effort.teeth = newtons(25.0);
    desk.tries.setEffort([effort] { return std::optional{effort}; });
    desk.intubate();
    desk.endTry();
    const QString figures = desk.label("tryFigures").text();
    for (const char* told : {"Time to the first breath: never", "Depth at the teeth: 20.0",
                             "Lowest oxygen saturation: ", "View: 60", "Attempts: 1"})
        QVERIFY2(figures.contains(QString::fromUtf8(told)), qPrintable(figures));
    QCOMPARE(desk.label("tryOutcome").text(), QStringLiteral("✓ In the trachea"));
    QVERIFY(desk.label("tryOutcome").isVisible());
    const QString advice = desk.label("tryAdvice").text();
    QCOMPARE(advice.count(QLatin1Char('\n')), qsizetype(kAdviceGiven) - 1);
    QVERIFY(advice.startsWith(QStringLiteral("1. ")));
    QVERIFY(desk.label("tryPoints").text().contains(QStringLiteral("BMC Med Educ 2014;14:144")));
    QVERIFY(desk.label("tryHandling")
                .text()
                .startsWith(QStringLiteral("Incisors, highest force: ▲ 25\u00a0N")));
    QVERIFY(desk.label("tryLiterature").text().contains(QStringLiteral("experts")));
    QVERIFY(desk.label("tryMissing").text().startsWith(QStringLiteral("Not measured: ")));
    for (const char* part : kParts)
        QVERIFY(desk.label(part).isVisible());
}

void TestTryPanel::forgetsItWhenTheNextOneBegins()
{
    Desk desk;
    desk.intubate();
    desk.endTry();
    desk.note(IntubationStep::TubeOut);
    desk.note(IntubationStep::BladeIn);
    QVERIFY(!desk.label("tryOutcome").isVisible());
    for (const char* part : kParts)
        QVERIFY(!desk.label(part).isVisible());
}

void TestTryPanel::namesEachPartForAScreenReader()
{
    const Desk desk;
    for (const char* part : kParts)
        QVERIFY(!desk.label(part).accessibleName().isEmpty());
    QVERIFY(!desk.finish().text().isEmpty());
}

/// A blade that is in the mouth for 4 s when 2.5 s are allowed, judged by a rubric whose words are
/// taken as they are.
void TestTryPanel::leadsToTheMomentOfLostPointsByKeyboard()
{
    Desk desk;
    desk.tries.setRubric({.name = "<b>Ours</b>",
                          .source = "",
                          .criteria = {{.name = "In the <i>trachea</i>"},
                                       {.name = "Quick & calm",
                                        .metric = Metric::TimeToCords,
                                        .bound = Bound::AtMost,
                                        .limit = 2.5}}});
    desk.intubate();
    desk.endTry();
    const auto& lost = desk.tries.report()->score.judgements.at(1);
    QVERIFY(lost.moment);
    QLabel& points = desk.label("tryPoints");
    const QString told = points.text().replace(QChar::Nbsp, QChar::Space); // as toPlainText() does
    desk.panel.linkMoments();
    QCOMPARE(points.text().count(QStringLiteral("<a ")), 1);
    QCOMPARE(QTextDocumentFragment::fromHtml(points.text()).toPlainText(), told);
    std::vector<SessionTime> asked;
    connect(&desk.panel, &TryPanel::momentAsked, this,
            [&](SessionTime moment) { asked.push_back(moment); });
    points.setFocus(Qt::TabFocusReason);
    QTest::keyClick(&points, Qt::Key_Tab); // to the first link
    QTest::keyClick(&points, Qt::Key_Return);
    QVERIFY(asked == std::vector<SessionTime>{*lost.moment});
}

CARINA_SCREEN_TEST(TestTryPanel)

} // namespace carina::try_panel_test

#include "tst_try_panel.moc"
