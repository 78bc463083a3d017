#include "apps/lab/rendering/reference_picture.h"
#include "apps/lab/rendering/structural_similarity.h"
#include "tests/support/test_class.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace carina::structural_similarity_test
{

namespace
{

constexpr QSize kSize{40, 30};
constexpr double kC1 = 2.55 * 2.55;
constexpr double kC2 = 7.65 * 7.65;

QImage plain(int grey)
{
    QImage image{kSize, QImage::Format_RGB32};
    image.fill(qRgb(grey, grey, grey));
    return image;
}

/// Squares of one pixel, so much above and below a grey in turn.
QImage chequered(int grey, int contrast)
{
    QImage image = plain(grey);
    for (int y = 0; y < kSize.height(); ++y)
        for (int x = 0; x < kSize.width(); ++x) {
            const int value = grey + ((x + y) % 2 == 0 ? contrast : -contrast);
            image.setPixel(x, y, qRgb(value, value, value));
        }
    return image;
}

} // namespace

class TestStructuralSimilarity : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isOneOfEqualPictures();
    void ofPlainPicturesIsThatOfTheirLightness();
    void ofChequeredPicturesIsThatOfTheirContrast_data();
    void ofChequeredPicturesIsThatOfTheirContrast();
    void isTheSameEitherWay();
    void aMeanIsOfLightAndNotOfCodes();
    void samplesAreSpreadEvenlyOverAPixel();
};

void TestStructuralSimilarity::isOneOfEqualPictures()
{
    QVERIFY(std::abs(lab::structuralSimilarity(chequered(90, 40), chequered(90, 40)) - 1.0) < 1e-9);
}

/// Without contrast only the means are left of the index.
void TestStructuralSimilarity::ofPlainPicturesIsThatOfTheirLightness()
{
    const double expected = (2.0 * 50.0 * 100.0 + kC1) / (50.0 * 50.0 + 100.0 * 100.0 + kC1);
    QVERIFY(std::abs(lab::structuralSimilarity(plain(50), plain(100)) - expected) < 1e-9);
}

void TestStructuralSimilarity::ofChequeredPicturesIsThatOfTheirContrast_data()
{
    QTest::addColumn<int>("a");
    QTest::addColumn<int>("b");
    QTest::newRow("half the contrast") << 40 << 20;
    QTest::newRow("the negative") << 40 << -40;
    QTest::newRow("none") << 40 << 0;
}

/// Their means are equal, and their variances and covariance are a^2, b^2 and a b, but for some
/// 1e-5: what the weights leave of squares of one pixel.
void TestStructuralSimilarity::ofChequeredPicturesIsThatOfTheirContrast()
{
    QFETCH(int, a);
    QFETCH(int, b);
    const double expected = (2.0 * a * b + kC2) / (a * a + b * b + kC2);
    const double measured = lab::structuralSimilarity(chequered(128, a), chequered(128, b));
    QVERIFY2(std::abs(measured - expected) < 1e-3, qPrintable(QString::number(measured)));
}

void TestStructuralSimilarity::isTheSameEitherWay()
{
    const QImage a = chequered(100, 30);
    const QImage b = plain(140);
    QCOMPARE(lab::structuralSimilarity(a, b), lab::structuralSimilarity(b, a));
}

/// Half of the light of white is coded as 188 (IEC 61966-2-1), and a quarter as 137.
void TestStructuralSimilarity::aMeanIsOfLightAndNotOfCodes()
{
    lab::ReferencePicture half;
    half.add(plain(0));
    half.add(plain(255));
    QCOMPARE(half.mean().pixelColor(3, 3), QColor(188, 188, 188));
    half.add(plain(0));
    half.add(plain(0));
    QCOMPARE(half.mean().pixelColor(3, 3), QColor(137, 137, 137));
    lab::ReferencePicture same;
    for (int i = 0; i < 3; ++i)
        same.add(chequered(90, 40));
    QCOMPARE(same.mean(), chequered(90, 40));
}

void TestStructuralSimilarity::samplesAreSpreadEvenlyOverAPixel()
{
    const EyePicture eye{{}, {-0.5, 1.5, -0.25, 0.75}, {}};
    const QSize pixels{200, 100}; // of 0.01 each way
    std::vector<std::pair<double, double>> shifts;
    for (int sample = 0; sample < lab::kReferenceSamples; ++sample) {
        const Frustum seen = lab::sampledEye(eye, pixels, sample).frustum;
        QVERIFY(std::abs((seen.right - seen.left) - 2.0) < 1e-12);
        QVERIFY(std::abs((seen.top - seen.bottom) - 1.0) < 1e-12);
        shifts.emplace_back((seen.left + 0.5) / 0.01, (seen.bottom + 0.25) / 0.01);
    }
    for (const double x : {-0.375, -0.125, 0.125, 0.375})
        for (const double y : {-0.375, -0.125, 0.125, 0.375})
            QCOMPARE(std::ranges::count_if(shifts,
                                           [x, y](const auto& shift) {
                                               return std::abs(shift.first - x) < 1e-9
                                                      && std::abs(shift.second - y) < 1e-9;
                                           }),
                     std::ptrdiff_t{1});
}

CARINA_TEST(TestStructuralSimilarity)

} // namespace carina::structural_similarity_test

#include "tst_structural_similarity.moc"
