#include "tests/support/test_class.h"
#include "widgets/residual_bar.h"

#include <QImage>
#include <QPainter>
#include <QStandardItemModel>

namespace carina::residual_bar_test
{

class TestResidualBar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isAsLongAsItsNumber_data();
    void isAsLongAsItsNumber();
    void keepsBarAndWordsApart_data();
    void keepsBarAndWordsApart();
    void saysTheNumberWithItsUnit();
    void takesItsColoursFromThePalette();
    void leavesCellsWithoutANumberAsTheyAre();
};

namespace
{

constexpr double kFullScale = 4.0;

QStyleOptionViewItem cell(int width)
{
    QStyleOptionViewItem option;
    option.rect = {10, 20, width, 30};
    return option;
}

/// A cell as it is painted, on a white ground, with black words and a red highlight.
QImage painted(const ResidualBar& bars, const QVariant& value)
{
    QStandardItemModel model{1, 1};
    model.setData(model.index(0, 0), QStringLiteral("–"));
    model.setData(model.index(0, 0), value, ResidualBar::kValueRole);
    QImage image{220, 60, QImage::Format_RGB32};
    image.fill(Qt::white);
    QPainter painter{&image};
    QStyleOptionViewItem option = cell(200);
    option.palette.setColor(QPalette::Text, Qt::black);
    option.palette.setColor(QPalette::Highlight, Qt::red);
    option.state = QStyle::State_Enabled;
    bars.paint(&painter, option, model.index(0, 0));
    return image;
}

int redPixels(const QImage& image)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, y) == QColor{Qt::red} ? 1 : 0;
    return count;
}

} // namespace

void TestResidualBar::isAsLongAsItsNumber_data()
{
    QTest::addColumn<double>("value");
    QTest::addColumn<double>("share"); // of the frame
    QTest::newRow("nothing") << 0.0 << 0.0;
    QTest::newRow("a quarter") << 1.0 << 0.25;
    QTest::newRow("all") << kFullScale << 1.0;
    QTest::newRow("more than all") << 9.0 << 1.0;
}

void TestResidualBar::isAsLongAsItsNumber()
{
    QFETCH(const double, value);
    QFETCH(const double, share);
    ResidualBar bars{QStringLiteral("mm")};
    bars.setFullScale(kFullScale);
    const ResidualBar::Bar bar = bars.bar(cell(300), value);
    QVERIFY(bar.frame.width() > 100);
    QCOMPARE(bar.filled.width(), qRound(share * bar.frame.width()));
    QCOMPARE(bar.filled.topLeft(), bar.frame.topLeft());
    QCOMPARE(bar.filled.height(), bar.frame.height());
}

void TestResidualBar::keepsBarAndWordsApart_data()
{
    QTest::addColumn<int>("width");
    QTest::newRow("wide") << 300;
    QTest::newRow("as wide as it asks for")
        << ResidualBar{QStringLiteral("mm")}.sizeHint(cell(0), {}).width();
    QTest::newRow("too narrow") << 20;
}

void TestResidualBar::keepsBarAndWordsApart()
{
    QFETCH(const int, width);
    const QStyleOptionViewItem option = cell(width);
    const ResidualBar::Bar bar = ResidualBar{QStringLiteral("mm")}.bar(option, 88.8);
    QVERIFY(!bar.frame.intersects(bar.words));
    QVERIFY(bar.frame.isEmpty() || option.rect.contains(bar.frame));
    QVERIFY(option.rect.contains(bar.words));
    if (!bar.frame.isEmpty())
        QVERIFY(option.fontMetrics.horizontalAdvance(bar.text) <= bar.words.width());
}

void TestResidualBar::saysTheNumberWithItsUnit()
{
    const ResidualBar bars{QStringLiteral("mm")};
    QCOMPARE(bars.bar(cell(300), 0.26).text, QStringLiteral("0.3 mm"));
    QCOMPARE(bars.bar(cell(300), 12.0).text, QStringLiteral("12.0 mm"));
}

void TestResidualBar::takesItsColoursFromThePalette()
{
    ResidualBar bars{QStringLiteral("mm")};
    bars.setFullScale(kFullScale);
    const QRect filled = bars.bar(cell(200), 2.0).filled;
    const QRect inside = filled.adjusted(1, 1, 0, -1); // less its frame
    QCOMPARE(redPixels(painted(bars, 2.0)), inside.width() * inside.height());
    QCOMPARE(redPixels(painted(bars, 0.0)), 0);
}

void TestResidualBar::leavesCellsWithoutANumberAsTheyAre()
{
    const ResidualBar bars{QStringLiteral("mm")};
    const QImage image = painted(bars, {});
    QCOMPARE(redPixels(image), 0);
    QImage white = image;
    white.fill(Qt::white);
    QVERIFY(image != white); // the words are there
}

CARINA_SCREEN_TEST(TestResidualBar)

} // namespace carina::residual_bar_test

#include "tst_residual_bar.moc"
