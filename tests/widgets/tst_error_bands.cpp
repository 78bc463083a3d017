#include "widgets/error_bands.h"

#include "tests/support/test_class.h"
#include "tests/widgets/colour_vision.h"

namespace carina::error_bands_test
{
namespace
{

constexpr double kClearStep = 8.0; ///< of lightness or in CIELAB; 2.3 is just noticed
constexpr double kAlike = 0.2;     ///< by how much a step of lightness may miss their mean

double lightness(const QColor& color) { return test::inLab(color, test::kSights[0])[0]; }

} // namespace

class TestErrorBands : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdARange_data();
    void holdARange();
    void holdAnyRange();
    void growDarkerInEveryChannel();
    void areAsFarApartInLightness();
    void areToldApartByColourBlindPeople();
    void drawLinesThatStandOut();
};

void TestErrorBands::holdARange_data()
{
    QTest::addColumn<double>("least_mm");
    QTest::addColumn<double>("most_mm");
    QTest::addColumn<double>("width_mm");
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("count");
    QTest::newRow("four landmarks") << 0.93 << 2.75 << 0.2 << 4 << 10;
    QTest::newRow("eight landmarks") << 0.38 << 1.15 << 0.1 << 3 << 9;
    QTest::newRow("one error everywhere") << 1.23 << 1.23 << 0.1 << 12 << 1;
    QTest::newRow("none at all") << 0.0 << 0.0 << 0.1 << 0 << 1;
    QTest::newRow("from nothing on") << 0.0 << 9.9 << 1.0 << 0 << 10;
    QTest::newRow("a landmark touched at the wrong place") << 12.0 << 74.0 << 10.0 << 1 << 7;
}

void TestErrorBands::holdARange()
{
    QFETCH(const double, least_mm);
    QFETCH(const double, most_mm);
    QFETCH(const double, width_mm);
    QFETCH(const int, first);
    QFETCH(const int, count);
    const ErrorBands bands = bandsOver({millimetres(least_mm), millimetres(most_mm)});
    QVERIFY(std::abs(inMillimetres(bands.width) - width_mm) < 1e-9);
    QCOMPARE(bands.first, first);
    QCOMPARE(bands.count, count);
    QVERIFY(std::abs(inMillimetres(bands.edge(1)) - (first + 1) * width_mm) < 1e-9);
}

void TestErrorBands::holdAnyRange()
{
    constexpr double kRounding_mm = 1e-9;
    for (int least = 0; least < 60; ++least)
        for (int span = 0; span < 400; ++span) {
            const ErrorRange range{millimetres(0.07 * least),
                                   millimetres(0.07 * least + 0.05 * span)};
            const ErrorBands bands = bandsOver(range);
            QVERIFY(bands.count >= 1 && bands.count <= kMostErrorBands);
            QVERIFY(inMillimetres(bands.edge(0)) <= inMillimetres(range.least) + kRounding_mm);
            QVERIFY(inMillimetres(bands.edge(bands.count))
                    >= inMillimetres(range.most) - kRounding_mm);
            QVERIFY(inMillimetres(range.least) < inMillimetres(bands.edge(1)) + kRounding_mm);
        }
}

/// So the order holds however a copier or a printer weighs red, green and blue.
void TestErrorBands::growDarkerInEveryChannel()
{
    for (int count = 2; count <= kMostErrorBands; ++count)
        for (int band = 1; band < count; ++band) {
            const QColor lighter = bandColor(band - 1, count);
            const QColor darker = bandColor(band, count);
            QVERIFY(darker.red() < lighter.red());
            QVERIFY(darker.green() < lighter.green());
            QVERIFY(darker.blue() < lighter.blue());
        }
}

void TestErrorBands::areAsFarApartInLightness()
{
    for (int count = 2; count <= kMostErrorBands; ++count) {
        const double mean =
            (lightness(bandColor(0, count)) - lightness(bandColor(count - 1, count))) / (count - 1);
        QVERIFY(mean > kClearStep);
        for (int band = 1; band < count; ++band) {
            const double step =
                lightness(bandColor(band - 1, count)) - lightness(bandColor(band, count));
            QVERIFY(std::abs(step - mean) < kAlike * mean);
        }
    }
}

void TestErrorBands::areToldApartByColourBlindPeople()
{
    for (const test::Sight& sight : test::kSights)
        for (int a = 0; a < kMostErrorBands; ++a)
            for (int b = 0; b < a; ++b)
                QVERIFY2(
                    test::apart(bandColor(a, kMostErrorBands), bandColor(b, kMostErrorBands), sight)
                        > kClearStep,
                    sight.name);
}

void TestErrorBands::drawLinesThatStandOut()
{
    for (int count = 3; count <= kMostErrorBands; ++count)
        for (int band = 1; band < count; ++band)
            for (const int beside : {band - 1, band})
                QVERIFY(std::abs(lightness(isolineColor(band, count))
                                 - lightness(bandColor(beside, count)))
                        > 2.0 * kClearStep);
}

CARINA_TEST(TestErrorBands)

} // namespace carina::error_bands_test

#include "tst_error_bands.moc"
