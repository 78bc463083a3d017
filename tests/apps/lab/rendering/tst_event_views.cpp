#include "tests/apps/lab/rendering/drawn_laryngoscopy.h"
#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"

#include <QTemporaryDir>

#include <cmath>

namespace carina::event_views_test
{

using namespace drawn_laryngoscopy;

/// What events change of the laryngoscopic view, each a laryngoscopy of its own.
class TestEventViews : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void initTestCase();
    void init();
    void showsEventsThatAreAskedFor();
    void extendsAStiffNeckNoFartherThanItGoes();
    void shutsTheCordsInASpasm();
    void worsensTheViewByEvents_data();
    void worsensTheViewByEvents();
    void showsWhatChangesMouthAndNeck_data();
    void showsWhatChangesMouthAndNeck();
    void seesMoreOfAnAnteriorLarynxThatIsPressed();
    void hidesMoreOfTheGlottisAsAFluidRises();
    void hidesTheGlottisByAForeignBody();

private:
    QTemporaryDir m_folder;
    QJsonArray m_pictures; ///< without an event
};

void TestEventViews::initTestCase()
{
    if (graphicsDriver())
        m_pictures =
            drawn(m_folder.filePath(QStringLiteral("usual")))[QStringLiteral("pictures")].toArray();
}

void TestEventViews::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
    QCOMPARE(m_pictures.size(), 5);
}

void TestEventViews::showsEventsThatAreAskedFor()
{
    const QJsonObject object = drawn(
        m_folder.filePath(QStringLiteral("both")),
        {QStringLiteral("--event"), QStringLiteral("laryngospasm=0.25"), QStringLiteral("--event"),
         QStringLiteral("epiglottitis"), QStringLiteral("--severity"), QStringLiteral("0.5")});
    const QJsonArray events = object[QStringLiteral("events")].toArray();
    QCOMPARE(events.size(), 2);
    QCOMPARE(events[0][QStringLiteral("event")].toString(), QStringLiteral("epiglottitis"));
    QCOMPARE(events[0][QStringLiteral("severity")].toDouble(), 0.5);
    QCOMPARE(events[1][QStringLiteral("event")].toString(), QStringLiteral("laryngospasm"));
    QCOMPARE(events[1][QStringLiteral("severity")].toDouble(), 0.25);
}

// Half of 30 degrees.
void TestEventViews::extendsAStiffNeckNoFartherThanItGoes()
{
    const QJsonObject object =
        drawn(m_folder.filePath(QStringLiteral("stiff")),
              {QStringLiteral("--event"), QStringLiteral("stiff_neck=0.5"),
               QStringLiteral("--head-extension-deg"), QStringLiteral("25")});
    QVERIFY(std::abs(object[QStringLiteral("head_extension_deg")].toDouble() - 15.0) < 1e-6);
}

// How far apart they are is measured by TestAirwayChanges; here they are still seen, and otherwise.
void TestEventViews::shutsTheCordsInASpasm()
{
    const QJsonArray shut = drawn(m_folder.filePath(QStringLiteral("shut")),
                                  {QStringLiteral("--event"),
                                   QStringLiteral("laryngospasm")})[QStringLiteral("pictures")]
                                .toArray();
    QCOMPARE(shut.size(), 5);
    QVERIFY(pixels(shut[4], "vocal_folds") > 0);
    QVERIFY(shut[4][QStringLiteral("visible_pixels")]
            != m_pictures[4][QStringLiteral("visible_pixels")]);
}

void TestEventViews::worsensTheViewByEvents_data()
{
    QTest::addColumn<QString>("event");
    for (const char* name : {"tongue_oedema", "pharyngeal_swelling", "epiglottitis",
                             "laryngeal_oedema", "floppy_epiglottis", "anterior_larynx"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

// None makes it better, and each is seen.
void TestEventViews::worsensTheViewByEvents()
{
    QFETCH(QString, event);
    const QJsonArray pictures = drawn(m_folder.filePath(event), {QStringLiteral("--event"),
                                                                 event})[QStringLiteral("pictures")]
                                    .toArray();
    QCOMPARE(pictures.size(), 5);
    const auto pogo = [](const QJsonValue& picture) {
        return picture[QStringLiteral("pogo_percent")].toDouble();
    };
    qInfo("%s: %.0f %%, grade %s", qPrintable(event), pogo(pictures[4]),
          qPrintable(grade(pictures[4])));
    QVERIFY(pogo(pictures[4]) <= pogo(m_pictures[4]));
    QVERIFY(pictures[4][QStringLiteral("visible_pixels")]
            != m_pictures[4][QStringLiteral("visible_pixels")]);
}

void TestEventViews::showsWhatChangesMouthAndNeck_data()
{
    QTest::addColumn<QString>("event");
    for (const char* name : {"external_pressure", "neck_obesity", "prominent_incisors", "trismus"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestEventViews::showsWhatChangesMouthAndNeck()
{
    QFETCH(QString, event);
    const QJsonArray pictures = drawn(m_folder.filePath(event), {QStringLiteral("--event"),
                                                                 event})[QStringLiteral("pictures")]
                                    .toArray();
    QCOMPARE(pictures.size(), 5);
    qInfo("%s: %.0f %%, grade %s", qPrintable(event),
          pictures[4][QStringLiteral("pogo_percent")].toDouble(), qPrintable(grade(pictures[4])));
    QVERIFY(pictures[4][QStringLiteral("visible_pixels")]
            != m_pictures[4][QStringLiteral("visible_pixels")]);
}

// BURP (Knill 1993): a better grade, and more of the glottis to be seen.
void TestEventViews::seesMoreOfAnAnteriorLarynxThatIsPressed()
{
    constexpr double kMore_percent = 10.0; // of ours
    const auto lifted = [this](const char* name, const QStringList& more) {
        const QStringList anterior{QStringLiteral("--event"), QStringLiteral("anterior_larynx")};
        const QJsonArray pictures = drawn(m_folder.filePath(QString::fromLatin1(name)),
                                          anterior + more)[QStringLiteral("pictures")]
                                        .toArray();
        return pictures.size() == 5 ? QJsonValue{pictures[4]} : QJsonValue{};
    };
    const auto pogo = [](const QJsonValue& picture) {
        return picture[QStringLiteral("pogo_percent")].toDouble();
    };
    const QJsonValue anterior = lifted("anterior", {});
    const QJsonValue pressed =
        lifted("pressed", {QStringLiteral("--event"), QStringLiteral("external_pressure")});
    qInfo("%.0f %%, pressed %.0f %%", pogo(anterior), pogo(pressed));
    QCOMPARE(grade(anterior), QStringLiteral("2a"));
    QCOMPARE(grade(pressed), QStringLiteral("1"));
    QVERIFY(pogo(pressed) > pogo(anterior) + kMore_percent);
}

void TestEventViews::hidesMoreOfTheGlottisAsAFluidRises()
{
    QCOMPARE(pixels(m_pictures[4], "fluid"), qint64{0});
    double opening = m_pictures[4][QStringLiteral("pogo_percent")].toDouble();
    const double without = opening;
    qint64 fluid = 0;
    for (const char* event : {"blood=0.3", "blood=0.6", "blood"}) {
        const QString name = QString::fromLatin1(event);
        const QJsonObject object =
            drawn(m_folder.filePath(name), {QStringLiteral("--event"), name});
        const QJsonArray pictures = object[QStringLiteral("pictures")].toArray();
        QCOMPARE(pictures.size(), 5);
        const double now = pictures[4][QStringLiteral("pogo_percent")].toDouble();
        qInfo("%s: %.0f %%, %lld pixels", event, now,
              static_cast<long long>(pixels(pictures[4], "fluid")));
        QVERIFY(pixels(pictures[4], "fluid") > fluid);
        QVERIFY(now <= opening);
        fluid = pixels(pictures[4], "fluid");
        opening = now;
    }
    QVERIFY(opening < without);
}

void TestEventViews::hidesTheGlottisByAForeignBody()
{
    const QJsonArray pictures = drawn(m_folder.filePath(QStringLiteral("solid")),
                                      {QStringLiteral("--event"),
                                       QStringLiteral("foreign_body")})[QStringLiteral("pictures")]
                                    .toArray();
    QCOMPARE(pictures.size(), 5);
    QCOMPARE(pixels(m_pictures[4], "foreign_body"), qint64{0});
    QVERIFY(pixels(pictures[4], "foreign_body") > 0);
    QVERIFY(pictures[4][QStringLiteral("pogo_percent")].toDouble()
            < m_pictures[4][QStringLiteral("pogo_percent")].toDouble());
}

CARINA_SCREEN_TEST(TestEventViews)

} // namespace carina::event_views_test

#include "tst_event_views.moc"
