#include "apps/lab/commands.h"
#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonObject>
#include <QTemporaryDir>

#include <cmath>

namespace carina::laryngoscopy_pictures_test
{
namespace
{

constexpr QSize kSize{320, 240};

/// Of the adult.
QJsonObject drawn(const QString& folder, const QStringList& more = {})
{
    const auto object =
        lab::renderCommand().run(QStringList{QStringLiteral("--laryngoscopy"), folder,
                                             QStringLiteral("--size"), QStringLiteral("320x240")}
                                 + more);
    if (!object)
        qWarning("%s", object.error().detail.c_str());
    return object.value_or(QJsonObject{});
}

qint64 pixels(const QJsonValue& picture, const char* structure)
{
    return picture[QStringLiteral("visible_pixels")][QLatin1StringView{structure}].toInteger();
}

QString grade(const QJsonValue& picture)
{
    return picture[QStringLiteral("cormack_lehane")].toString();
}

} // namespace

class TestLaryngoscopyPictures : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void initTestCase();
    void init();
    void drawsTheStepsOfALaryngoscopy();
    void showsStructuresInTheirOrder();
    void seesTheGlottisOnlyWhenItIsLifted();
    void seesLessWithoutALift();
    void estimatesTheForcesOfALift();
    void pressesTheTeethByLevering();
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
    void drawsPicturesLikeTheReference();

private:
    QTemporaryDir m_folder;
    QJsonArray m_pictures;
};

void TestLaryngoscopyPictures::initTestCase()
{
    if (graphicsDriver())
        m_pictures =
            drawn(m_folder.filePath(QStringLiteral("usual")))[QStringLiteral("pictures")].toArray();
}

void TestLaryngoscopyPictures::init()
{
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
    QCOMPARE(m_pictures.size(), 5);
}

void TestLaryngoscopyPictures::drawsTheStepsOfALaryngoscopy()
{
    QStringList steps;
    QList<QImage> different;
    for (const QJsonValue picture : m_pictures) {
        steps += picture[QStringLiteral("step")].toString();
        const QImage image{m_folder.filePath(QStringLiteral("usual/")
                                             + picture[QStringLiteral("file")].toString())};
        QCOMPARE(image.size(), kSize);
        QVERIFY(!different.contains(image));
        different += image;
        qint64 all = 0;
        for (const QJsonValue count : picture[QStringLiteral("visible_pixels")].toObject())
            all += count.toInteger();
        QCOMPARE(all, qint64(kSize.width() * kSize.height()));
    }
    QCOMPARE(steps, (QStringList{QStringLiteral("teeth"), QStringLiteral("uvula"),
                                 QStringLiteral("epiglottis"), QStringLiteral("partial_view"),
                                 QStringLiteral("full_view")}));
}

void TestLaryngoscopyPictures::showsStructuresInTheirOrder()
{
    QVERIFY(pixels(m_pictures[0], "teeth") > 0);
    QVERIFY(pixels(m_pictures[1], "soft_palate") > 0);
    QVERIFY(pixels(m_pictures[2], "epiglottis") > 0);
    QCOMPARE(pixels(m_pictures[0], "vocal_folds"), qint64{0});
    QVERIFY(pixels(m_pictures[4], "arytenoids") > 0);
    QVERIFY(pixels(m_pictures[4], "vocal_folds") > 0);
}

void TestLaryngoscopyPictures::seesTheGlottisOnlyWhenItIsLifted()
{
    double last = 0.0;
    for (const QJsonValue picture : m_pictures) {
        const double pogo = picture[QStringLiteral("pogo_percent")].toDouble();
        QVERIFY(pogo >= last);
        last = pogo;
    }
    for (int i = 0; i < 3; ++i) // the blade has not lifted anything yet
        QVERIFY2(grade(m_pictures[i]) >= QStringLiteral("3"), qPrintable(grade(m_pictures[i])));
    QCOMPARE(grade(m_pictures[4]), QStringLiteral("1"));
}

void TestLaryngoscopyPictures::seesLessWithoutALift()
{
    const QJsonArray low =
        drawn(m_folder.filePath(QStringLiteral("low")),
              {QStringLiteral("--lift-mm"), QStringLiteral("0")})[QStringLiteral("pictures")]
            .toArray();
    QCOMPARE(low.size(), 5);
    QCOMPARE(low[4][QStringLiteral("pogo_percent")].toDouble(), 0.0);
    QVERIFY2(grade(low[4]) >= QStringLiteral("2b"), qPrintable(grade(low[4])));
}

// About 40 N (Hastings et al. 1996) where the glottis is seen, and none on the teeth.
void TestLaryngoscopyPictures::estimatesTheForcesOfALift()
{
    const QJsonValue lifted = m_pictures[4];
    QVERIFY(std::abs(lifted[QStringLiteral("tongue_force_N")].toDouble() - 40.0) < 6.0);
    QCOMPARE(lifted[QStringLiteral("incisor_force_N")].toDouble(), 0.0);
    QVERIFY(lifted[QStringLiteral("incisor_clearance_mm")].toDouble() > 4.9);
    QCOMPARE(lifted[QStringLiteral("levering_percent")].toDouble(), 0.0);
    QCOMPARE(lifted[QStringLiteral("handling")].toString(), QStringLiteral("lifting"));
}

void TestLaryngoscopyPictures::pressesTheTeethByLevering()
{
    const QJsonArray pictures =
        drawn(m_folder.filePath(QStringLiteral("levered")),
              {QStringLiteral("--levering-deg"), QStringLiteral("20")})[QStringLiteral("pictures")]
            .toArray();
    QCOMPARE(pictures.size(), 5);
    QCOMPARE(pictures[2][QStringLiteral("incisor_force_N")].toDouble(), 0.0);
    const QJsonValue levered = pictures[4];
    QVERIFY(levered[QStringLiteral("incisor_force_N")].toDouble() > 10.0);
    QVERIFY(std::abs(levered[QStringLiteral("incisor_clearance_mm")].toDouble()) < 0.01);
    QVERIFY(levered[QStringLiteral("levering_percent")].toDouble() > 95.0);
    QCOMPARE(levered[QStringLiteral("handling")].toString(), QStringLiteral("levering"));
}

void TestLaryngoscopyPictures::showsEventsThatAreAskedFor()
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
void TestLaryngoscopyPictures::extendsAStiffNeckNoFartherThanItGoes()
{
    const QJsonObject object =
        drawn(m_folder.filePath(QStringLiteral("stiff")),
              {QStringLiteral("--event"), QStringLiteral("stiff_neck=0.5"),
               QStringLiteral("--head-extension-deg"), QStringLiteral("25")});
    QVERIFY(std::abs(object[QStringLiteral("head_extension_deg")].toDouble() - 15.0) < 1e-6);
}

// How far apart they are is measured by TestAirwayChanges; here they are still seen, and otherwise.
void TestLaryngoscopyPictures::shutsTheCordsInASpasm()
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

void TestLaryngoscopyPictures::worsensTheViewByEvents_data()
{
    QTest::addColumn<QString>("event");
    for (const char* name : {"tongue_oedema", "pharyngeal_swelling", "epiglottitis",
                             "laryngeal_oedema", "floppy_epiglottis", "anterior_larynx"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

// None makes it better, and each is seen.
void TestLaryngoscopyPictures::worsensTheViewByEvents()
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

void TestLaryngoscopyPictures::showsWhatChangesMouthAndNeck_data()
{
    QTest::addColumn<QString>("event");
    for (const char* name : {"external_pressure", "neck_obesity", "prominent_incisors", "trismus"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestLaryngoscopyPictures::showsWhatChangesMouthAndNeck()
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

// BURP (Knill 1993).
void TestLaryngoscopyPictures::seesMoreOfAnAnteriorLarynxThatIsPressed()
{
    const auto pogo = [this](const char* name, const QStringList& more) {
        const QStringList anterior{QStringLiteral("--event"), QStringLiteral("anterior_larynx")};
        const QJsonArray pictures = drawn(m_folder.filePath(QString::fromLatin1(name)),
                                          anterior + more)[QStringLiteral("pictures")]
                                        .toArray();
        return pictures.size() == 5 ? pictures[4][QStringLiteral("pogo_percent")].toDouble() : -1.0;
    };
    const double anterior = pogo("anterior", {});
    const double pressed =
        pogo("pressed", {QStringLiteral("--event"), QStringLiteral("external_pressure")});
    qInfo("%.0f %%, pressed %.0f %%", anterior, pressed);
    QVERIFY(anterior >= 0.0 && pressed > anterior);
}

void TestLaryngoscopyPictures::hidesMoreOfTheGlottisAsAFluidRises()
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

void TestLaryngoscopyPictures::hidesTheGlottisByAForeignBody()
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

// At least 0.95 in the finest quality, and more the more is done for edges.
void TestLaryngoscopyPictures::drawsPicturesLikeTheReference()
{
    const QString folder = m_folder.filePath(QStringLiteral("compared"));
    const QJsonObject told = drawn(folder, {QStringLiteral("--compare")});
    const QJsonArray compared = told[QStringLiteral("pictures")].toArray();
    QCOMPARE(compared.size(), 5);
    const QJsonObject rates = told[QStringLiteral("frames_per_s")].toObject();
    QCOMPARE(rates.size(), qsizetype{3});
    for (const QJsonValue rate : rates)
        QVERIFY(rate.toDouble() > 0.0);
    for (const QJsonValue picture : compared) {
        const auto of = [&picture](const char* quality) {
            return picture[QStringLiteral("ssim")][QLatin1StringView{quality}].toDouble();
        };
        const QString words = QStringLiteral("%1: %2, %3, %4")
                                  .arg(picture[QStringLiteral("step")].toString())
                                  .arg(of("quick"))
                                  .arg(of("smoothed"))
                                  .arg(of("fine"));
        qInfo("%s", qPrintable(words));
        QVERIFY2(of("fine") >= 0.95 && of("fine") < 1.0, qPrintable(words));
        QVERIFY2(of("fine") > of("quick"), qPrintable(words));
        QVERIFY2(of("quick") > 0.5, qPrintable(words));
        const QImage reference{folder + QLatin1Char{'/'}
                               + picture[QStringLiteral("reference_file")].toString()};
        QCOMPARE(reference.size(), kSize);
    }
}

CARINA_SCREEN_TEST(TestLaryngoscopyPictures)

} // namespace carina::laryngoscopy_pictures_test

#include "tst_laryngoscopy_pictures.moc"
