#include "engine/anatomy/laryngoscopy/glottic_view.h"
#include "tests/support/test_class.h"

#include <cmath>

namespace carina::glottic_view_test
{
namespace
{

using Structure = SeenStructure;

constexpr int kWidth = 200;
constexpr int kHeight = 100;
constexpr double kTolerance = 1.0 / kLineSamples; ///< of a share
/// The camera looks along -z of A from 0.1 m; the glottis fills the middle half of the height, with
/// the commissure above, as it is seen past a blade.
const PictureCamera kCamera{RigidTransform::translation({0.0, 0.0, 0.1}), 0.4, 0.2};
const GlotticLine kGlottis{{0.0, 0.01, 0.0}, {0.0, -0.01, 0.0}};
constexpr int kTop = 25;    ///< row of the commissure
constexpr int kBottom = 75; ///< row of the notch

/// A picture of one structure.
StructurePicture pictureOf(Structure structure)
{
    return {kWidth, kHeight, std::vector<Structure>(std::size_t(kWidth * kHeight), structure)};
}

/// Fills whole rows.
void fillRows(StructurePicture& picture, int from, int to, Structure structure)
{
    std::fill(picture.pixels.begin() + from * kWidth, picture.pixels.begin() + to * kWidth,
              structure);
}

/// An epiglottis that covers a share of the glottis from the commissure on, over the trachea.
StructurePicture coveredBy(double share)
{
    StructurePicture picture = pictureOf(Structure::Trachea);
    fillRows(picture, 0, kTop + int(std::lround(share * (kBottom - kTop))), Structure::Epiglottis);
    return picture;
}

} // namespace

class TestGlotticView : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void seesAsMuchAsIsNotCovered_data();
    void seesAsMuchAsIsNotCovered();
    void hidesByWhatLiesAboveTheGlottis_data();
    void hidesByWhatLiesAboveTheGlottis();
    void seesNothingOutsideThePicture();
    void seesNothingBehindTheCamera();
    void gradesTheView_data();
    void gradesTheView();
    void countsPixelsOfEachStructure();
    void needsMoreThanASpeck();
    void countsNothingThatATubeCovers_data();
    void countsNothingThatATubeCovers();
    void tellsNothingOfAnEmptyPicture();
    void gradesBesideATube();
};

void TestGlotticView::seesAsMuchAsIsNotCovered_data()
{
    QTest::addColumn<double>("covered");
    for (const double covered : {0.0, 0.1, 0.25, 0.5, 0.8, 1.0})
        QTest::addRow("%.0f %%", 100.0 * covered) << covered;
}

void TestGlotticView::seesAsMuchAsIsNotCovered()
{
    QFETCH(const double, covered);
    QVERIFY(std::abs(seenShare(coveredBy(covered), kCamera, kGlottis) - (1.0 - covered))
            <= kTolerance);
}

void TestGlotticView::hidesByWhatLiesAboveTheGlottis_data()
{
    QTest::addColumn<SeenStructure>("structure");
    QTest::addColumn<double>("seen");
    for (std::size_t n = 0; n < kSeenStructures; ++n) {
        const auto structure = static_cast<Structure>(n);
        const bool isOfGlottis =
            structure == Structure::Nothing || structure == Structure::VocalFold
            || structure == Structure::Arytenoid || structure == Structure::LaryngealCartilage
            || structure == Structure::Trachea;
        QTest::newRow(structureName(structure)) << structure << (isOfGlottis ? 1.0 : 0.0);
    }
}

void TestGlotticView::hidesByWhatLiesAboveTheGlottis()
{
    QFETCH(const SeenStructure, structure);
    QFETCH(const double, seen);
    QCOMPARE(seenShare(pictureOf(structure), kCamera, kGlottis), seen);
}

void TestGlotticView::seesNothingOutsideThePicture()
{
    // The upper half of this line is above the picture's edge, which is at 0.02 m.
    const GlotticLine high{{0.0, 0.03, 0.0}, {0.0, 0.01, 0.0}};
    QVERIFY(std::abs(seenShare(pictureOf(Structure::Trachea), kCamera, high) - 0.5) <= kTolerance);
}

void TestGlotticView::seesNothingBehindTheCamera()
{
    const GlotticLine behind{{0.0, 0.01, 0.2}, {0.0, -0.01, 0.2}};
    QCOMPARE(seenShare(pictureOf(Structure::Trachea), kCamera, behind), 0.0);
}

void TestGlotticView::gradesTheView_data()
{
    QTest::addColumn<double>("covered");
    QTest::addColumn<SeenStructure>("below"); // what fills the rows below the glottis
    QTest::addColumn<SeenStructure>("cover");
    QTest::addColumn<QString>("grade");
    const auto row = [](const char* name, double covered, Structure below, Structure cover,
                        const char* grade) {
        QTest::newRow(name) << covered << below << cover << QString::fromLatin1(grade);
    };
    row("all of the glottis", 0.0, Structure::Arytenoid, Structure::Epiglottis, "1");
    row("most of it", 0.4, Structure::Arytenoid, Structure::Epiglottis, "1");
    row("a part of it", 0.7, Structure::Arytenoid, Structure::Epiglottis, "2a");
    row("its end behind", 0.95, Structure::Arytenoid, Structure::Epiglottis, "2b");
    row("arytenoids only", 1.0, Structure::Arytenoid, Structure::Epiglottis, "2b");
    row("the epiglottis only", 1.0, Structure::Pharynx, Structure::Epiglottis, "3");
    row("the tongue only", 1.0, Structure::Pharynx, Structure::Tongue, "4");
}

void TestGlotticView::gradesTheView()
{
    QFETCH(const double, covered);
    QFETCH(const SeenStructure, below);
    QFETCH(const SeenStructure, cover);
    QFETCH(const QString, grade);
    StructurePicture picture = coveredBy(covered);
    std::ranges::replace(picture.pixels, Structure::Epiglottis, cover);
    fillRows(picture, kBottom, kHeight, below);
    QCOMPARE(QString::fromLatin1(gradeName(glotticView(picture, kCamera, kGlottis).grade)), grade);
}

void TestGlotticView::countsPixelsOfEachStructure()
{
    const GlotticView view = glotticView(coveredBy(0.5), kCamera, kGlottis);
    QCOMPARE(view.visiblePixels[std::size_t(Structure::Epiglottis)], std::size_t(50 * kWidth));
    QCOMPARE(view.visiblePixels[std::size_t(Structure::Trachea)], std::size_t(50 * kWidth));
    QCOMPARE(view.visiblePixels[std::size_t(Structure::Tongue)], std::size_t(0));
}

// 10 of 20,000 pixels are 0.05 %.
void TestGlotticView::needsMoreThanASpeck()
{
    StructurePicture picture = pictureOf(Structure::Tongue);
    std::fill_n(picture.pixels.begin(), 9, Structure::Epiglottis);
    QVERIFY(glotticView(picture, kCamera, kGlottis).grade == CormackLehane::Grade4);
    picture.pixels[9] = Structure::Epiglottis;
    QVERIFY(glotticView(picture, kCamera, kGlottis).grade == CormackLehane::Grade3);
}

void TestGlotticView::countsNothingThatATubeCovers_data()
{
    QTest::addColumn<double>("epiglottis"); // covers so much from the commissure on
    QTest::addColumn<double>("tube");       // covers so much from the notch on
    QTest::addColumn<double>("opening");
    QTest::addColumn<bool>("tells");
    QTest::newRow("no tube") << 0.5 << 0.0 << 0.5 << true;
    QTest::newRow("a tube over what is seen") << 0.5 << 0.3 << 0.2 / 0.7 << true;
    QTest::newRow("a tube over a whole glottis") << 0.0 << 0.4 << 1.0 << true;
    QTest::newRow("more tube than glottis") << 0.0 << 0.6 << 1.0 << false;
    QTest::newRow("tube and epiglottis") << 0.2 << 0.8 << 0.0 << false;
    QTest::newRow("nothing but tube") << 0.0 << 1.0 << 0.0 << false;
}

void TestGlotticView::countsNothingThatATubeCovers()
{
    QFETCH(const double, epiglottis);
    QFETCH(const double, tube);
    QFETCH(const double, opening);
    QFETCH(const bool, tells);
    constexpr double kOfFewer = 5.0 * kTolerance; // as few as a fifth of the points are counted
    StructurePicture picture = coveredBy(epiglottis);
    const int from = kBottom - int(std::lround(tube * (kBottom - kTop)));
    if (from < kBottom)
        fillRows(picture, from, kHeight, Structure::Tube);
    const GlotticView view = glotticView(picture, kCamera, kGlottis);
    QVERIFY(std::abs(view.opening - opening) <= kOfFewer);
    QVERIFY(std::abs(view.underTube - tube) <= kTolerance);
    QCOMPARE(view.isTelling(), tells);
}

/// The epiglottis covers all of the glottis that no tube does: grade 3, as without the tube.
void TestGlotticView::gradesBesideATube()
{
    StructurePicture picture = coveredBy(1.0);
    std::ranges::replace(picture.pixels, Structure::Trachea, Structure::Pharynx);
    fillRows(picture, 60, kHeight, Structure::Tube);
    const GlotticView view = glotticView(picture, kCamera, kGlottis);
    QVERIFY(view.isTelling());
    QVERIFY(view.grade == CormackLehane::Grade3);
    QCOMPARE(view.opening, 0.0);
}

// As of a camera that is inside a tube, whose wall is not seen from within.
void TestGlotticView::tellsNothingOfAnEmptyPicture()
{
    StructurePicture picture = pictureOf(Structure::Nothing);
    QVERIFY(!glotticView(picture, kCamera, kGlottis).isTelling());
    fillRows(picture, 0, kHeight / 2, Structure::Pharynx);
    const GlotticView half = glotticView(picture, kCamera, kGlottis);
    QCOMPARE(half.empty, 0.5);
    QVERIFY(half.isTelling());
}

CARINA_TEST(TestGlotticView)

} // namespace carina::glottic_view_test

#include "tst_glottic_view.moc"
