#include "tests/apps/lab/rendering/drawn_laryngoscopy.h"
#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"

#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

namespace carina::laryngoscopy_pictures_test
{

using namespace drawn_laryngoscopy;

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
    void drawsAFluidWithoutAStraightEnd();
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
    QVERIFY2(grade(low[4]) == QStringLiteral("3") || grade(low[4]) == QStringLiteral("4"),
             qPrintable(grade(low[4])));
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

// Where blood, which is dark, ends above paler tissue, it ends so in one row of pixels only in a
// small share of the picture's width.
void TestLaryngoscopyPictures::drawsAFluidWithoutAStraightEnd()
{
    constexpr double kStraight = 0.1; // of the width
    const auto isBlood = [](QRgb c) { return qRed(c) > 70 && qGreen(c) < 30 && qBlue(c) < 30; };
    const auto isPaler = [](QRgb c) { return qGreen(c) > 45 && qBlue(c) > 45; };
    const QString folder = m_folder.filePath(QStringLiteral("blood"));
    const QJsonArray pictures = drawn(folder, {QStringLiteral("--event"),
                                               QStringLiteral("blood")})[QStringLiteral("pictures")]
                                    .toArray();
    QCOMPARE(pictures.size(), 5);
    for (const QJsonValue picture : pictures) {
        const QImage image{folder + QLatin1Char{'/'} + picture[QStringLiteral("file")].toString()};
        QCOMPARE(image.size(), kSize);
        int most = 0;
        int blood = 0;
        for (int y = 0; y + 2 < image.height(); ++y) {
            int ends = 0;
            for (int x = 0; x < image.width(); ++x) {
                const bool here = isBlood(image.pixel(x, y));
                blood += here ? 1 : 0;
                ends += here && isPaler(image.pixel(x, y + 2)) ? 1 : 0;
            }
            most = std::max(most, ends);
        }
        qInfo("%d of %d pixels end in one row", most, blood);
        QVERIFY(most < kStraight * image.width());
        QVERIFY(blood > 0 || pixels(picture, "fluid") == 0);
    }
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
