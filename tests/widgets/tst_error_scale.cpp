#include "tests/support/test_class.h"
#include "widgets/error_scale.h"

#include <QImage>

#include <memory>

namespace carina::error_scale_test
{
namespace
{

constexpr double kPixel = 1e-6; ///< rounding, pixels
const ErrorBands kHalves{millimetres(0.5), 1, 6};
const ErrorRange kRange{millimetres(0.83), millimetres(3.14)};

std::unique_ptr<ErrorScale> scaleOf(const ErrorBands& bands, const QSize& size = {400, 90})
{
    auto scale = std::make_unique<ErrorScale>();
    scale->resize(size);
    scale->setScale(bands, kRange);
    return scale;
}

QStringList textsOf(const ErrorScale& scale)
{
    QStringList texts;
    const ErrorScale::Drawing drawn = scale.drawing().value();
    for (const ErrorScale::Drawing::Number& number : drawn.numbers)
        texts += number.text;
    return texts;
}

} // namespace

class TestErrorScale : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sharesItsWidthAmongTheBands();
    void hasNumbersWhereBandsMeet_data();
    void hasNumbersWhereBandsMeet();
    void keepsNumbersApart_data();
    void keepsNumbersApart();
    void isDrawnInTheColoursOfTheBands();
    void saysTheRangeInWords();
    void isEmptyWithoutAMap();
    void isReachedByTab();
};

void TestErrorScale::sharesItsWidthAmongTheBands()
{
    const ErrorScale::Drawing drawn = scaleOf(kHalves)->drawing().value();
    QCOMPARE(drawn.bands.size(), std::size_t{6});
    QVERIFY(drawn.strip.width() > 200.0);
    for (std::size_t k = 0; k < drawn.bands.size(); ++k) {
        QVERIFY(std::abs(drawn.bands[k].width() - drawn.strip.width() / 6.0) < kPixel);
        QVERIFY(std::abs(drawn.bands[k].left() - drawn.strip.left()
                         - double(k) * drawn.strip.width() / 6.0)
                < kPixel);
        QCOMPARE(drawn.bands[k].height(), drawn.strip.height());
    }
}

void TestErrorScale::hasNumbersWhereBandsMeet_data()
{
    QTest::addColumn<double>("width_mm");
    QTest::addColumn<int>("first");
    QTest::addColumn<int>("count");
    QTest::addColumn<QString>("texts");
    QTest::newRow("tenths") << 0.1 << 3 << 3 << QStringLiteral("0.3 mm, 0.4 mm, 0.5 mm, 0.6 mm");
    QTest::newRow("halves") << 0.5 << 1 << 4
                            << QStringLiteral("0.5 mm, 1.0 mm, 1.5 mm, 2.0 mm, 2.5 mm");
    QTest::newRow("whole ones") << 1.0 << 0 << 3 << QStringLiteral("0 mm, 1 mm, 2 mm, 3 mm");
    QTest::newRow("tens") << 10.0 << 9 << 2 << QStringLiteral("90 mm, 100 mm, 110 mm");
}

void TestErrorScale::hasNumbersWhereBandsMeet()
{
    QFETCH(const double, width_mm);
    QFETCH(const int, first);
    QFETCH(const int, count);
    QFETCH(const QString, texts);
    const auto scale = scaleOf({millimetres(width_mm), first, count}, {600, 90});
    QCOMPARE(textsOf(*scale).join(QStringLiteral(", ")).replace(QChar::Nbsp, QLatin1Char{' '}),
             texts);
    const ErrorScale::Drawing drawn = scale->drawing().value();
    for (std::size_t k = 0; k < drawn.bands.size(); ++k)
        QVERIFY(std::abs(drawn.numbers[k].x - drawn.bands[k].left()) < kPixel);
    QVERIFY(std::abs(drawn.numbers.back().x - drawn.strip.right()) < kPixel);
    for (const ErrorScale::Drawing::Number& number : drawn.numbers)
        QVERIFY(std::abs(number.words.center().x() - number.x) < kPixel);
}

void TestErrorScale::keepsNumbersApart_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("wide") << QSize{600, 90};
    QTest::newRow("as it asks for") << ErrorScale{}.sizeHint();
    QTest::newRow("as small as it may be") << ErrorScale{}.minimumSizeHint();
}

void TestErrorScale::keepsNumbersApart()
{
    QFETCH(const QSize, size);
    const auto scale = scaleOf({millimetres(10.0), 9, kMostErrorBands}, size);
    const ErrorScale::Drawing drawn = scale->drawing().value();
    QVERIFY(drawn.numbers.size() >= 3);
    QVERIFY(drawn.strip.height() >= 10.0);
    for (std::size_t i = 0; i < drawn.numbers.size(); ++i) {
        QVERIFY(QRectF{scale->rect()}.contains(drawn.numbers[i].words));
        QVERIFY(!drawn.numbers[i].words.intersects(drawn.strip));
        QVERIFY(i == 0 || !drawn.numbers[i].words.intersects(drawn.numbers[i - 1].words));
        QVERIFY(scale->fontMetrics().horizontalAdvance(drawn.numbers[i].text)
                <= drawn.numbers[i].words.width());
    }
    QVERIFY(scale->fontMetrics().horizontalAdvance(drawn.caption) <= size.width());
}

void TestErrorScale::isDrawnInTheColoursOfTheBands()
{
    const auto scale = scaleOf(kHalves);
    const QImage image = scale->grab().toImage();
    const std::vector<QRectF> bands = scale->drawing().value().bands;
    for (std::size_t k = 0; k < bands.size(); ++k)
        QCOMPARE(image.pixelColor(bands[k].center().toPoint()), bandColor(int(k), 6));
}

void TestErrorScale::saysTheRangeInWords()
{
    const auto scale = scaleOf(kHalves);
    QCOMPARE(scale->drawing().value().caption,
             QStringLiteral("Expected error (RMS): 0.8 to 3.1 mm"));
    QCOMPARE(scale->accessibleName(), QStringLiteral("Scale of the expected error"));
    QCOMPARE(scale->accessibleDescription(),
             QStringLiteral("From 0.8 mm to 3.1 mm; the darker, the larger."));
}

void TestErrorScale::isEmptyWithoutAMap()
{
    ErrorScale fresh;
    fresh.resize(400, 90);
    QVERIFY(!fresh.drawing());
    const QImage blank = fresh.grab().toImage();
    const auto scale = scaleOf(kHalves);
    QVERIFY(scale->grab().toImage() != blank);
}

void TestErrorScale::isReachedByTab() { QCOMPARE(ErrorScale{}.focusPolicy(), Qt::TabFocus); }

CARINA_SCREEN_TEST(TestErrorScale)

} // namespace carina::error_scale_test

#include "tst_error_scale.moc"
