#include "tests/support/test_class.h"
#include "tests/ui/access/control_walk.h"
#include "tests/ui/registration/registration_desk.h"
#include "widgets/scene/view/graphics.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>

#include <map>
#include <set>

namespace carina::registration_access_test
{

/// The wizard for those who do not see it, or have no hand for the mouse.
class TestRegistrationAccess : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void initTestCase();
    void namesEveryControl_data();
    void namesEveryControl();
    void hasNoLetterTwice_data();
    void hasNoLetterTwice();
    void reachesEveryControlByTab_data();
    void reachesEveryControlByTab();
    void hasNoFaultOfAControl_data();
    void hasNoFaultOfAControl();
    void tellsAloudWhatWasAchieved();
    void tellsWhatWasWrittenWhere();

private:
    std::unique_ptr<RegistrationDesk> m_desk;
};

namespace
{

void eachPage()
{
    QTest::addColumn<int>("step");
    for (int step = 0; step <= int(SiteStep::Tools); ++step)
        QTest::newRow(qPrintable(stepTitle(static_cast<SiteStep>(step)))) << step;
}

template <class Widget> std::vector<Widget*> seen(const QWidget& window)
{
    std::vector<Widget*> widgets;
    for (Widget* widget : window.findChildren<Widget*>())
        if (widget->isVisible())
            widgets.push_back(widget);
    return widgets;
}

/// The letter behind the first &, or none.
QChar letterOf(const QString& text)
{
    const auto place = text.indexOf(QLatin1Char('&'));
    return place < 0 ? QChar{} : text[place + 1].toLower();
}

} // namespace

/// Fitted and partly verified: every page shows all it has.
void TestRegistrationAccess::initTestCase()
{
    m_desk = std::make_unique<RegistrationDesk>(true);
    m_desk->site.fitAll(*m_desk->model);
    m_desk->site.verifyAll(*m_desk->model);
}

void TestRegistrationAccess::namesEveryControl_data() { eachPage(); }
void TestRegistrationAccess::namesEveryControl()
{
    QFETCH(int, step);
    m_desk->model->enter(static_cast<SiteStep>(step));
    for (const QAbstractButton* button : seen<QAbstractButton>(*m_desk->window))
        if (button->focusPolicy() != Qt::NoFocus)
            QVERIFY2(!button->text().isEmpty(), qPrintable(button->objectName()));
    for (const QTableView* table : seen<QTableView>(*m_desk->window))
        QVERIFY2(!table->accessibleName().isEmpty(), qPrintable(table->objectName()));
    for (const QComboBox* box : seen<QComboBox>(*m_desk->window))
        QVERIFY2(!box->accessibleName().isEmpty(), qPrintable(box->objectName()));
    for (const char* name : {"scene", "progress", "steps", "instruction", "message", "tools"})
        QVERIFY2(!m_desk->find<QWidget>(name).accessibleName().isEmpty(), name);
}

void TestRegistrationAccess::hasNoLetterTwice_data() { eachPage(); }
void TestRegistrationAccess::hasNoLetterTwice()
{
    QFETCH(int, step);
    m_desk->model->enter(static_cast<SiteStep>(step));
    std::map<QChar, QString> letters;
    const auto add = [&](const QString& text) {
        const QChar letter = letterOf(text);
        if (letter.isNull())
            return true;
        return letters.emplace(letter, text).second;
    };
    for (const QAbstractButton* button : seen<QAbstractButton>(*m_desk->window))
        QVERIFY2(add(button->text()), qPrintable(button->text()));
    for (const QLabel* label : seen<QLabel>(*m_desk->window))
        if (label->buddy())
            QVERIFY2(add(label->text()), qPrintable(label->text()));
    for (int number = 1; number <= 8; ++number)
        QVERIFY(letters.contains(QLatin1Char(char('0' + number))));
}

void TestRegistrationAccess::reachesEveryControlByTab_data() { eachPage(); }
void TestRegistrationAccess::reachesEveryControlByTab()
{
    QFETCH(int, step);
    m_desk->model->enter(static_cast<SiteStep>(step));
    m_desk->button("undo").setFocus();
    std::set<const QWidget*> reached;
    for (int i = 0; i < 60; ++i) {
        reached.insert(QApplication::focusWidget());
        m_desk->press(Qt::Key_Tab);
    }
    const auto isReached = [&](const QWidget* widget) {
        return !widget->isEnabled() || !(widget->focusPolicy() & Qt::TabFocus)
               || reached.contains(widget);
    };
    for (const QAbstractButton* button : seen<QAbstractButton>(*m_desk->window))
        QVERIFY2(isReached(button), qPrintable(button->text()));
    for (const QTableView* table : seen<QTableView>(*m_desk->window))
        QVERIFY2(isReached(table), qPrintable(table->objectName()));
    for (const QLineEdit* line : seen<QLineEdit>(*m_desk->window))
        QVERIFY2(isReached(line->focusProxy() ? line->focusProxy() : line),
                 qPrintable(line->objectName()));
}

/// As in the other windows: lists, boxes and fields as well.
void TestRegistrationAccess::hasNoFaultOfAControl_data() { eachPage(); }
void TestRegistrationAccess::hasNoFaultOfAControl()
{
    QFETCH(int, step);
    m_desk->model->enter(static_cast<SiteStep>(step));
    m_desk->button("undo").setFocus();
    test::verifyControls(*m_desk->window);
}

void TestRegistrationAccess::tellsAloudWhatWasAchieved()
{
    RegistrationDesk desk;
    desk.site.prepare(*desk.model);
    QCOMPARE(desk.find<QLabel>("instruction").accessibleDescription(),
             QStringLiteral("The tip is found"));
    desk.site.touchFirst(*desk.model, 1);
    QCOMPARE(desk.find<QLabel>("instruction").accessibleDescription(),
             QStringLiteral("Sternal notch"));
}

void TestRegistrationAccess::tellsWhatWasWrittenWhere()
{
    RegistrationDesk desk;
    const auto& message = desk.find<QLabel>("message");
    const auto file = desk.site.beside("copy.json");
    desk.model->exportSite(QString::fromStdString(file.string()));
    const QString said =
        QStringLiteral("✓ The site was written to %1.").arg(QString::fromStdString(file.string()));
    QCOMPARE(message.text(), said);
    QCOMPARE(message.accessibleDescription(), said);
    desk.model->landmarkTask().exportTo(desk.site.beside("places.csv"));
    QVERIFY(message.text().contains(QStringLiteral("landmarks were written to")));
    QVERIFY(message.text().contains(QStringLiteral("places.csv")));
    desk.model->landmarkTask().exportTo("/proc/none/places.csv");
    QVERIFY(message.text().startsWith(QStringLiteral("▲")));
    desk.model->enter(SiteStep::Landmarks);
    QVERIFY(message.text().isEmpty());
}

CARINA_SCREEN_TEST(TestRegistrationAccess)

} // namespace carina::registration_access_test

#include "tst_registration_access.moc"
